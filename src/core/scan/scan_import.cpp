#include "scan/scan_import.h"

#include <csignal>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string>
#include <utility>

#include "base/error.h"
#include "io/input_kind.h"
#include "scan/limited_process.h"
#include "scan/picture_size.h"
#include "scan_stream/scan_stream.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

std::string lower_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

fs::path reading_program() {
  const char* given = std::getenv("GNATHION_SCAN_READER");
  if (given != nullptr && *given != '\0') return given;
  std::error_code failure;
  return fs::read_symlink("/proc/self/exe", failure).parent_path() / "gnathion-scan-reader";
}

[[noreturn]] void refuse(const fs::path& path, const std::string& problem,
                         const std::string& remedy) {
  throw Error(ErrorKind::input, path.string(), problem, remedy);
}

/// That it is a file with something in it, before a program is started for it.
void check_file(const fs::path& path) {
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (!fs::exists(status)) {
    refuse(path, "the file does not exist or cannot be reached", "check its name and rights");
  }
  if (!fs::is_regular_file(status)) refuse(path, "it is not a file", "choose a face scan");
  const auto size = fs::file_size(path, failure);
  if (failure) refuse(path, failure.message(), "check the file's name and rights");
  if (size == 0) refuse(path, "the file is empty", "choose another file");
  if (size > (2ULL << 30U)) refuse(path, "the file is larger than 2 GiB", "reduce the scan");
}

const char* const kExportAgain = "export the scan again, reduced or in another format";

/// Of the reading program: no honest format needs a hundred times its file, and a small file that
/// claims to be large is then refused in a moment.
std::uint64_t memory_for(const fs::path& path, const ScanLimits& limits) {
  return std::min<std::uint64_t>(limits.memory_bytes, (1ULL << 30U) + 100 * fs::file_size(path));
}

std::string reading_output(const fs::path& path, Progress& progress, const ScanLimits& limits) {
  ProcessResult result =
      run_limited(reading_program(),
                  {fs::absolute(path).string(), std::to_string(memory_for(path, limits)),
                   std::to_string(limits.time.count() + 1)},
                  limits.time, limits.output_bytes, progress);
  using End = ProcessResult::End;
  const std::string seconds = std::to_string(limits.time.count());
  if (result.end == End::took_too_long || (result.end == End::killed && result.code == SIGXCPU)) {
    refuse(path, "reading it takes more than " + seconds + " seconds", kExportAgain);
  }
  if (result.end == End::said_too_much) {
    refuse(path, "it holds more than a scan of a head can need", kExportAgain);
  }
  if (result.end == End::killed || result.code != 0) {
    refuse(path,
           "reading it failed (" + std::string(result.end == End::killed ? "signal " : "code ") +
               std::to_string(result.code) + "); the file is probably damaged",
           kExportAgain);
  }
  return std::move(result.output);
}

ObjDocument read_by_program(const fs::path& path, Progress& progress, const ScanLimits& limits) {
  const std::string bytes = reading_output(path, progress, limits);
  const auto result = scan_of_bytes(bytes, path.string());
  if (const auto* failure = std::get_if<ScanFailure>(&result)) {
    const std::string named = failure->subject.empty() ? "" : " (" + failure->subject + ")";
    refuse(path, failure->problem + named, failure->remedy);
  }
  const auto& scan = std::get<RawScan>(result);
  for (const std::string& notice : scan.notices) {
    progress.notice(path.filename().string() + ": " + notice);
  }
  return ObjDocument::of_scan(path, scan);
}

}  // namespace

ObjDocument read_scan(const fs::path& path, Progress& progress, const ScanLimits& limits) {
  check_file(path);
  if (!is_scan_name(path)) {
    refuse(path, "its name does not end like a scan's",
           "give OBJ, PLY, STL, GLB, glTF, 3DS, FBX, DAE, OFF or 3MF");
  }
  ObjDocument document = lower_extension(path) == ".obj" ? ObjDocument::read(path)
                                                         : read_by_program(path, progress, limits);
  for (const Material& material : document.mesh().materials) {
    if (!material.texture.empty()) check_picture_size(material.texture);
  }
  return document;
}

}  // namespace gnathion
