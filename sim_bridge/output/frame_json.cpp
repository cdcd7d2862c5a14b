#include "sim_bridge/output/frame_json.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <nlohmann/json.hpp>

#include "render/scene_object.h"
#include "sim_bridge/output/labels.h"
#include "sim_bridge/vessel/vessel_pose.h"
#include "surface/angles.h"

namespace seaway::bridge {
namespace {

using Json = nlohmann::ordered_json;

template <typename Vector>
Json listOf(const Vector& v) {
  Json list = Json::array();
  for (int i = 0; i < Vector::length(); ++i) list.push_back(v[i]);
  return list;
}

Json rowsOf(const glm::dmat3& m) {
  const glm::dmat3 rows = glm::transpose(m);
  return {listOf(rows[0]), listOf(rows[1]), listOf(rows[2])};
}

/// A body's place and attitude, to the world and to the sea plane.
Json poseJson(const Geodesy& geodesy, const glm::dvec3& position, const glm::dquat& attitude) {
  const GeodeticPosition place = geodesy.geodeticFromSeaPlane(glm::dvec2(position));
  const VesselPose pose = vesselPose(position, attitude);
  return {{"latitude_deg", place.latitude_deg},
          {"longitude_deg", place.longitude_deg},
          {"height_m", position.z},
          {"heading_deg", geodesy.trueHeadingFromDirection(pose.position, pose.direction)},
          {"pitch_deg", degreesFromRadians(pose.pitch)},
          {"roll_deg", degreesFromRadians(pose.roll)},
          {"sea_plane",
           {{"position_m", listOf(position)},
            {"quaternion_wxyz", {attitude.w, attitude.x, attitude.y, attitude.z}},
            {"world_from_body", rowsOf(glm::mat3_cast(attitude))}}}};
}

Json cameraJson(const DescribedFrame& d) {
  const render::Camera& camera = d.view.camera;
  const render::Intrinsics pinhole = camera.pinhole();
  Json json{{"name", d.camera}, {"size", {camera.size.x, camera.size.y}}};
  json.update(poseJson(d.geodesy, camera.position, camera.worldFromCamera));
  const glm::dmat3 cameraFromWorld =
      glm::transpose(glm::dmat3(-camera.left(), -camera.up(), camera.forward()));
  json["opencv"] = {{"camera_from_world", rowsOf(cameraFromWorld)},
                    {"translation_m", listOf(-(cameraFromWorld * camera.position))}};
  json["intrinsics"] = {
      {"fx_px", pinhole.fx}, {"fy_px", pinhole.fy}, {"cx_px", pinhole.cx}, {"cy_px", pinhole.cy}};
  const render::Distortion lens = camera.distortion.value_or(render::Distortion{});
  json["distortion"] = {
      {"k1", lens.k1}, {"k2", lens.k2}, {"p1", lens.p1}, {"p2", lens.p2}, {"k3", lens.k3}};
  json["samples_per_side"] = d.view.samplesPerSide;
  return json;
}

/// The box that holds a mesh, in its body frame.
Json boxOf(const render::Mesh& mesh) {
  glm::vec3 least(std::numeric_limits<float>::infinity()), most(-least);
  for (const render::Mesh::Part& part : mesh.parts) {
    for (const glm::vec3& vertex : part.vertices) {
      least = glm::min(least, vertex);
      most = glm::max(most, vertex);
    }
  }
  if (!(least.x <= most.x)) return nullptr;
  return {{"least_m", listOf(least)}, {"most_m", listOf(most)}};
}

Json instancesJson(const DescribedFrame& d) {
  const bool isLabelled = !d.frame.instances.empty();
  const std::vector<InstanceBox> boxes = instanceBoxes(d.frame);
  Json list = Json::array();
  for (const SceneInstance& instance : d.instances) {
    const render::SceneObject& object = *instance.object;
    Json json{{"name", instance.name}, {"kind", instance.kind}, {"instance", object.instance}};
    json["label"] = labelOfInstance(object.instance);
    json.update(poseJson(d.geodesy, object.position, object.worldFromBody));
    json["box_3d"] = boxOf(*object.mesh);
    json["drawn_lower_by_m"] =
        object.position.z - (relativePosition(object, d.view.camera).z + d.view.camera.position.z);
    if (isLabelled) {
      json["box_2d_px"] = nullptr;
      json["visible_pixels"] = 0;
    }
    for (const InstanceBox& box : boxes) {
      if (box.instance != object.instance) continue;
      json["box_2d_px"] = {box.left, box.top, box.right, box.bottom};
      json["visible_pixels"] = box.pixels;
    }
    list.push_back(std::move(json));
  }
  return list;
}

Json labelsJson(const DescribedFrame& d) {
  Json labels = Json::object();
  for (const auto& [value, name] : commonLabels()) labels[std::to_string(value)] = name;
  for (const SceneInstance& instance : d.instances) {
    labels[std::to_string(labelOfInstance(instance.object->instance))] = instance.name;
  }
  return labels;
}

Json effectsJson(const EffectLedger& ledger) {
  Json list = Json::array();
  for (const EffectReport& effect : ledger.report()) {
    if (effect.state != EffectState::on) continue;
    list.push_back({{"name", effectName(effect.effect)},
                    {"reason", effect.reason},
                    {"memory_bytes", effect.memoryBytes}});
  }
  return list;
}

Json conventions() {
  return {{"sea_plane",
           "x east, y north, z up at the scene's anchor, m; z above the still-water level"},
          {"body",
           "x forward, y to port, z up; a camera looks along +x; world_from_body has rows, its "
           "columns are the body's axes in the sea plane"},
          {"opencv",
           "x right, y down, z forward: p_camera = camera_from_world p_sea_plane + "
           "translation_m"},
          {"pixels",
           "whole numbers are centres, (0, 0) that of the top left pixel; boxes are [left, "
           "top, right, bottom), of the visible part"},
          {"box_3d",
           "in the body frame; the sea is curved: what lies away from the camera is drawn "
           "drawn_lower_by_m below its place in the sea plane"},
          {"labels", "a water pixel is foam where at least half of it is white"}};
}

}  // namespace

Json frameJson(const DescribedFrame& d) {
  const render::FrameStats& stats = d.frame.stats;
  Json json{{"scene", d.scene.file.string()}, {"seed", d.scene.sea.seed},
            {"time_s", d.view.time},          {"camera", cameraJson(d)},
            {"instances", instancesJson(d)},  {"labels", labelsJson(d)},
            {"exposure", d.frame.exposure},   {"technique", stats.technique},
            {"variant", stats.variant},       {"effects_on", effectsJson(d.effects)},
            {"conventions", conventions()}};
  return json;
}

}  // namespace seaway::bridge
