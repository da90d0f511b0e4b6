#include "render/movie_file.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/error.h"

namespace gnathion {
namespace {

constexpr int jpeg_quality = 92;
constexpr std::uint32_t most_bytes = 2000000000;
constexpr std::uint32_t has_index = 0x10;  // of the file's flags
constexpr std::uint32_t key_frame = 0x10;  // of a picture's flags

/// Little-endian numbers and names of four letters, as RIFF has them.
class Bytes {
 public:
  Bytes& name(const char* four) {
    text_.append(four, 4);
    return *this;
  }
  Bytes& u32(std::uint32_t value) { return number(value, 4); }
  Bytes& u16(std::uint32_t value) { return number(value, 2); }
  const std::string& text() const { return text_; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(text_.size()); }

 private:
  Bytes& number(std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) text_ += static_cast<char>((value >> (8 * i)) & 0xffU);
    return *this;
  }
  std::string text_;
};

struct Shape {
  std::uint32_t width, height, rate;
};

/// The lists before the pictures (Microsoft, "AVI RIFF File Reference"), always equally long.
Bytes head(const Shape& shape, std::uint32_t frames, std::uint32_t largest, std::uint32_t pictures,
           std::uint32_t index) {
  constexpr std::uint32_t header_list = 4 + 8 + 56 + 12 + 8 + 56 + 8 + 40;
  Bytes bytes;
  bytes.name("RIFF").u32(4 + 8 + header_list + 8 + 4 + pictures + 8 + index).name("AVI ");
  bytes.name("LIST").u32(header_list).name("hdrl");
  bytes.name("avih").u32(56).u32(1000000 / shape.rate).u32(largest * shape.rate).u32(0);
  bytes.u32(has_index).u32(frames).u32(0).u32(1).u32(largest).u32(shape.width).u32(shape.height);
  for (int reserved = 0; reserved < 4; ++reserved) bytes.u32(0);
  bytes.name("LIST").u32(4 + 8 + 56 + 8 + 40).name("strl");
  bytes.name("strh").u32(56).name("vids").name("MJPG").u32(0).u32(0).u32(0);
  bytes.u32(1).u32(shape.rate).u32(0).u32(frames).u32(largest).u32(0xffffffffU).u32(0);
  bytes.u16(0).u16(0).u16(shape.width).u16(shape.height);
  bytes.name("strf").u32(40).u32(40).u32(shape.width).u32(shape.height).u16(1).u16(24);
  bytes.name("MJPG").u32(3 * shape.width * shape.height).u32(0).u32(0).u32(0).u32(0);
  bytes.name("LIST").u32(4 + pictures).name("movi");
  return bytes;
}

[[noreturn]] void refuse(const std::filesystem::path& path) {
  throw Error(ErrorKind::output, path.string(), "the film cannot be written",
              "choose a folder that exists and may be written, and see that the disk is not full");
}

}  // namespace

struct MovieFile::Impl {
  std::filesystem::path path, partial;
  Shape shape;
  std::ofstream file;
  Bytes index;
  std::uint32_t frames = 0, largest = 0, pictures = 0;  ///< bytes of the largest, of all
};

MovieFile::MovieFile(const std::filesystem::path& path, int width, int height,
                     int frames_per_second)
    : impl_(std::make_unique<Impl>()) {
  impl_->path = path;
  impl_->partial = path;
  impl_->partial += ".part";
  impl_->shape = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height),
                  static_cast<std::uint32_t>(frames_per_second)};
  impl_->file.open(impl_->partial, std::ios::binary | std::ios::trunc);
  impl_->file << head(impl_->shape, 0, 0, 0, 0).text();
  if (!impl_->file) refuse(path);
}

MovieFile::~MovieFile() {
  impl_->file.close();
  std::error_code none;
  std::filesystem::remove(impl_->partial, none);
}

void MovieFile::add(const Picture& picture) {
  const Shape& shape = impl_->shape;
  if (picture.width != static_cast<int>(shape.width) ||
      picture.height != static_cast<int>(shape.height)) {
    throw std::invalid_argument("MovieFile: a picture of another size");
  }
  const cv::Mat rgb(picture.height, picture.width, CV_8UC3,
                    const_cast<std::uint8_t*>(picture.rgb.data()));
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  std::vector<std::uint8_t> jpeg;
  cv::imencode(".jpg", bgr, jpeg, {cv::IMWRITE_JPEG_QUALITY, jpeg_quality});
  if (jpeg.size() % 2 == 1) jpeg.push_back(0);
  const auto size = static_cast<std::uint32_t>(jpeg.size());
  if (impl_->pictures + size > most_bytes) {
    throw Error(ErrorKind::output, impl_->path.string(), "the film grows beyond 2 GB",
                "ask for smaller or fewer pictures, or for a folder of pictures");
  }
  impl_->index.name("00dc").u32(key_frame).u32(4 + impl_->pictures).u32(size);
  impl_->file << Bytes().name("00dc").u32(size).text();
  impl_->file.write(reinterpret_cast<const char*>(jpeg.data()), size);
  if (!impl_->file) refuse(impl_->path);
  ++impl_->frames;
  impl_->largest = std::max(impl_->largest, size);
  impl_->pictures += 8 + size;
}

void MovieFile::finish() {
  impl_->file << Bytes().name("idx1").u32(impl_->index.size()).text() << impl_->index.text();
  impl_->file.seekp(0);
  impl_->file << head(impl_->shape, impl_->frames, impl_->largest, impl_->pictures,
                      impl_->index.size())
                     .text();
  impl_->file.close();
  std::error_code failed;
  if (impl_->file) std::filesystem::rename(impl_->partial, impl_->path, failed);
  if (!impl_->file || failed) refuse(impl_->path);
}

}  // namespace gnathion
