#include <grpcpp/generic/generic_stub.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

#include "tests/sim_bridge/grpc/raw_host.h"
#include "tests/sim_bridge/grpc/served_waves.h"

// Whatever is refused is counted, once and by its reason.
namespace seaway::bridge {
namespace {

using namespace v1;
using test::Context;
using test::expectServed;
using test::planeRequest;
using test::ServedWater;
using test::ServedWaves;

struct Refused {
  const char* what;
  Refusal why;
  std::function<void()> provoke;
};

std::uint64_t sumOf(const MeterCounts& counts) {
  std::uint64_t sum = 0;
  for (const std::uint64_t each : counts.refusals) sum += each;
  return sum;
}

// A refusal is counted before it is sent.
void expectEachCounted(Meter& meter, const std::vector<Refused>& all) {
  for (const Refused& each : all) {
    const MeterCounts before = meter.read();
    each.provoke();
    const MeterCounts after = meter.read();
    const auto why = static_cast<std::size_t>(each.why);
    EXPECT_EQ(after.refusals[why] - before.refusals[why], 1u) << each.what;
    EXPECT_EQ(sumOf(after) - sumOf(before), 1u) << each.what;
  }
}

constexpr int messageLimit = 1 << 16;

/// Hosts of one server that ask for what cannot be.
class Asker {
 public:
  explicit Asker(ServedWater& water) : stub_(water.stub()) {}

  std::function<void()> sample(std::function<void(SampleRequest&)> spoil) {
    return [this, spoil] {
      SampleRequest request = planeRequest(0.0, 3);
      spoil(request);
      Context context;
      SampleResponse response;
      EXPECT_FALSE(stub_->Sample(&context, request, &response).ok());
    };
  }
  std::function<void()> sampleStream(std::function<void(SampleRequest&)> spoil) {
    return [this, spoil] {
      SampleRequest request = planeRequest(0.0, 3);
      spoil(request);
      Context context;
      const auto stream = stub_->SampleStream(&context);
      SampleResponse response;
      stream->Write(request);
      EXPECT_FALSE(stream->Read(&response));
      EXPECT_FALSE(stream->Finish().ok());
    };
  }
  std::function<void()> poses(std::function<void(PosesRequest&)> spoil, bool ends = true) {
    return [=, this] {
      PosesRequest request;
      request.set_time_s(1.0);
      v1::HullPose& pose = *request.add_hulls();
      pose.set_name("mine");
      pose.set_vessel("pilot");
      spoil(request);
      Context context;
      const auto stream = stub_->SubmitPoses(&context);
      PosesResponse response;
      stream->Write(request);
      EXPECT_EQ(stream->Read(&response), !ends);
      stream->WritesDone();
      EXPECT_EQ(stream->Finish().ok(), !ends);
    };
  }
  std::function<void()> step(std::function<void(StepRequest&)> spoil) {
    return [this, spoil] {
      StepRequest request;
      request.set_time_s(1.0);
      request.add_places();
      spoil(request);
      Context context;
      StepResponse response;
      EXPECT_FALSE(stub_->Step(&context, request, &response).ok());
    };
  }
  std::function<void()> render(std::function<void(RenderRequest&)> spoil) {
    return [this, spoil] {
      RenderRequest request;
      request.set_time_s(1.0);
      request.set_width(8);
      request.set_height(8);
      spoil(request);
      Context context;
      RenderResponse response;
      EXPECT_FALSE(stub_->Render(&context, request, &response).ok());
    };
  }
  std::function<void()> setSea(std::function<void(SetSeaStateRequest&)> spoil) {
    return [this, spoil] {
      SetSeaStateRequest request;
      spoil(request);
      Context context;
      SetSeaStateResponse response;
      EXPECT_FALSE(stub_->SetSeaState(&context, request, &response).ok());
    };
  }

