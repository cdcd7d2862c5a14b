#pragma once

#include "sim_bridge/capi/coupled_sea.h"
#include "sim_bridge/seaway.h"

namespace seaway::bridge::capi {

/// The library's options for a caller's. Throws CallError for those out of range.
SampleOptions sampleOptionsOf(const CoupledSea& sea, const CoupledSea::Moment& moment,
                              const seaway_sample_options& given);

}  // namespace seaway::bridge::capi
