#pragma once

#include "seaway/v1/water.pb.h"
#include "sim_bridge/grpc/water_host.h"
#include "sim_bridge/scene/yaml_value.h"
#include "sim_bridge/service/served_sea.h"

namespace seaway::bridge::rpc {

/// What a sea state became.
struct SetSea {
  double hm0Asked = 0.0;     ///< m
  double hm0Realised = 0.0;  ///< m
};

/// Gives `sea` the waves of a sea state with the keys that `sea.state` has in a scene but `file`: a
/// host may not read the service's files. Throws InputError, which names key, value and what is
/// allowed; the sea is then as before. Fits take up to a second. Thread-safe.
SetSea setSeaState(ServedSea& sea, const YamlValue& state);

/// Answers SetSeaStateRequest. Throws RpcFault and as above.
void setSeaState(WaterHost& host, const v1::SetSeaStateRequest& request,
                 v1::SetSeaStateResponse& response);

}  // namespace seaway::bridge::rpc
