#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim_bridge/cigi/counts.h"
#include "sim_bridge/cigi/entities.h"
#include "sim_bridge/cigi/host_frames.h"
#include "sim_bridge/cigi/host_waves.h"
#include "sim_bridge/cigi/message_writer.h"
#include "sim_bridge/cigi/point_answers.h"
#include "sim_bridge/cigi/point_requests.h"
#include "sim_bridge/cigi/water.h"

namespace seaway::bridge::cigi {

/// Who sets the pace.
enum class Pacing : std::uint8_t {
  synchronous,   ///< each message of the host is answered at once by the next Start of Frame
  asynchronous,  ///< a Start of Frame every period, with the answers to what came meanwhile
};

struct SessionOptions {
  Pacing pacing = Pacing::synchronous;
  /// Frames are at the host's time stamps (without any: its frames times `framePeriod`); else at
  /// the time that the caller tells.
  bool hostClock = true;
  double framePeriod = 1.0 / 60.0;     ///< s, > 0
  double waterLevel = 0.0;             ///< of still water above mean sea level, m
  float temperature = 15.0f;           ///< °C, until a host sets it
  float clarity = 100.0f;              ///< %, until a host sets it
  std::size_t largestDatagram = 1472;  ///< bytes: what an Ethernet frame carries; ≥ 64
  std::size_t mostRequests = 4096;     ///< periodic ones kept, and answered once a frame
  std::uint32_t host = 0;              ///< told to the water; from 1, 0 has no hulls of its own
  /// Hears of the first of each kind of fault.
  std::function<void(const std::string&)> warn = [](const std::string&) {};
};

/// One host's conversation, without a network: datagrams in, datagrams out.
///
/// Each datagram of the host is a message that begins with IG Control; each datagram out begins
/// with a Start of Frame in the host's version and byte order, with its last frame number. Answers
/// hold for the frame's time. A datagram that is no message, or comes late, changes nothing. One
/// that comes again is, when synchronous, answered again with the same bytes. A host that begins
/// again, changes its version, or goes from another mode to 0 (reset) finds no entities and no
/// periodic requests; the sea stays.
///
/// Of the packets, IG Control, Entity Control and Position, HAT/HOT Request, Maritime Surface
/// Conditions and Wave Control (global scope), Environmental Conditions Request (maritime), View
/// Control and Definition, Rate Control of entities (which go on between the frames that place
/// them) and Water Velocity Request are served; all others are passed over by their size.
///
/// Not thread-safe. Allocates only where more is asked than ever before.
class CigiSession {
 public:
  /// What goes out; valid until the next call.
  using Output = const MessageWriter&;

  /// `water` and `counts` must outlive the session.
  CigiSession(SessionOptions options, Water& water, Counts& counts);

  /// Takes a datagram; `now` is the caller's time, s since the scene's epoch. Empty where nothing
  /// is to be sent.
  Output receive(Bytes datagram, double now);

  /// A frame period has gone by. Asynchronous: the next frame. Synchronous: the last Start of Frame
  /// again, without answers, so that a lost datagram does not stop the exchange.
  Output tick(double now);

  /// Starts to speak before the host does, in a dialect, so that ticks have something to send.
  void greet(Dialect dialect) { greet_ = true, dialect_ = dialect; }

  double waterLevel() const { return waterLevel_; }
  std::uint32_t igFrame() const { return igFrame_; }

 private:
  void fault(Count which, const std::string& what);
  void begin(const IgControl& control, Dialect dialect, double now, bool restarted);
  void forget();
  void apply(const Message& message);
  void apply(const Packet& packet);
  void take(const PointRequest& request);
  void set(const MaritimeSurfaceControl& control);
  void set(const WaveControl& control);
  /// Of a region or an entity: it changes nothing.
  void refuseScope(const Packet& packet, std::uint8_t scope);
  void tellWater();
  void answerFrame();
  void answerConditions();
  StartOfFrame startOfFrame() const;

  SessionOptions options_;
  Water& water_;
  Counts& counts_;
  bool greet_ = false;
  bool heard_ = false;
  Dialect dialect_;
  IgControl control_;
  HostFrames frames_;
  HostTime hostTime_;
  std::uint32_t igFrame_ = 0;
  double time_ = 0.0;

  Entities entities_;
  HostWaves waves_;
  PointRequests requests_;
  std::vector<EnvironmentRequest> conditionsAsked_;
  double waterLevel_;
  float temperature_, clarity_;

  PointAnswers answers_;
  MessageWriter out_, again_;
  const MessageWriter nothing_;
  std::vector<WaterPoint> conditionPoints_;
  std::vector<WaterHeight> conditionHeights_;
  std::vector<HostEntity> placed_;
  std::vector<HostWave> wavesAsked_;
};

}  // namespace seaway::bridge::cigi
