#include "scan/picture_size.h"

#include <fstream>
#include <string>

#include "base/error.h"

namespace gnathion {
namespace {

/// Bytes of a file, asked for one number at a time; past the end there is nothing.
class Bytes {
 public:
  explicit Bytes(const std::filesystem::path& file) : stream_(file, std::ios::binary) {}

  std::optional<std::uint64_t> number(std::uint64_t at, int size, bool big) {
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(at));
    std::string bytes(static_cast<std::size_t>(size), '\0');
    if (!stream_.read(bytes.data(), size)) return {};
    std::uint64_t value = 0;
    for (int i = 0; i < size; ++i) {
      value = value << 8U | static_cast<unsigned char>(bytes[big ? i : size - 1 - i]);
    }
    return value;
  }
  std::optional<PictureSize> pair(std::uint64_t width, std::uint64_t height, int size, bool big) {
    const auto w = number(width, size, big), h = number(height, size, big);
    if (!w || !h) return {};
    return PictureSize{*w, *h};
  }

 private:
  std::ifstream stream_;
};

/// ISO 10918-1, B.2.2: the frame header behind any other segments.
std::optional<PictureSize> jpeg_size(Bytes& bytes) {
  std::uint64_t at = 2;
  for (int segment = 0; segment < 1000; ++segment) {
    const auto marker = bytes.number(at, 2, true), length = bytes.number(at + 2, 2, true);
    if (!marker || !length || *marker < 0xff00) return {};
    const std::uint64_t kind = *marker & 0xffU;
    const bool frame = kind >= 0xc0 && kind <= 0xcf && kind != 0xc4 && kind != 0xc8 && kind != 0xcc;
    if (frame) return bytes.pair(at + 7, at + 5, 2, true);
    at += 2 + *length;
  }
  return {};
}

/// TIFF 6.0, section 2: tags 256 and 257 of the first directory.
std::optional<PictureSize> tiff_size(Bytes& bytes, bool big) {
  const auto directory = bytes.number(4, 4, big);
  const auto count = directory ? bytes.number(*directory, 2, big) : std::nullopt;
  if (!count) return {};
  PictureSize size;
  for (std::uint64_t i = 0; i < *count; ++i) {
    const std::uint64_t at = *directory + 2 + 12 * i;
    const auto tag = bytes.number(at, 2, big), kind = bytes.number(at + 2, 2, big);
    if (!tag || !kind) return {};
    const auto value = bytes.number(at + 8, *kind == 3 ? 2 : 4, big);  // a SHORT or a LONG
    if (!value) return {};
    if (*tag == 256) size.width = *value;
    if (*tag == 257) size.height = *value;
  }
  return size;
}

}  // namespace

std::optional<PictureSize> picture_size(const std::filesystem::path& file) {
  Bytes bytes(file);
  const auto magic = bytes.number(0, 4, true);
  if (!magic) return {};
  if (*magic == 0x89504e47) return bytes.pair(16, 20, 4, true);
  if (*magic >> 8U == 0xffd8ff) return jpeg_size(bytes);
  if (*magic == 0x49492a00) return tiff_size(bytes, false);
  if (*magic == 0x4d4d002a) return tiff_size(bytes, true);
  if (*magic >> 16U != 0x424d) return {};
  const auto size = bytes.pair(18, 22, 4, false);  // BMP; one stored from above has −height
  if (!size || size->height < 0x80000000U) return size;
  return PictureSize{size->width, 0x100000000U - size->height};
}

void check_picture_size(const std::filesystem::path& file) {
  constexpr std::uint64_t kMost = 20'000;
  const auto size = picture_size(file);
  if (!size || size->width == 0 || size->height <= kMost * kMost / size->width) return;
  throw Error(ErrorKind::input, file.string(),
              "the picture says that it is " + std::to_string(size->width) + " x " +
                  std::to_string(size->height) + " pixels large",
              "make it smaller in an image program, 8192 x 8192 at most");
}

}  // namespace gnathion
