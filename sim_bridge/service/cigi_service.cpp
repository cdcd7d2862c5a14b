#include "sim_bridge/service/cigi_service.h"

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>

#include "sim_bridge/cigi/sea_water.h"
#include "sim_bridge/cigi/udp_endpoint.h"
#include "sim_bridge/scene/schema.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

/// The endpoint with the water it asks, and its counts told at the end.
class CigiEndpoint : public Endpoint {
 public:
  CigiEndpoint(cigi::UdpOptions options, ServedSea& sea, FrameMaker& frames)
      : water_(sea, &frames), udp_(std::move(options), water_) {
    sea.meters().addEvents("cigi", [this] {
      std::vector<std::pair<std::string, std::uint64_t>> all;
      for (std::size_t i = 0; i < cigi::Counts::size(); ++i) {
        const auto which = static_cast<cigi::Count>(i);
        all.emplace_back(cigi::Counts::name(which), udp_.counts()[which]);
      }
      return all;
    });
  }

  std::string description() const override { return udp_.description(); }
  void start() override { udp_.start(); }
  void stop() override {
    udp_.stop();
    std::string text;
    for (std::size_t i = 0; i < cigi::Counts::size(); ++i) {
      const auto which = static_cast<cigi::Count>(i);
      const std::uint64_t count = udp_.counts()[which];
      if (count > 0)
        text += std::string(" ") + cigi::Counts::name(which) + "=" + std::to_string(count);
    }
    spdlog::info("{} ends:{}", description(), text.empty() ? " never asked" : text);
  }

 private:
  cigi::SeaWater water_;
  cigi::UdpEndpoint udp_;
};

/// One of two words.
bool isFirst(const std::string& option, const std::string& word, const char* first,
             const char* second) {
  if (word != first && word != second) {
    throw InputError(option + ": '" + word + "' is not allowed; must be one of: " + first + ", " +
                     second);
  }
  return word == first;
}

}  // namespace

void addCigiOptions(CLI::App& command, CigiServiceOptions& options) {
  const char* group = "CIGI";
  command
      .add_option("--cigi", options.address, "[HOST:]PORT to serve CIGI 3.3 and 4.0 on over UDP")
      ->group(group);
  command
      .add_option("--cigi-pacing", options.pacing,
                  "synchronous: each message of a host is answered at once; asynchronous: with the "
                  "next of the frames that come by themselves")
      ->capture_default_str()
      ->group(group);
  command.add_option("--cigi-rate", options.rate, "Starts of Frame a second")
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--cigi-host", options.greet,
                  "HOST:PORT that is sent Starts of Frame before it has spoken")
      ->group(group);
  command.add_option("--cigi-version", options.version, "3.3 or 4.0, spoken to --cigi-host")
      ->capture_default_str()
      ->group(group);
}

std::unique_ptr<Endpoint> makeCigiEndpoint(const CigiServiceOptions& options, ServedSea& sea,
                                           const ServeClock& clock, FrameMaker& frames) {
  cigi::UdpOptions udp;
  const bool synchronous = isFirst("--cigi-pacing", options.pacing, "synchronous", "asynchronous");
  const bool v33 = isFirst("--cigi-version", options.version, "3.3", "4.0");
  requireInRange("--cigi-rate", options.rate, Range::within(0.1, 10000.0), "1/s");
  if (options.address.empty()) return nullptr;
  udp.address = parseSocketAddress("--cigi", options.address);
  if (!options.greet.empty()) udp.greet = parseSocketAddress("--cigi-host", options.greet);
  udp.greeting.version = v33 ? cigi::Version::v33 : cigi::Version::v40;
  udp.session.pacing = synchronous ? cigi::Pacing::synchronous : cigi::Pacing::asynchronous;
  udp.session.hostClock = clock.isHosts();
  udp.session.framePeriod = 1.0 / options.rate;
  udp.session.waterLevel = sea.scene()->sea.waterLevel;
  udp.now = [clock] { return clock.now(); };
  udp.served = [&meter = sea.meters().of("cigi")](const cigi::DatagramTally& tally,
                                                  double seconds) {
    for (std::uint64_t i = 0; i < tally.dropped; ++i) meter.refused(Refusal::malformed);
    for (std::uint64_t i = 0; i < tally.refused; ++i) meter.refused(Refusal::badValue);
    if (tally.dropped == 0) meter.answered(tally.points, seconds);
  };
  return std::make_unique<CigiEndpoint>(std::move(udp), sea, frames);
}

}  // namespace seaway::bridge
