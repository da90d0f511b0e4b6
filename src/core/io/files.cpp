#include "io/files.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <memory>
#include <system_error>
#include <utility>
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

namespace {

/// A new hidden file that takes another's place; until then it goes with the object.
class Replacement {
 public:
  explicit Replacement(fs::path target) : target_(std::move(target)) {
    const std::string name =
        "." + target_.filename().string() + ".partial-" + std::to_string(getpid());
    // The name must be new: a killed program of the same number may have left its file behind.
    for (int attempt = 0; file_ < 0 && (attempt == 0 || errno == EEXIST); ++attempt) {
      partial_ = target_.parent_path() / (name + "-" + std::to_string(attempt));
      file_ = ::open(partial_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    }
    if (file_ < 0) fail();
    struct stat old {};
    if (::stat(target_.c_str(), &old) == 0) ::fchmod(file_, old.st_mode & 07777U);
  }
  ~Replacement() {
    if (file_ >= 0) ::close(file_);
    if (!done_) ::unlink(partial_.c_str());
  }
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;

  void write(const std::string& text) {
    for (std::size_t written = 0; written < text.size();) {
      const ssize_t count = ::write(file_, text.data() + written, text.size() - written);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) fail();
      written += static_cast<std::size_t>(count);
    }
  }

  void take_place() {
    if (::fsync(file_) != 0) fail();
    const int file = std::exchange(file_, -1);
    if (::close(file) != 0 || ::rename(partial_.c_str(), target_.c_str()) != 0) fail();
    done_ = true;
    // The new name is safe once its folder is on the disk; where that cannot be asked for, so be
    // it.
    const int folder = ::open(target_.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return;
    ::fsync(folder);
    ::close(folder);
  }

 private:
  /// With the system's reason.
  [[noreturn]] void fail() {
    const std::string reason = std::generic_category().message(errno);
    throw Error(ErrorKind::output, target_.string(),
                "it cannot be written (" + reason + "); what was there is unchanged",
                "check free space and rights, or choose another place");
  }

  fs::path target_, partial_;
  int file_ = -1;
  bool done_ = false;
};

}  // namespace

void replace_text_file(const fs::path& path, const std::string& text) {
  std::error_code none;  // a name that leads nowhere fails below, with its reason
  const bool is_link = fs::is_symlink(path, none);
  const fs::path file = is_link ? fs::canonical(path, none) : fs::absolute(path);
  Replacement replacement(file.empty() ? fs::absolute(path) : file);
  replacement.write(text);
  replacement.take_place();
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
