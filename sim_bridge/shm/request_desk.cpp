#include "sim_bridge/shm/request_desk.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <limits>

namespace seaway::bridge::shm {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A copy of what a host may be writing: nothing is read twice.
template <class T>
void copyOnce(T* to, const std::byte* from, std::size_t count) {
  if (count > 0) std::memcpy(to, from, count * sizeof(T));
  std::atomic_signal_fence(std::memory_order_seq_cst);
}

void requireAtLeastZero(const char* what, double value) {
  if (value >= 0.0) return;
  throw Refused(SEAWAY_SHM_BAD_VALUE,
                std::string(what) + " " + std::to_string(value) + " is not allowed; must be >= 0");
}

void requireFlags(std::uint32_t flags, std::uint32_t allowed) {
  if ((flags & ~allowed) == 0) return;
  throw Refused(SEAWAY_SHM_MALFORMED, "flags " + std::to_string(flags) + ": unknown bits");
}

void requireAtMost(std::uint64_t count, std::uint64_t most, const char* what) {
  if (count <= most) return;
  throw Refused(SEAWAY_SHM_TOO_LARGE, std::to_string(count) + " " + what + "; at most " +
                                          std::to_string(most) + " at once");
}

void refuse(seaway_shm_answer& answer, seaway_shm_status status, const std::string& message) {
  answer.status = status;
  write(answer.message, message);
}

}  // namespace

void write(char (&to)[SEAWAY_SHM_TEXT], const std::string& message) {
  const std::size_t length = std::min(message.size(), sizeof to - 1);
  std::copy_n(message.data(), length, to);
  to[length] = 0;
}

double timeOf(const Backing& backing, double asked, std::uint32_t flags) {
  if ((flags & SEAWAY_SHM_SERVERS_TIME) == 0) return asked;
  const auto now = backing.now ? backing.now() : std::nullopt;
  if (!now) throw Refused(SEAWAY_SHM_BAD_VALUE, "the server has no clock; give a time");
  return *now;
}

RequestDesk::RequestDesk(const Backing& backing, const seaway_shm_header& layout)
    : backing_(backing), layout_(layout) {}

void RequestDesk::answer(std::byte* cell, std::uint32_t number, HostSea& sea) noexcept {
  const Clock::time_point start = Clock::now();
  seaway_shm_request request;
  copyOnce(&request, cell, 1);
  seaway_shm_answer answer{};
  answer.number = number;
  answer.status = SEAWAY_SHM_OK;
  std::size_t points = 0;
  try {
    if (request.number != number) {
      throw Refused(SEAWAY_SHM_MALFORMED, "the cell holds another request");
    }
    points = answered(request, cell + layout_.arrays_offset, sea, answer);
  } catch (const Refused& refusal) {
    refuse(answer, refusal.status, refusal.what());
  } catch (const std::exception& fault) {
    refuse(answer, SEAWAY_SHM_FAILED, fault.what());
  }
  std::memcpy(cell + sizeof request, &answer, sizeof answer);
  if (!backing_.observer) return;
  const auto status = static_cast<seaway_shm_status>(answer.status);
  if (status == SEAWAY_SHM_OK) {
    backing_.observer->answered(points, secondsSince(start));
  } else {
    backing_.observer->refused(status);
  }
}

std::size_t RequestDesk::answered(const seaway_shm_request& request, std::byte* arrays,
                                  HostSea& sea, seaway_shm_answer& answer) {
  if (request.kind != SEAWAY_SHM_SAMPLE) requireFlags(request.flags, SEAWAY_SHM_SERVERS_TIME);
  answer.time = timeOf(backing_, request.time, request.flags);
  switch (request.kind) {
    case SEAWAY_SHM_SAMPLE:
      sample(request, answer.time, arrays, sea);
      break;
    case SEAWAY_SHM_DESCRIBE:
      describe(arrays, sea, answer);
      break;
    case SEAWAY_SHM_ADD_HULL:
      answer.hull = sea.addHull(request.vessel);
      break;
    case SEAWAY_SHM_PLACE_HULLS:
      placeHulls(request, answer.time, arrays, sea);
      break;
    case SEAWAY_SHM_REMOVE_HULL:
      sea.removeHull(request.hull);
      break;
    default:
      throw Refused(SEAWAY_SHM_MALFORMED,
                    "requests of kind " + std::to_string(request.kind) + " are not known");
  }
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto span = sea.wakeSpan();
  answer.wakes_from = span ? span->first : none;
  answer.wakes_to = span ? span->second : none;
  return request.kind == SEAWAY_SHM_SAMPLE ? request.count : 0;
}

