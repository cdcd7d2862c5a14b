#include "sim_bridge/grpc/water_service.h"

#include "seaway/v1/water.grpc.pb.h"
#include "sim_bridge/grpc/description.h"
#include "sim_bridge/grpc/picture.h"
#include "sim_bridge/grpc/point_sampler.h"
#include "sim_bridge/grpc/pose_stream.h"
#include "sim_bridge/grpc/sea_state.h"
#include "sim_bridge/grpc/wake_step.h"

namespace seaway::bridge::rpc {
namespace {

using v1::Water;

// Methods whose messages are read here, so that what is malformed is answered and counted.
template <class Service>
using Raw = Water::WithRawMethod_Sample<Water::WithRawMethod_SampleStream<
    Water::WithRawMethod_SubmitPoses<Water::WithRawMethod_Step<Water::WithRawMethod_Render<
        Water::WithRawMethod_Describe<Water::WithRawMethod_SetSeaState<Service>>>>>>>;
using RawWater = Raw<Water::Service>;

class SampleAnswerer {
 public:
  using Request = v1::SampleRequest;
  using Response = v1::SampleResponse;
  explicit SampleAnswerer(const WaterHost& host) : sampler_(host) {}
  static bool read(grpc::ByteBuffer& bytes, Request& request) {
    return PointSampler::read(bytes, request);
  }
  Lane lane(const Request& request) const { return PointSampler::laneOf(request); }
  Outcome answer(const Request& request, Response& response, const CallWatch& watch) {
    return {.points = sampler_.sample(request, response, watch)};
  }
  void ended() {}

 private:
  PointSampler sampler_;
};

class PosesAnswerer {
 public:
  using Request = v1::PosesRequest;
  using Response = v1::PosesResponse;
  explicit PosesAnswerer(WaterHost& host) : poses_(host) {}
  Lane lane(const Request&) const { return Lane::here; }
  Outcome answer(const Request& request, Response& response, const CallWatch&) {
    poses_.submit(request, response);
    return {.refused = static_cast<std::size_t>(response.ignored_size())};
  }
  void ended() { poses_.leave(); }

 private:
  PoseStream poses_;
};

class StepAnswerer {
 public:
  using Request = v1::StepRequest;
  using Response = v1::StepResponse;
  explicit StepAnswerer(WaterHost& host) : step_(host) {}
  Lane lane(const Request&) const { return Lane::here; }
  Outcome answer(const Request& request, Response& response, const CallWatch&) {
    constexpr std::chrono::milliseconds there{0}, notYet{2};
    return {.again = step_.isThere(request, response) ? there : notYet};
  }
  void ended() { step_.forget(); }

 private:
  WakeStep step_;
};

/// What keeps nothing between requests, as a function of the host.
template <class RequestOf, class ResponseOf, Lane where, auto function>
class PlainAnswerer {
 public:
  using Request = RequestOf;
  using Response = ResponseOf;
  explicit PlainAnswerer(WaterHost& host) : host_(&host) {}
  Lane lane(const Request&) const { return where; }
  Outcome answer(const Request& request, Response& response, const CallWatch& watch) {
    return function(*host_, request, response, watch);
  }
  void ended() {}

 private:
  WaterHost* host_;
};

Outcome render(WaterHost& host, const v1::RenderRequest& request, v1::RenderResponse& response,
               const CallWatch& watch) {
  drawPicture(host, request, response, watch);
  return {.frame = true};
}
Outcome tell(WaterHost& host, const v1::DescribeRequest&, v1::DescribeResponse& response,
             const CallWatch&) {
  describe(host, response);
  return {};
}
Outcome set(WaterHost& host, const v1::SetSeaStateRequest& request,
            v1::SetSeaStateResponse& response, const CallWatch&) {
  setSeaState(host, request, response);
  return {};
}

using RenderAnswerer = PlainAnswerer<v1::RenderRequest, v1::RenderResponse, Lane::slow, render>;
using DescribeAnswerer =
    PlainAnswerer<v1::DescribeRequest, v1::DescribeResponse, Lane::large, tell>;
using SetAnswerer = PlainAnswerer<v1::SetSeaStateRequest, v1::SetSeaStateResponse, Lane::slow, set>;

/// Adds methods one by one.
class Adder {
 public:
  Adder(RpcServer& server, WaterHost& host, RawWater& service)
      : server_(server), host_(host), service_(service) {}

  template <class Answerer, auto request>
  void unary() {
    const auto ask = [&service = service_](auto* context, auto* bytes, auto* writer, auto* queue,
                                           void* tag) {
      (service.*request)(context, bytes, writer, queue, queue, tag);
    };
    server_.add(std::make_unique<UnaryMethod<Answerer>>(server_.host(), ask, maker<Answerer>()));
  }
  template <class Answerer, auto request>
  void stream() {
    const auto ask = [&service = service_](auto* context, auto* stream, auto* queue, void* tag) {
      (service.*request)(context, stream, queue, queue, tag);
    };
    server_.add(std::make_unique<StreamMethod<Answerer>>(server_.host(), ask, maker<Answerer>()));
  }

 private:
  template <class Answerer>
  std::function<Answerer()> maker() const {
    return [&host = host_] { return Answerer(host); };
  }
  RpcServer& server_;
  WaterHost& host_;
  RawWater& service_;
};

}  // namespace

void addWaterService(RpcServer& server, WaterHost& host) {
  auto service = std::make_unique<RawWater>();
  Adder adder(server, host, *service);
  adder.unary<SampleAnswerer, &RawWater::RequestSample>();
  adder.stream<SampleAnswerer, &RawWater::RequestSampleStream>();
  adder.stream<PosesAnswerer, &RawWater::RequestSubmitPoses>();
  adder.unary<StepAnswerer, &RawWater::RequestStep>();
  adder.unary<RenderAnswerer, &RawWater::RequestRender>();
  adder.unary<DescribeAnswerer, &RawWater::RequestDescribe>();
  adder.unary<SetAnswerer, &RawWater::RequestSetSeaState>();
  server.add(std::move(service), Water::service_full_name());
}

}  // namespace seaway::bridge::rpc
