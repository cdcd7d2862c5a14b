#include "sim_bridge/grpc/sea_state.h"

#include <google/protobuf/util/json_util.h>

#include "sim_bridge/grpc/description.h"
#include "sim_bridge/scene/sea.h"
#include "sim_bridge/scene/sea_state_schema.h"
#include "surface/input_error.h"

namespace seaway::bridge::rpc {
namespace {

void replaceAll(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at)) {
    text.replace(at, what.size(), by);
  }
}

/// The message as YAML: its fields are called as the keys of a scene are.
std::string yamlOf(const google::protobuf::Message& message) {
  google::protobuf::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  std::string json;
  const auto status = google::protobuf::util::MessageToJsonString(message, &json, options);
  if (!status.ok()) throw InputError("state: " + status.ToString());
  replaceAll(json, "\"Infinity\"", ".inf");
  replaceAll(json, "\"-Infinity\"", "-.inf");
  replaceAll(json, "\"NaN\"", ".nan");
  return json;
}

void requireFewOctaves(const WaterHost& host, const v1::SetSeaStateRequest& request) {
  const auto count = static_cast<std::size_t>(request.octaves().octaves_size());
  if (count <= host.limits.octaves) return;
  throw RpcFault(grpc::StatusCode::RESOURCE_EXHAUSTED, Refusal::tooLarge,
                 "octaves: " + std::to_string(count) + " are not allowed; at most " +
                     std::to_string(host.limits.octaves));
}

}  // namespace

SetSea setSeaState(ServedSea& sea, const YamlValue& state) {
  if (const YamlValue* file = state.find("file")) {
    file->fail("is not allowed here: a host does not read the service's files");
  }
  Scene scene = *sea.scene();
  scene.file = *state.file;
  scene.sea.state = seaStateSchema().read(state);
  scene.sea.stateLine = state.line;
  const Sea built = buildSea(scene);
  const WaveField& waves = built.surface.waves();
  sea.setOctaves({waves.octaves().begin(), waves.octaves().end()});
  return {built.hm0Asked, waves.significantWaveHeight()};
}

void setSeaState(WaterHost& host, const v1::SetSeaStateRequest& request,
                 v1::SetSeaStateResponse& response) {
  using Request = v1::SetSeaStateRequest;
  if (request.state_case() == Request::STATE_NOT_SET) {
    throw badValue("state", "nothing",
                   "must be one of: scene, calm, jonswap, pierson_moskowitz, tma, ochi_hubble, "
                   "torsethaugen, swell, wmo, octaves");
  }
  if (request.has_scene()) {
    host.sea.restoreOctaves();
  } else {
    requireFewOctaves(host, request);
    // `octaves` is a list in YAML, and a message that holds one here.
    const bool list = request.has_octaves();
    const std::string yaml = list ? yamlOf(request.octaves()) : yamlOf(request);
    const SetSea set = setSeaState(host.sea, parseYaml(yaml, "SetSeaStateRequest"));
    host.asked.set(set.hm0Asked, set.hm0Realised);
  }
  describeSea(host, *response.mutable_sea());
}

}  // namespace seaway::bridge::rpc
