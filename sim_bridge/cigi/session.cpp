#include "sim_bridge/cigi/session.h"

#include <cmath>
#include <utility>

namespace seaway::bridge::cigi {
namespace {

constexpr std::uint8_t maritime = 1;

/// Tens of µs modulo 2³².
std::uint32_t ticksOf(double time) {
  constexpr double wrap = 4294967296.0;
  const double ticks = std::fmod(std::round(time * 1e5), wrap);
  if (!std::isfinite(ticks)) return 0;
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(ticks < 0.0 ? ticks + wrap : ticks));
}

bool isGlobal(std::uint8_t scope) { return scope == static_cast<std::uint8_t>(Scope::global); }

template <class... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};
template <class... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

}  // namespace

CigiSession::CigiSession(SessionOptions options, Water& water, Counts& counts)
    : options_(std::move(options)),
      water_(water),
      counts_(counts),
      requests_(options_.mostRequests),
      waterLevel_(options_.waterLevel),
      temperature_(options_.temperature),
      clarity_(options_.clarity),
      out_(options_.largestDatagram),
      again_(options_.largestDatagram),
      nothing_(options_.largestDatagram) {}

void CigiSession::fault(Count which, const std::string& what) {
  if (counts_.add(which)) options_.warn(what);
}

CigiSession::Output CigiSession::receive(Bytes datagram, double now) {
  counts_.add(Count::datagrams);
  std::optional<Message> message;
  const Fault found = readMessage(datagram, message);
  if (found != Fault::none) {
    fault(Count::malformed, std::string("a datagram was dropped: ") + faultText(found));
    return nothing_;
  }
  Packet first;
  decode(message->dialect(), *message->begin(), first);
  if (!std::holds_alternative<IgControl>(first)) {
    fault(Count::unexpected, "a datagram was dropped: it is an image generator's, not a host's");
    return nothing_;
  }
  const bool sameDialect = !heard_ || message->dialect() == dialect_;
  if (!sameDialect) frames_ = HostFrames();
  std::uint32_t lost = 0;
  const IgControl control = std::get<IgControl>(first);
  const Arrival arrival = frames_.arrival(control.hostFrame, datagram, lost);
  if (lost > 0) counts_.add(Count::lost, lost);
  switch (arrival) {
    case Arrival::late:
      counts_.add(Count::late);
      return nothing_;
    case Arrival::repeated:
      counts_.add(Count::repeated);
      return options_.pacing == Pacing::synchronous ? out_ : nothing_;
    case Arrival::restart:
    case Arrival::next:
      break;
  }
  const bool restarted = arrival == Arrival::restart || !sameDialect;
  if (restarted) counts_.add(Count::restarts);
  const bool reset = control.mode == 0 && control_.mode != 0;
  if (heard_ && (restarted || reset)) forget();
  begin(control, message->dialect(), now, restarted);
  apply(*message);
  tellWater();
  if (options_.pacing == Pacing::asynchronous) return nothing_;
  answerFrame();
  return out_;
}

void CigiSession::begin(const IgControl& control, Dialect dialect, double now, bool restarted) {
  heard_ = true;
  dialect_ = dialect;
  control_ = control;
  if (restarted) hostTime_ = HostTime();
  const std::optional<std::uint32_t> timestamp =
      control.timestampValid ? std::optional(control.timestamp) : std::nullopt;
  const double hostTime = hostTime_.at(control.hostFrame, timestamp, options_.framePeriod);
  time_ = options_.hostClock ? hostTime : now;
  entities_.advanceTo(time_);
}

CigiSession::Output CigiSession::tick(double now) {
  if (!heard_ && !greet_) return nothing_;
  if (!options_.hostClock) time_ = now;
  if (options_.pacing == Pacing::synchronous) {
    // The answers may still be asked for again: they stay in out_.
    again_.begin(dialect_, startOfFrame());
    return again_;
  }
  entities_.advanceTo(time_);
  if (entities_.anyMoves()) tellWater();
  answerFrame();
  return out_;
}

void CigiSession::forget() {
  entities_.clear();
  requests_.clear();
  conditionsAsked_.clear();
}

void CigiSession::apply(const Message& message) {
  Packet packet;
  for (const Message::View view : message) {
    switch (decode(dialect_, view, packet)) {
      case Decoded::known:
        apply(packet);
        break;
      case Decoded::unknown:
        fault(Count::unknownPackets,
              "packets with identifier " + std::to_string(view.id) + " are not served");
        break;
      case Decoded::wrongSize:
        fault(Count::wrongSize, "packets with identifier " + std::to_string(view.id) +
                                    " and size " + std::to_string(view.bytes.size()) +
                                    " are passed over: the size is not the version's");
        break;
    }
  }
}

