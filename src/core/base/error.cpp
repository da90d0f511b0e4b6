#include "base/error.h"

#include <utility>

namespace gnathion {

Error::Error(ErrorKind kind, std::string subject, std::string problem, std::string remedy)
    : std::runtime_error(subject + ": " + problem + "; " + remedy),
      kind_(kind),
      subject_(std::move(subject)),
      problem_(std::move(problem)),
      remedy_(std::move(remedy)) {}

}  // namespace gnathion
