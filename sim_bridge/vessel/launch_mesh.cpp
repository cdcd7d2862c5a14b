#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "sim_bridge/vessel/hull_drawing.h"
#include "sim_bridge/vessel/mesh_builder.h"
#include "sim_bridge/vessel/vessel_mesh.h"

namespace seaway::bridge {
namespace {

constexpr int stationCount = 25;

// A cross-section of the hull, port side: the starboard side mirrors it.
struct Station {
  glm::vec3 keel, chine, bootTop, rail;  // outside, upwards
  glm::vec3 capping, deck;               // inside of the bulwark, downwards
};
using Line = glm::vec3 Station::*;

glm::vec3 mirrored(glm::vec3 point) { return {point.x, -point.y, point.z}; }

// Section at u in [0, 1] from the transom to the stem. Full aft of midships, closing to the stem;
// the deck line rises forward (sheer) and the stem leans forward of the waterline (rake).
Station stationAt(float u, const BoxHull& hull) {
  const float length = static_cast<float>(hull.length);
  const float halfBeam = 0.5f * static_cast<float>(hull.beam);
  const float draft = static_cast<float>(hull.draft());
  const float freeboard = static_cast<float>(hull.depth) - draft;
  const float forward = std::max(0.0f, (u - 0.45f) / 0.55f);
  const float aft = std::max(0.0f, (0.45f - u) / 0.45f);
  const float railBreadth = (1.0f - std::pow(forward, 2.6f)) * (1.0f - 0.10f * aft * aft);
  const float chineBreadth = (1.0f - std::pow(forward, 1.6f)) * (1.0f - 0.14f * aft * aft);
  const float rise = std::pow(forward, 4.0f);
  const float rake = 0.07f * length * forward * forward;
  const float x = (u - 0.5f) * length;
  Station station;
  station.keel = {x, 0.0f, -draft * (1.0f - 0.25f * rise)};
  station.chine = {x + 0.35f * rake, 0.88f * halfBeam * chineBreadth,
                   glm::mix(-0.40f * draft, 0.30f * freeboard, rise)};
  station.rail = {x + rake, halfBeam * railBreadth, freeboard * (0.95f + 0.55f * u * u)};
  // The boot top: where bottom paint gives way to the topsides' colour, just above the water.
  const float height = station.rail.z - station.chine.z;
  const float paint = std::clamp((0.12f * freeboard - station.chine.z) / height, 0.0f, 1.0f);
  station.bootTop = glm::mix(station.chine, station.rail, paint);
  const float thickness = 0.02f * length * (0.3f + 0.7f * std::min(1.0f, 4.0f * (1.0f - u)));
  station.capping = station.rail;
  station.capping.y = std::max(0.0f, station.rail.y - thickness);
  station.capping.x -= 0.025f * length * std::pow(forward, 8.0f);  // stays inside the raked stem
  station.deck = station.capping - glm::vec3(0.0f, 0.0f, 0.022f * length);
  return station;
}

std::array<Station, stationCount> stations(const BoxHull& hull) {
  std::array<Station, stationCount> all;
  for (int i = 0; i < stationCount; ++i) {
    all[i] = stationAt(static_cast<float>(i) / (stationCount - 1), hull);
  }
  return all;
}

// A strip of plating between two lines of the sections, on both sides; `from` comes before `to` on
// the way up the outside and down the inside.
void addStrake(MeshPart& part, const std::array<Station, stationCount>& all, Line from, Line to) {
  for (int i = 0; i + 1 < stationCount; ++i) {
    const Station& aft = all[i];
    const Station& fore = all[i + 1];
    addQuad(part, fore.*from, aft.*from, aft.*to, fore.*to);
    addQuad(part, mirrored(aft.*from), mirrored(fore.*from), mirrored(fore.*to), mirrored(aft.*to));
  }
}

void addTransom(MeshPart& part, const Station& stern) {
  const std::array<glm::vec3, 4> line{stern.keel, stern.chine, stern.bootTop, stern.rail};
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    addQuad(part, line[i + 1], line[i], mirrored(line[i]), mirrored(line[i + 1]));
  }
  // Its inside, above the deck.
  addQuad(part, stern.deck, stern.rail, mirrored(stern.rail), mirrored(stern.deck));
}

/// A box-shaped well in the deck, between two stations.
struct Cockpit {
  int aft = 0, fore = 0;                             // stations; none where equal
  float halfWidth = 0.0f, floor = 0.0f, top = 0.0f;  // m; top: the deck's lowest there
  bool holds(int station) const { return station >= aft && station < fore; }
};

// Abaft the wheelhouse, its floor below the waterline and above the chine.
Cockpit cockpitOf(const std::array<Station, stationCount>& all, const BoxHull& hull) {
  Cockpit cockpit{1, 8, 1e9f, -0.35f * static_cast<float>(hull.draft()), 1e9f};
  for (int i = cockpit.aft; i <= cockpit.fore; ++i) {
    cockpit.halfWidth = std::min(cockpit.halfWidth, 0.72f * all[i].deck.y);
    cockpit.top = std::min(cockpit.top, all[i].deck.z);
  }
  return cockpit;
}

void addDeck(MeshPart& part, const std::array<Station, stationCount>& all, const Cockpit& cockpit) {
  for (int i = 0; i + 1 < stationCount; ++i) {
    const glm::vec3 aft = all[i].deck;
    const glm::vec3 fore = all[i + 1].deck;
    if (!cockpit.holds(i)) {
      addQuad(part, mirrored(aft), mirrored(fore), fore, aft);
      continue;
    }
    const glm::vec3 aftEdge(aft.x, cockpit.halfWidth, aft.z);
    const glm::vec3 foreEdge(fore.x, cockpit.halfWidth, fore.z);
    addQuad(part, aftEdge, foreEdge, fore, aft);
    addQuad(part, mirrored(aft), mirrored(fore), mirrored(foreEdge), mirrored(aftEdge));
  }
}

// Floor and walls, seen from within.
void addCockpit(MeshPart& floor, MeshPart& walls, const std::array<Station, stationCount>& all,
                const Cockpit& cockpit) {
  const float w = cockpit.halfWidth, low = cockpit.floor;
  const auto at = [&](int station, float y, bool top) {
    const glm::vec3 deck = all[station].deck;
    return glm::vec3(deck.x, y, top ? deck.z : low);
  };
  for (int i = cockpit.aft; i < cockpit.fore; ++i) {
    addQuad(floor, at(i, -w, false), at(i + 1, -w, false), at(i + 1, w, false), at(i, w, false));
    addQuad(walls, at(i, w, false), at(i + 1, w, false), at(i + 1, w, true), at(i, w, true));
    addQuad(walls, at(i + 1, -w, false), at(i, -w, false), at(i, -w, true), at(i + 1, -w, true));
  }
  const int aft = cockpit.aft, fore = cockpit.fore;
  addQuad(walls, at(aft, -w, false), at(aft, w, false), at(aft, w, true), at(aft, -w, true));
  addQuad(walls, at(fore, w, false), at(fore, -w, false), at(fore, -w, true), at(fore, w, true));
}

render::Mesh::Hollow hollowOf(const std::array<Station, stationCount>& all,
                              const Cockpit& cockpit) {
  return {{{1.0f, 0.0f, 0.0f, all[cockpit.fore].deck.x},
           {-1.0f, 0.0f, 0.0f, -all[cockpit.aft].deck.x},
           {0.0f, 1.0f, 0.0f, cockpit.halfWidth},
           {0.0f, -1.0f, 0.0f, cockpit.halfWidth},
           {0.0f, 0.0f, 1.0f, cockpit.top},
           {0.0f, 0.0f, -1.0f, -cockpit.floor}}};
}

// A hatch coaming on the deck between two parts of the length.
void addHatch(MeshPart& part, const BoxHull& hull, float fromU, float toU) {
  const float length = static_cast<float>(hull.length);
  const float halfWidth = 0.05f * length;
  const float low = stationAt(fromU, hull).deck.z - 0.05f;
  const float high = stationAt(toU, hull).deck.z + 0.018f * length;
  const float aft = (fromU - 0.5f) * length;
  const float fore = (toU - 0.5f) * length;
  addBlock(part, {{aft, -halfWidth, low},
                  {fore, halfWidth, low},
                  {aft, -halfWidth, high},
                  {fore, halfWidth, high}});
}

Block wheelhouse(const BoxHull& hull) {
  const float length = static_cast<float>(hull.length);
  const float halfWidth = 0.31f * static_cast<float>(hull.beam);
  const float deck = stationAt(0.5f, hull).deck.z - 0.05f;
  const float roof = deck + 0.17f * length;
  return {{-0.14f * length, -halfWidth, deck},
          {0.17f * length, halfWidth, deck},
          {-0.12f * length, -0.9f * halfWidth, roof},
          {0.10f * length, 0.9f * halfWidth, roof}};
}

// Upright square post of side `width`.
Block post(float x, float y, float bottom, float top, float width) {
  const glm::vec3 half(0.5f * width, 0.5f * width, 0.0f);
  return {glm::vec3(x, y, bottom) - half, glm::vec3(x, y, bottom) + half,
          glm::vec3(x, y, top) - half, glm::vec3(x, y, top) + half};
}

void addRig(MeshPart& part, const Block& house, const BoxHull& hull) {
  const float length = static_cast<float>(hull.length);
  const float roof = house.topFrom.z;
  const float mastAt = -0.03f * length;
  const float top = roof + 0.14f * length;
  addBlock(part, post(mastAt, 0.0f, roof, top, 0.010f * length));
  const float yard = 0.09f * length;  // crosstrees
  addBlock(part, {{mastAt - 0.03f, -yard, top - 0.05f * length},
                  {mastAt + 0.03f, yard, top - 0.05f * length},
                  {mastAt - 0.03f, -yard, top - 0.045f * length},
                  {mastAt + 0.03f, yard, top - 0.045f * length}});
  const float radar = 0.05f * length;
  addBlock(part, post(0.04f * length, 0.0f, roof, roof + 0.025f * length, 0.6f * radar));
}

}  // namespace

