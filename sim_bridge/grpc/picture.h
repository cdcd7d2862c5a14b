#pragma once

#include "seaway/v1/water.pb.h"
#include "sim_bridge/grpc/call_watch.h"
#include "sim_bridge/grpc/water_host.h"

namespace seaway::bridge::rpc {

/// Answers RenderRequest. Throws RpcFault, also where `watch` says so before the picture is drawn,
/// and what FrameMaker throws. Thread-safe.
void drawPicture(WaterHost& host, const v1::RenderRequest& request, v1::RenderResponse& response,
                 const CallWatch& watch);

}  // namespace seaway::bridge::rpc
