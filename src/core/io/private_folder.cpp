#include "io/private_folder.h"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include "base/error.h"

namespace gnathion {

namespace fs = std::filesystem;

PrivateFolder::PrivateFolder() {
  std::error_code failure;
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");
  for (const fs::path& at :
       {fs::path(runtime == nullptr ? "" : runtime), fs::temp_directory_path(failure)}) {
    if (at.empty()) continue;
    std::string name = (at / "gnathion-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) continue;
    path_ = name;
    return;
  }
  throw Error(ErrorKind::output, "the folder for temporary files",
              "no folder can be made there (" + std::generic_category().message(errno) + ")",
              "make room there, or set TMPDIR to a place that you may write to");
}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace gnathion
