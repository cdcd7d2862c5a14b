#pragma once

#include <stdexcept>
#include <string>

namespace seaway {

/// A fault in what the user gave: a file, a key, a value, an argument.
///
/// The message is complete as it stands: it names file, line and key where there are any, the
/// offending value, and what is allowed. The command prints it and exits with status 2. Faults of
/// the program itself are never reported with this type.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;

  /// "`file`:`line`: `what`"; a line of 0 is left out.
  InputError(const std::string& file, int line, const std::string& what)
      : std::runtime_error(file + (line > 0 ? ":" + std::to_string(line) : "") + ": " + what) {}
};

}  // namespace seaway
