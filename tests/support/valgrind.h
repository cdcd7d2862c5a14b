#pragma once

#include <cstdlib>

namespace seaway::test {

/// Whether valgrind can count the instructions of a program of this build: it is installed, and no
/// sanitizer has taken the program's memory for itself.
inline bool valgrindCanCount() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return false;
#else
  return std::system("valgrind --version > /dev/null 2>&1") == 0;
#endif
}

}  // namespace seaway::test