std::vector<LaunchSection> launchSections(const BoxHull& hull) {
  std::vector<LaunchSection> sections;
  for (const Station& station : stations(hull)) {
    sections.push_back({station.keel, station.chine, station.rail});
  }
  return sections;
}

render::Mesh launchMesh(const BoxHull& hull, const VesselDrawing& drawing) {
  const auto all = stations(hull);
  const Block house = wheelhouse(hull);
  const float length = static_cast<float>(hull.length);
  const bool open = drawing.shape == VesselShape::openLaunch;
  const Cockpit cockpit = open ? cockpitOf(all, hull) : Cockpit{};
  MeshPart bottom{{}, {0.22f, 0.04f, 0.03f}};
  MeshPart topsides{{}, drawing.hullColour};
  MeshPart deck{{}, drawing.deckColour};
  MeshPart superstructure{{}, drawing.houseColour};
  MeshPart windows{{}, {0.015f, 0.02f, 0.025f}};
  MeshPart rig{{}, {0.75f, 0.75f, 0.75f}};
  addStrake(bottom, all, &Station::keel, &Station::chine);
  addStrake(bottom, all, &Station::chine, &Station::bootTop);
  addStrake(topsides, all, &Station::bootTop, &Station::rail);
  addTransom(topsides, all.front());
  addStrake(superstructure, all, &Station::rail, &Station::capping);
  addStrake(superstructure, all, &Station::capping, &Station::deck);
  addDeck(deck, all, cockpit);
  addHatch(superstructure, hull, 0.80f, 0.86f);
  if (open) {
    addCockpit(deck, superstructure, all, cockpit);
  } else {
    addHatch(superstructure, hull, 0.12f, 0.26f);
  }
  addBlock(superstructure, house);
  addWindowBand(windows, house, 0.52f, 0.84f, 0.02f);
  // Corner posts and mullions in front of the band's flat faces.
  for (const float part : {-1.0f, -0.33f, 0.33f, 1.0f}) {
    const glm::vec3 low = glm::mix(house.bottomTo, house.topTo, 0.50f);
    const glm::vec3 high = glm::mix(house.bottomTo, house.topTo, 0.86f);
    const glm::vec3 half(0.02f, 0.004f * length, 0.0f);
    const glm::vec3 across(1.0f, part, 1.0f);
    const glm::vec3 forward(0.03f, 0.0f, 0.0f);
    addBlock(superstructure, {low * across - half + forward, low * across + half + forward,
                              high * across - half + forward, high * across + half + forward});
  }
  addRig(rig, house, hull);
  render::Mesh mesh;
  mesh.parts = {bottom, topsides, deck, superstructure, windows, rig};
  if (open) mesh.hollows.push_back(hollowOf(all, cockpit));
  finish(mesh);
  return mesh;
}

render::Mesh vesselMesh(const VesselModel& model) {
  switch (model.drawing.shape) {
    case VesselShape::launch:
    case VesselShape::openLaunch:
      return launchMesh(model.hull, model.drawing);
    case VesselShape::buoy:
      return buoyMesh(model.hull, model.drawing);
    case VesselShape::mesh:
      return hullDrawing(model);
  }
  return {};
}

}  // namespace seaway::bridge
