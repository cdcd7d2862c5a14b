#include "sim_bridge/capi/calls.h"

#include <algorithm>
#include <array>

namespace seaway::bridge::capi {
namespace {

// Fixed: a message must be there when memory is not.
thread_local std::array<char, 4096> lastError{};

}  // namespace

seaway_status failed(seaway_status status, const char* message) noexcept {
  std::size_t length = std::min(std::strlen(message), lastError.size() - 1);
  // Never half a character of UTF-8.
  while (message[length] != '\0' && length > 0 && (message[length] & 0xC0) == 0x80) --length;
  std::memcpy(lastError.data(), message, length);
  lastError[length] = '\0';
  return status;
}

void refuseSize(const char* name, std::size_t given, std::size_t known) {
  throw CallError(SEAWAY_BAD_STRUCT, std::string(name) + ".struct_size is " +
                                         std::to_string(given) + "; must be " +
                                         std::to_string(known) + ", as seaway_..._default sets it");
}

}  // namespace seaway::bridge::capi

extern "C" {

const char* seaway_version(void) { return SEAWAY_VERSION; }

const char* seaway_status_name(int status) {
  switch (status) {
    case SEAWAY_OK:
      return "ok";
    case SEAWAY_BAD_ARGUMENT:
      return "bad argument";
    case SEAWAY_BAD_STRUCT:
      return "bad struct size";
    case SEAWAY_BAD_INPUT:
      return "bad input";
    case SEAWAY_NOT_FOUND:
      return "not found";
    case SEAWAY_BUFFER_TOO_SMALL:
      return "buffer too small";
    case SEAWAY_OUT_OF_MEMORY:
      return "out of memory";
    case SEAWAY_FAILED:
      return "failed";
  }
  return "unknown status";
}

const char* seaway_last_error(void) { return seaway::bridge::capi::lastError.data(); }

}  // extern "C"
