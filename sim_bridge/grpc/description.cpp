#include "sim_bridge/grpc/description.h"

#include "sim_bridge/scene/sea_state_file.h"
#include "surface/angles.h"
#include "surface/effects.h"

namespace seaway::bridge::rpc {
namespace {

using v1::DescribeResponse;

void describeOctave(const OctaveEntry& entry, v1::Octave& octave) {
  octave.set_kind(kindName(entry.kind));
  octave.set_standard_deviation_m(entry.standardDeviation);
  octave.set_toward_deg(entry.toward_deg);
  if (entry.latticeSize) octave.set_lattice_m(*entry.latticeSize);
  if (entry.frequency) octave.set_frequency_hz(*entry.frequency);
  if (entry.bandwidth) octave.set_bandwidth_hz(*entry.bandwidth);
  if (entry.directionalWidth_deg) octave.set_directional_width_deg(*entry.directionalWidth_deg);
  if (entry.kind == OctaveKind::regular) octave.set_phase_deg(entry.phase_deg);
}

const char* settingName(EffectSetting setting) {
  switch (setting) {
    case EffectSetting::automatic:
      return "auto";
    case EffectSetting::on:
      return "on";
    case EffectSetting::off:
      return "off";
  }
  return "";
}

void describeScene(const Scene& scene, DescribeResponse& response) {
  response.set_scene(scene.file.string());
  response.set_depth_m(scene.sea.depth);
  response.set_water_level_m(scene.sea.waterLevel);
  for (const SceneVessel& vessel : scene.vessels) {
    DescribeResponse::Vessel* entry = response.add_vessels();
    entry->set_name(vessel.name);
    entry->set_length_m(vessel.model.hull.length);
    entry->set_beam_m(vessel.model.hull.beam);
    entry->set_makes_waves(vessel.model.wake.strength > 0.0);
  }
  for (const SceneCamera& camera : scene.cameras) {
    DescribeResponse::Camera* entry = response.add_cameras();
    entry->set_name(camera.name);
    entry->set_mount(camera.mount);
    entry->set_fov_deg(camera.fieldOfView_deg);
  }
  for (const EffectDescription& effect : effectDescriptions()) {
    DescribeResponse::Effect* entry = response.add_effects();
    entry->set_name(std::string(effect.name));
    entry->set_setting(settingName(scene.effects[static_cast<std::size_t>(effect.effect)]));
    entry->set_summary(std::string(effect.summary));
  }
}

void describeLimits(const WaterLimits& limits, DescribeResponse::Limits& out) {
  out.set_points(limits.points);
  out.set_message_bytes(static_cast<std::uint64_t>(limits.messageBytes));
  out.set_picture_pixels(limits.pixels);
  out.set_hulls(static_cast<std::uint32_t>(limits.hulls));
}

}  // namespace

void describeSea(const WaterHost& host, DescribeResponse::Sea& sea) {
  const ServedMoment moment = host.sea.moment(0.0);
  const WaveField& waves = moment.surface->waves();
  const double realised = waves.significantWaveHeight();
  sea.set_hm0_realised_m(realised);
  const Sea& own = moment.scene->sea;
  if (const auto asked = host.asked.of(realised)) {
    sea.set_hm0_asked_m(*asked);
  } else if (own.surface.waves().significantWaveHeight() == realised) {
    sea.set_hm0_asked_m(own.hm0Asked);
  }
  const double depth = waves.settings().depth;
  for (std::size_t i = 0; i < waves.octaves().size(); ++i) {
    const OctaveEntry entry = entryOf(waves.octaves()[i], depth);
    describeOctave(entry, *sea.add_octaves());
    sea.add_left_out_m(waves.leftOut(i + 1));
    if (i > 0 || !entry.frequency) continue;
    sea.set_peak_period_s(1.0 / *entry.frequency);
    sea.set_peak_from_deg(compassWrapped(entry.toward_deg + 180.0));
  }
}

void describe(const WaterHost& host, DescribeResponse& response) {
  response.set_version(SEAWAY_VERSION);
  const GeodeticPosition& anchor = host.sea.geodesy().anchor();
  response.set_anchor_latitude_deg(anchor.latitude_deg);
  response.set_anchor_longitude_deg(anchor.longitude_deg);
  const glm::dvec2 current = host.sea.surface()->waves().settings().current;
  response.set_current_east_m_s(current.x);
  response.set_current_north_m_s(current.y);
  if (!host.clock.isHosts()) response.set_clock_s(host.clock.now());
  describeScene(*host.sea.scene(), response);
  describeSea(host, *response.mutable_sea());
  describeLimits(host.limits, *response.mutable_limits());
  if (const auto span = host.sea.wakeSpan()) {
    response.set_wakes_from_s(span->first);
    response.set_wakes_to_s(span->second);
  }
  response.set_hosted_hulls(static_cast<std::uint32_t>(host.hulls.size()));
}

}  // namespace seaway::bridge::rpc
