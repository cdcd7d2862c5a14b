#pragma once

#include "seaway/v1/water.pb.h"
#include "sim_bridge/grpc/water_host.h"

namespace seaway::bridge::rpc {

/// What is served, as it is now. Thread-safe.
void describe(const WaterHost& host, v1::DescribeResponse& response);
void describeSea(const WaterHost& host, v1::DescribeResponse::Sea& sea);

}  // namespace seaway::bridge::rpc
