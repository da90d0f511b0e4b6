// gnathion-scan-reader FILE MEMORY_BYTES SECONDS
// Reads one face scan for the application and writes it to standard output (scan_stream.h). The
// file may come from a stranger and assimp is known to write outside its memory, so this is a
// program of its own, with as little as possible within reach: what a file breaks is this.
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>
#include <csignal>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <exception>
#include <new>

#include "base/error.h"
#include "scan_reader/reading.h"

namespace {

using namespace gnathion;

rlim_t number(const char* word) {
  unsigned long long value = 0;
  std::from_chars(word, word + std::strlen(word), value);
  return value;
}

void limit(__rlimit_resource_t what, rlim_t most) {
  const rlimit both{most, most};
  if (setrlimit(what, &both) != 0) _exit(3);
}

/// What this process may still do: read files, and write to what is open.
void confine(rlim_t memory, rlim_t seconds) {
  close_range(3, ~0U, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
#ifndef __SANITIZE_ADDRESS__  // whose shadow is larger than any limit
  limit(RLIMIT_AS, memory);
#else
  static_cast<void>(memory);
#endif
  limit(RLIMIT_CPU, seconds);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_NOFILE, 32);
}

bool write_all(const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::write(STDOUT_FILENO, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    done += static_cast<std::size_t>(count);
  }
  return true;
}

std::string read(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return scan_bytes(extension == ".ply" ? read_ply(file) : read_by_assimp(file));
}

std::string read_or_why_not(const char* file) {
  try {
    return read(file);
  } catch (const ScanFailure& failure) {
    return scan_bytes(failure);
  } catch (const std::bad_alloc&) {
    return scan_bytes(ScanFailure{"", "reading it needs more memory than a scan may take",
                                  "reduce it in the scanner's software"});
  } catch (const std::exception& error) {
    return scan_bytes(ScanFailure{"", std::string("it cannot be read: ") + error.what(),
                                  "export the scan again, or in another format"});
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  confine(number(argv[2]), number(argv[3]));
  return write_all(read_or_why_not(argv[1])) ? 0 : 1;
}