 private:
  std::unique_ptr<Water::Stub> stub_;
};

TEST(RefusalsGrpcHard, EveryOneOfEachMethodIsCountedByItsReason) {
  rpc::RpcServerOptions options;
  options.mostMessageBytes = messageLimit;
  rpc::WaterLimits limits;
  limits.points = 1000;
  limits.hulls = 2;
  limits.places = 3;
  limits.octaves = 2;
  ServedWater water(test::pilotScene("effects: {wake: off}\n"), limits, options);
  Asker ask(water);
  const double nan = std::nan("");
  const auto tooManyPoints = [](auto& r) { r = planeRequest(0.0, 1001); };
  const auto tooLong = [](auto& r) { r = planeRequest(0.0, 5000); };
  const std::vector<Refused> all{
      {"no points", Refusal::badValue, ask.sample([](auto& r) { r.clear_plane(); })},
      {"x without y", Refusal::badValue,
       ask.sample([](auto& r) { r.mutable_plane()->add_x_m(0); })},
      {"tolerance", Refusal::badValue, ask.sample([](auto& r) { r.set_tolerance_m(-1); })},
      {"wavelength", Refusal::badValue,
       ask.sample([=](auto& r) { r.set_shortest_wavelength_m(nan); })},
      {"quantity", Refusal::badValue,
       ask.sample([](auto& r) { r.add_quantities(static_cast<Quantity>(9)); })},
      {"heights", Refusal::badValue,
       ask.sample([](auto& r) { r.add_height_m(0), r.add_height_m(0); })},
      {"no time", Refusal::badValue, ask.sample([](auto& r) { r.clear_time_s(); })},
      {"own hull", Refusal::notFound, ask.sample([](auto& r) { r.set_exclude_hull(4711); })},
      {"points", Refusal::tooLarge, ask.sample(tooManyPoints)},
      {"message", Refusal::tooLarge, ask.sample(tooLong)},
      {"stream: tolerance", Refusal::badValue,
       ask.sampleStream([](auto& r) { r.set_tolerance_m(-1); })},
      {"stream: points", Refusal::tooLarge, ask.sampleStream(tooManyPoints)},
      {"stream: message", Refusal::tooLarge, ask.sampleStream(tooLong)},
      {"pose", Refusal::badValue,
       ask.poses([=](auto& r) { r.mutable_hulls(0)->set_roll_deg(nan); })},
      {"pose's vessel", Refusal::notFound,
       ask.poses([](auto& r) { r.mutable_hulls(0)->set_vessel("galleon"); })},
      {"pose's name twice", Refusal::badValue,
       ask.poses([](auto& r) { *r.add_hulls() = r.hulls(0); })},
      {"hulls", Refusal::tooLarge, ask.poses([](auto& r) {
         for (const char* name : {"b", "c"})
           *r.add_hulls() = r.hulls(0), r.mutable_hulls(r.hulls_size() - 1)->set_name(name);
       })},
      {"pose that is ignored", Refusal::badValue,
       ask.poses([](auto& r) { r.mutable_hulls(0)->set_latitude_deg(60.0); }, false)},
      {"step's time", Refusal::badValue, ask.step([=](auto& r) { r.set_time_s(nan); })},
      {"step's place", Refusal::badValue,
       ask.step([=](auto& r) { r.mutable_places(0)->set_x_m(nan); })},
      {"step's radius", Refusal::badValue,
       ask.step([](auto& r) { r.mutable_places(0)->set_radius_m(-1); })},
      {"step's hull", Refusal::notFound,
       ask.step([](auto& r) { r.mutable_places(0)->set_hull(4711); })},
      {"places", Refusal::tooLarge,
       ask.step([](auto& r) { r.add_places(), r.add_places(), r.add_places(); })},
      {"camera", Refusal::notFound, ask.render([](auto& r) { r.set_camera("crow"); })},
      {"picture's size", Refusal::badValue, ask.render([](auto& r) { r.set_width(5000); })},
      {"picture's format", Refusal::badValue,
       ask.render([](auto& r) { r.set_format(static_cast<PictureFormat>(7)); })},
      {"field of view", Refusal::badValue,
       ask.render([](auto& r) { r.mutable_free()->set_fov_deg(500); })},
      {"picture's time", Refusal::badValue, ask.render([=](auto& r) { r.set_time_s(nan); })},
      {"no sea", Refusal::badValue, ask.setSea([](auto&) {})},
      {"sea's height", Refusal::badValue,
       ask.setSea([](auto& r) { r.mutable_jonswap()->set_hm0_m(-1); })},
  };
  expectEachCounted(water.meter(), all);
}

TEST(RefusalsGrpcHard, CallsWithoutATokenAreCounted) {
  rpc::RpcServerOptions options;
  options.token = "secret";
  ServedWater water(test::wakelessText(), {}, options);
  const auto stub = water.stub();
  const auto call = [&](bool hasToken, int milliseconds) {
    grpc::ClientContext context;
    if (hasToken) context.AddMetadata("authorization", "Bearer secret");
    context.set_deadline(std::chrono::system_clock::now() +
                         std::chrono::milliseconds(milliseconds));
    SampleResponse response;
    return stub->Sample(&context, planeRequest(0.0, 3), &response).error_code();
  };
  expectEachCounted(water.meter(),
                    {{"token", Refusal::notAuthorised,
                      [&] { EXPECT_EQ(call(false, 60000), grpc::StatusCode::UNAUTHENTICATED); }}});
  EXPECT_EQ(call(true, 60000), grpc::StatusCode::OK);
}

/// A call by name of a method that nobody here has a stub for.
grpc::Status called(grpc::GenericStub& stub, const std::string& method) {
  Context context;
  grpc::CompletionQueue queue;
  grpc::ByteBuffer response;
  grpc::Status status;
  const auto call = stub.PrepareUnaryCall(&context, method, grpc::ByteBuffer(), &queue);
  call->StartCall();
  call->Finish(&response, &status, nullptr);
  void* tag = nullptr;
  bool ok = false;
  EXPECT_TRUE(queue.Next(&tag, &ok));
  return status;
}

TEST(RefusalsGrpcHard, CallsOfUnknownMethodsAndServicesAreCounted) {
  ServedWater water;
  grpc::GenericStub stub(water.channel());
  std::vector<Refused> all;
  for (const char* method : {"/seaway.v1.Water/Boil", "/seaway.v2.Water/Sample", "/nobody/here",
                             "/grpc.health.v1.Health/Cure"}) {
    all.push_back({method, Refusal::notFound, [&stub, method] {
                     const grpc::Status status = called(stub, method);
                     EXPECT_EQ(status.error_code(), grpc::StatusCode::UNIMPLEMENTED);
                     EXPECT_NE(status.error_message().find(method), std::string::npos);
                   }});
  }
  all.push_back({"another service of ours", Refusal::notFound, [&] {
                   Context context;
                   const auto waves = Waves::NewStub(water.channel());
                   XYZTGrid answer;
                   const auto status = waves->elevations(&context, XYTGrid(), &answer);
                   EXPECT_EQ(status.error_code(), grpc::StatusCode::UNIMPLEMENTED);
                 }});
  // More than are listened for at once.
  for (int round = 0; round < 40; ++round) expectEachCounted(water.meter(), all);
  expectServed(water);
}

// Far beyond what gRPC's own limit is by default, 4 MiB.
TEST(RefusalsGrpcHard, MessagesOfAnyLengthBeyondTheLimitAreCounted) {
  rpc::RpcServerOptions options;
  options.mostMessageBytes = messageLimit;
  ServedWater water(test::wakelessText(), {}, options);
  Asker ask(water);
  std::vector<Refused> all;
  for (const std::size_t points : {5000u, 10000u, 2'000'000u}) {
    const auto tooLong = [points](auto& r) { r = planeRequest(0.0, points); };
    all.push_back({"alone", Refusal::tooLarge, ask.sample(tooLong)});
    all.push_back({"on a stream", Refusal::tooLarge, ask.sampleStream(tooLong)});
  }
  expectEachCounted(water.meter(), all);
  expectServed(water);
}

TEST(RefusalsXdynHard, EveryOneIsCountedByItsReason) {
  ServedWaves served;
  XYTGrid uneven, many;
  uneven.add_x(1.0);
  for (int i = 0; i < 1001; ++i) many.add_x(0.0), many.add_y(0.0);
  XYZTGrid without;
  without.add_x(1.0), without.add_y(1.0);
  SpectrumRequest nowhere;
  nowhere.set_x(std::nan(""));
  const auto refuses = [&](auto method, const auto& request, auto response) {
    return [=, &served] {
      Context context;
      auto answer = response;
      EXPECT_FALSE((served.stub.get()->*method)(&context, request, &answer).ok());
    };
  };
  const std::vector<Refused> all{
      {"uneven", Refusal::badValue, refuses(&Waves::Stub::elevations, uneven, XYZTGrid())},
      {"many", Refusal::tooLarge, refuses(&Waves::Stub::elevations, many, XYZTGrid())},
      {"pressures without z", Refusal::badValue,
       refuses(&Waves::Stub::dynamic_pressures, without, DynamicPressuresResponse())},
      {"velocities without z", Refusal::badValue,
       refuses(&Waves::Stub::orbital_velocities, without, OrbitalVelocitiesResponse())},
      {"spectrum nowhere", Refusal::badValue,
       refuses(&Waves::Stub::spectrum, nowhere, SpectrumResponse())},
      {"parameters, told in the answer", Refusal::badValue,
       [&] {
         Context context;
         SetParameterRequest request;
         request.set_parameters("jonswap: {hm0_m: -2}");
         SetParameterResponse response;
         EXPECT_TRUE(served.stub->set_parameters(&context, request, &response).ok());
         EXPECT_FALSE(response.error_message().empty());
       }},
  };
  expectEachCounted(served.waters.sea.meters().of("xdyn"), all);
}

}  // namespace
}  // namespace seaway::bridge
