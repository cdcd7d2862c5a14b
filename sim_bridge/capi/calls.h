#pragma once

#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <type_traits>

#include "sim_bridge/seaway.h"
#include "surface/input_error.h"

/// What every function of the C interface shares: no exception crosses it, structures are of a
/// known size, faults leave a message.
namespace seaway::bridge::capi {

/// A fault with a status of its own; InputError is for what scenes and files hold.
class CallError : public std::exception {
 public:
  CallError(seaway_status status, std::string message)
      : status_(status), message_(std::move(message)) {}
  seaway_status status() const { return status_; }
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  seaway_status status_;
  std::string message_;
};

/// Keeps the calling thread's message, which seaway_last_error gives. Allocates nothing.
seaway_status failed(seaway_status status, const char* message) noexcept;

/// Throws CallError unless a pointer is there; `what` names it.
inline void require(const void* pointer, const char* what) {
  if (pointer) return;
  throw CallError(SEAWAY_BAD_ARGUMENT, std::string(what) + " is NULL");
}

/// Throws CallError SEAWAY_BAD_ARGUMENT unless `holds`; the message is made only then.
template <class Message>
void requireThat(bool holds, const Message& message) {
  if (holds) return;
  if constexpr (std::is_invocable_v<Message>) {
    throw CallError(SEAWAY_BAD_ARGUMENT, message());
  } else {
    throw CallError(SEAWAY_BAD_ARGUMENT, message);
  }
}

[[noreturn]] void refuseSize(const char* name, std::size_t given, std::size_t known);

/// Throws CallError unless a structure of the caller's is there and of this version's size. Of a
/// later version, that knows of smaller ones, this is the place.
template <class T>
void requireStruct(const T* structure, const char* name) {
  require(structure, name);
  if (structure->struct_size != sizeof(T)) refuseSize(name, structure->struct_size, sizeof(T));
}

/// A caller's options, or the defaults for NULL. Throws CallError.
template <class T>
T optionsOr(const T* given, const T& defaults, const char* name) {
  if (!given) return defaults;
  requireStruct(given, name);
  return *given;
}

/// The first `size` bytes of a structure with its defaults: all that a caller's has room for.
template <class T>
void initialise(T* structure, std::size_t size, T defaults) noexcept {
  if (!structure) return;
  defaults.struct_size = static_cast<std::uint32_t>(size);
  std::memset(static_cast<void*>(structure), 0, size);
  std::memcpy(static_cast<void*>(structure), &defaults, size < sizeof(T) ? size : sizeof(T));
}

/// Runs a call's body and turns what it throws into a status and a message.
template <class Body>
seaway_status guarded(const Body& body) noexcept {
  try {
    body();
    return SEAWAY_OK;
  } catch (const CallError& fault) {
    return failed(fault.status(), fault.what());
  } catch (const InputError& fault) {
    return failed(SEAWAY_BAD_INPUT, fault.what());
  } catch (const std::bad_alloc&) {
    return failed(SEAWAY_OUT_OF_MEMORY, "not enough memory");
  } catch (const std::exception& fault) {
    return failed(SEAWAY_FAILED, fault.what());
  } catch (...) {
    return failed(SEAWAY_FAILED, "an unknown fault");
  }
}

}  // namespace seaway::bridge::capi
