#include "io/files.h"

#include <openssl/evp.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <vector>

#include "base/error.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

/// SHA-256 through OpenSSL.
class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr);
  }
  void add(const char* data, std::size_t size) { EVP_DigestUpdate(context_.get(), data, size); }
  std::string hex() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned size = 0;
    EVP_DigestFinal_ex(context_.get(), digest.data(), &size);
    std::string text;
    for (unsigned i = 0; i < size; ++i) {
      text += "0123456789abcdef"[digest[i] >> 4U];
      text += "0123456789abcdef"[digest[i] & 15U];
    }
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

std::string sha256_of_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw Error(ErrorKind::input, path.string(), "the file cannot be opened",
                "check its name and rights");
  }
  Sha256 hash;
  std::vector<char> block(1U << 20U);
  do {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    hash.add(block.data(), static_cast<std::size_t>(stream.gcount()));
  } while (stream);
  return hash.hex();
}

}  // namespace

std::string read_text_file(const fs::path& path) {
  std::error_code failure;
  const auto size = fs::file_size(path, failure);
  if (failure) {
    throw Error(ErrorKind::input, path.string(), failure.message(),
                "check the file's name and rights");
  }
  constexpr std::uintmax_t kLargest = 2ULL << 30U;
  if (size == 0 || size > kLargest) {
    throw Error(ErrorKind::input, path.string(),
                size == 0 ? "the file is empty" : "the file is larger than 2 GiB",
                "choose another file");
  }
  std::ifstream stream(path, std::ios::binary);
  std::string text(size, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(size));
  if (!stream) {
    throw Error(ErrorKind::input, path.string(), "the file cannot be read to its end",
                "check the disk and the file's rights");
  }
  return text;
}

void write_text_file(const fs::path& path, const std::string& text) {
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  if (!stream.flush()) {
    throw Error(ErrorKind::output, path.string(), "it cannot be written",
                "check free space and rights, or choose another place");
  }
}

std::string sha256_of(const fs::path& path) {
  if (!fs::is_directory(path)) return sha256_of_file(path);
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(path)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  Sha256 hash;
  for (const fs::path& file : files) {
    const std::string line =
        sha256_of_file(file) + "  " + file.lexically_relative(path).generic_string() + "\n";
    hash.add(line.data(), line.size());
  }
  return hash.hex();
}

NewFolder::NewFolder(const fs::path& target) {
  if (target.empty()) {
    throw Error(ErrorKind::output, "the new folder", "it has no name", "name a new folder");
  }
  target_ = fs::absolute(target).lexically_normal();
  if (!target_.has_filename()) target_ = target_.parent_path();
  std::error_code failure;  // of a name that cannot even be looked up: making the folder says why
  if (fs::exists(fs::symlink_status(target_, failure))) {
    throw Error(ErrorKind::output, target_.string(),
                "it exists already, and nothing is overwritten", "name a new folder");
  }
  // The name must be new: a killed program of the same number may have left its folder behind.
  const std::string name =
      "." + target_.filename().string() + ".partial-" + std::to_string(getpid());
  failure.clear();
  bool made = false;
  for (int attempt = 0; !made && !failure; ++attempt) {
    partial_ = target_.parent_path() / (name + (attempt == 0 ? "" : "-" + std::to_string(attempt)));
    made = fs::create_directory(partial_, failure);
  }
  if (failure) {
    throw Error(ErrorKind::output, target_.parent_path().string(),
                "no folder can be made here (" + failure.message() + ")",
                "choose an existing place that you may write to");
  }
}

NewFolder::~NewFolder() {
  std::error_code ignored;
  if (!published_) fs::remove_all(partial_, ignored);
}

void NewFolder::publish() {
  std::error_code failure;
  if (fs::exists(fs::symlink_status(target_, failure))) {
    failure = std::make_error_code(std::errc::file_exists);
  } else {
    fs::rename(partial_, target_, failure);
  }
  if (failure) {
    throw Error(ErrorKind::output, target_.string(), failure.message(), "name a new folder");
  }
  published_ = true;
}

}  // namespace gnathion