void RequestDesk::sample(const seaway_shm_request& request, double t, std::byte* arrays,
                         HostSea& sea) {
  requireFlags(request.flags, SEAWAY_SHM_GEODETIC | SEAWAY_SHM_HEIGHT_ONLY |
                                  SEAWAY_SHM_ORBITAL_VELOCITY | SEAWAY_SHM_SERVERS_TIME);
  requireAtMost(request.count, layout_.point_limit, "points");
  requireAtLeastZero("tolerance", request.tolerance);
  requireAtLeastZero("shortest_wavelength", request.shortest_wavelength);
  SampleAsked asked;
  asked.time = t;
  asked.tolerance = request.tolerance;
  asked.shortestWavelength = request.shortest_wavelength;
  asked.geodetic = (request.flags & SEAWAY_SHM_GEODETIC) != 0;
  asked.orbitalVelocity = (request.flags & SEAWAY_SHM_ORBITAL_VELOCITY) != 0;
  asked.derivatives = asked.orbitalVelocity || (request.flags & SEAWAY_SHM_HEIGHT_ONLY) == 0;
  asked.ownHull = request.own_hull;
  if (x_.size() < request.count) {
    x_.resize(layout_.point_limit);
    y_.resize(layout_.point_limit);
  }
  const auto array = [&](std::size_t index) { return arrays + index * layout_.array_stride; };
  const auto doubles = [&](std::size_t index) { return reinterpret_cast<double*>(array(index)); };
  copyOnce(x_.data(), array(SEAWAY_SHM_X), request.count);
  copyOnce(y_.data(), array(SEAWAY_SHM_Y), request.count);
  const SampleArrays out{
      doubles(SEAWAY_SHM_HEIGHT),       doubles(SEAWAY_SHM_SLOPE_EAST),
      doubles(SEAWAY_SHM_SLOPE_NORTH),  doubles(SEAWAY_SHM_VERTICAL_VELOCITY),
      doubles(SEAWAY_SHM_ORBITAL_EAST), doubles(SEAWAY_SHM_ORBITAL_NORTH),
      doubles(SEAWAY_SHM_ORBITAL_UP),   doubles(SEAWAY_SHM_ERROR),
      doubles(SEAWAY_SHM_BOUND),        reinterpret_cast<std::uint32_t*>(array(SEAWAY_SHM_ARRAYS))};
  sea.sample(asked, std::span(x_).first(request.count), std::span(y_).first(request.count), out);
}

void RequestDesk::placeHulls(const seaway_shm_request& request, double t, const std::byte* arrays,
                             HostSea& sea) {
  requireAtMost(request.count, layout_.array_stride / sizeof(seaway_shm_pose), "poses");
  poses_.resize(request.count);
  copyOnce(poses_.data(), arrays, request.count);
  sea.placeHulls(t, poses_);
}

void RequestDesk::describe(std::byte* arrays, const HostSea& sea, seaway_shm_answer& answer) const {
  const std::string text = sea.describe();
  const std::uint64_t room = layout_.cell_size - layout_.arrays_offset;
  if (text.size() > room) throw Refused(SEAWAY_SHM_TOO_LARGE, "the description does not fit");
  std::memcpy(arrays, text.data(), text.size());
  answer.text_size = static_cast<std::uint32_t>(text.size());
}

}  // namespace seaway::bridge::shm
