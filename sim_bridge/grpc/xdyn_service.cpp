#include "sim_bridge/grpc/xdyn_waves.h"
#include "wave_grpc.grpc.pb.h"

namespace seaway::bridge::rpc {
namespace {

template <class Service>
using Raw = Waves::WithRawMethod_set_parameters<Waves::WithRawMethod_elevations<
    Waves::WithRawMethod_dynamic_pressures<Waves::WithRawMethod_orbital_velocities<
        Waves::WithRawMethod_spectrum<Waves::WithRawMethod_angular_frequencies_for_rao<
            Waves::WithRawMethod_directions_for_rao<Service>>>>>>>;
using RawWaves = Raw<Waves::Service>;

template <class Request>
std::size_t pointsOf(const Request& request) {
  if constexpr (requires { request.x_size(); }) {
    return static_cast<std::size_t>(request.x_size());
  } else {
    return 0;
  }
}

/// xdyn is told of bad parameters in the answer.
template <class Response>
std::size_t refusedIn(const Response& response) {
  if constexpr (requires { response.error_message(); }) {
    return response.error_message().empty() ? 0 : 1;
  } else {
    return 0;
  }
}

template <class RequestOf, class ResponseOf, Lane where, auto function>
class Answerer {
 public:
  using Request = RequestOf;
  using Response = ResponseOf;
  explicit Answerer(XdynWaves& waves) : waves_(&waves) {}
  Lane lane(const Request& request) const {
    return pointsOf(request) > smallest ? Lane::large : where;
  }
  Outcome answer(const Request& request, Response& response, const CallWatch& watch) {
    function(*waves_, request, response, watch);
    return {.points = pointsOf(request), .refused = refusedIn(response)};
  }
  void ended() {}

 private:
  static constexpr std::size_t smallest = 4096;  // a fraction of a millisecond
  XdynWaves* waves_;
};

class Adder {
 public:
  Adder(RpcServer& server, XdynWaves& waves, RawWaves& service)
      : server_(server), waves_(waves), service_(service) {}

  template <class Request, class Response, auto ask, Lane where, class Function>
  void add(Function) {
    using Answers = Answerer<Request, Response, where, Function{}>;
    const auto listen = [&service = service_](auto* context, auto* bytes, auto* writer, auto* queue,
                                              void* tag) {
      (service.*ask)(context, bytes, writer, queue, queue, tag);
    };
    server_.add(std::make_unique<UnaryMethod<Answers>>(
        server_.host(), listen, [&waves = waves_] { return Answers(waves); }));
  }

 private:
  RpcServer& server_;
  XdynWaves& waves_;
  RawWaves& service_;
};

}  // namespace

void addXdynService(RpcServer& server, XdynWaves& waves) {
  using R = RawWaves;
  auto service = std::make_unique<RawWaves>();
  Adder adder(server, waves, *service);
  adder.add<SetParameterRequest, SetParameterResponse, &R::Requestset_parameters, Lane::slow>(
      [](XdynWaves& w, const auto& q, auto& a, const CallWatch&) { w.setParameters(q, a); });
  adder.add<XYTGrid, XYZTGrid, &R::Requestelevations, Lane::here>(
      [](XdynWaves& w, const auto& q, auto& a, const CallWatch& c) { w.elevations(q, a, c); });
  adder.add<XYZTGrid, DynamicPressuresResponse, &R::Requestdynamic_pressures, Lane::here>(
      [](XdynWaves& w, const auto& q, auto& a, const CallWatch& c) { w.pressures(q, a, c); });
  adder.add<XYZTGrid, OrbitalVelocitiesResponse, &R::Requestorbital_velocities, Lane::here>(
      [](XdynWaves& w, const auto& q, auto& a, const CallWatch& c) { w.velocities(q, a, c); });
  adder.add<SpectrumRequest, SpectrumResponse, &R::Requestspectrum, Lane::here>(
      [](XdynWaves& w, const auto& q, auto& a, const CallWatch&) { w.spectrum(q, a); });
  adder.add<AngularFrequenciesRequest, AngularFrequenciesResponse,
            &R::Requestangular_frequencies_for_rao, Lane::here>(
      [](XdynWaves& w, const auto&, auto& a, const CallWatch&) { w.frequencies(a); });
  adder.add<DirectionsRequest, DirectionsResponse, &R::Requestdirections_for_rao, Lane::here>(
      [](XdynWaves& w, const auto&, auto& a, const CallWatch&) { w.directions(a); });
  server.add(std::move(service), Waves::service_full_name());
}

}  // namespace seaway::bridge::rpc
