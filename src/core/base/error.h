#pragma once

#include <stdexcept>
#include <string>

namespace gnathion {

/// What went wrong, as the caller of a program needs to know it. The value is the exit code
/// of gnathion-cli.
enum class ErrorKind {
  usage = 2,      ///< the command line
  case_file = 3,  ///< a key or value of the case file
  input = 4,      ///< a file or folder that the user gave
  anatomy = 5,  ///< the input is readable, but no plan can be made of it (empty segment, no rim…)
  numeric = 6,  ///< the equations could not be solved to the stated accuracy
  output = 7,   ///< the result could not be written
  cancelled = 8,  ///< the user stopped the work
};

/// An error that a user can cause. `subject` names the file or key, `problem` what is wrong
/// with it, `remedy` what to do. what() is "subject: problem; remedy", one line.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, std::string subject, std::string problem, std::string remedy);

  ErrorKind kind() const { return kind_; }
  const std::string& subject() const { return subject_; }
  const std::string& problem() const { return problem_; }
  const std::string& remedy() const { return remedy_; }

 private:
  ErrorKind kind_;
  std::string subject_;
  std::string problem_;
  std::string remedy_;
};

}  // namespace gnathion