void CigiSession::apply(const Packet& packet) {
  const auto unexpected = [&](const auto&) {
    fault(Count::unsupported, std::string(packetName(packet)) + " from a host is passed over");
  };
  std::visit(
      Overloaded{
          [](const IgControl&) {}, [&](const RateControl& rate) { entities_.set(rate); },
          [&](const EntityControl& control) {
            entities_.set(control, dialect_.version == Version::v33);
          },
          [&](const EntityPosition& position) { entities_.set(position); },
          [&](const HatHotRequest& request) {
            if (request.type > static_cast<std::uint8_t>(HeightKind::extended)) {
              return unexpected(request);
            }
            take(pointRequest(request));
          },
          [&](const WaterVelocityRequest& request) { take(pointRequest(request)); },
          [&](const MaritimeSurfaceControl& control) { set(control); },
          [&](const WaveControl& control) { set(control); },
          [&](const EnvironmentRequest& request) {
            if (request.type != maritime) unexpected(request);
            if ((request.type & maritime) == 0) return;
            if (conditionsAsked_.size() < options_.mostRequests) {
              conditionsAsked_.push_back(request);
            } else {
              fault(Count::refusedRequests, "more conditions are asked for than fit in a frame");
            }
          },
          [&](const ViewControl& view) { water_.viewAsked(options_.host, view); },
          [&](const ViewDefinition& view) { water_.viewDefined(options_.host, view); }, unexpected},
      packet);
}

void CigiSession::take(const PointRequest& request) {
  if (requests_.take(request)) return;
  fault(Count::refusedRequests, "more requests than the " + std::to_string(options_.mostRequests) +
                                    " that are kept at a time");
}

void CigiSession::set(const MaritimeSurfaceControl& control) {
  if (!isGlobal(control.scope)) return refuseScope(control, control.scope);
  if (!std::isfinite(control.height + control.temperature + control.clarity)) {
    fault(Count::unsupported, "Maritime Surface Conditions Control is passed over: not finite");
    return;
  }
  waterLevel_ = control.enabled ? control.height : options_.waterLevel;
  temperature_ = control.enabled ? control.temperature : options_.temperature;
  clarity_ = control.enabled ? control.clarity : options_.clarity;
}

void CigiSession::set(const WaveControl& control) {
  if (!isGlobal(control.scope)) return refuseScope(control, control.scope);
  if (waves_.set(control)) return;
  fault(Count::unsupported,
        "Wave Control is passed over: not finite, of negative height, or with neither wavelength "
        "nor period");
}

void CigiSession::refuseScope(const Packet& packet, std::uint8_t scope) {
  fault(Count::otherScopes, std::string(packetName(packet)) + " of scope " + std::to_string(scope) +
                                " is passed over: one sea has one sea state; must be global (0)");
}

void CigiSession::tellWater() {
  if (waves_.changed(wavesAsked_)) water_.wavesAsked(options_.host, time_, wavesAsked_);
  const bool werePlaced = !placed_.empty();
  entities_.list(waterLevel_, placed_);
  if (werePlaced || !placed_.empty()) water_.entitiesAt(options_.host, time_, placed_);
}

void CigiSession::answerFrame() {
  ++igFrame_;
  out_.begin(dialect_, startOfFrame());
  const FrameMoment moment{time_, waterLevel_, control_.hostFrame, options_.host};
  answers_.answer(requests_.nextFrame(), entities_, moment, water_, out_, counts_);
  if (!conditionsAsked_.empty()) answerConditions();
}

void CigiSession::answerConditions() {
  conditionPoints_.clear();
  for (const EnvironmentRequest& request : conditionsAsked_) {
    conditionPoints_.push_back({request.latitude, request.longitude});
  }
  conditionHeights_.resize(conditionPoints_.size());
  water_.heights(time_, conditionPoints_, conditionHeights_);
  for (std::size_t i = 0; i < conditionsAsked_.size(); ++i) {
    if (conditionHeights_[i].valid) {
      out_.add(MaritimeSurfaceResponse{conditionsAsked_[i].request, static_cast<float>(waterLevel_),
                                       temperature_, clarity_});
    } else {
      fault(Count::noConditions, "maritime conditions are asked for where there is no water");
    }
  }
  conditionsAsked_.clear();
}

StartOfFrame CigiSession::startOfFrame() const {
  StartOfFrame start;
  start.databaseNumber = control_.databaseNumber;
  start.mode = control_.mode;
  start.timestampValid = true;
  start.igFrame = igFrame_;
  start.timestamp = ticksOf(time_);
  start.lastHostFrame = control_.hostFrame;
  return start;
}

}  // namespace seaway::bridge::cigi
