#include "sim_bridge/grpc/pose_stream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <future>
#include <map>

#include "tests/sim_bridge/grpc/served_water.h"

namespace seaway::bridge {
namespace {

using namespace v1;
using test::Context;
using test::planeRequest;
using test::ServedWater;

// A service for all tests that do not change it.
ServedWater& served() {
  static ServedWater water;
  return water;
}

SampleResponse sample(const SampleRequest& request, ServedWater& water) {
  Context context;
  SampleResponse response;
  const grpc::Status status = water.stub()->Sample(&context, request, &response);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return response;
}

grpc::Status refusal(const SampleRequest& request, ServedWater& water) {
  Context context;
  SampleResponse response;
  return water.stub()->Sample(&context, request, &response);
}

v1::HullPose poseNamed(const std::string& name, double north, const std::string& vessel = "pilot") {
  v1::HullPose pose;
  pose.set_name(name);
  pose.set_vessel(vessel);
  pose.set_latitude_deg(1e-5 * north);
  return pose;
}

TEST(PoseStreams, HullsAreThereWhileTheStreamIsOpenAndMakeWavesThatTheyThemselvesLeaveOut) {
  ServedWater water(test::pilotScene());
  const auto stub = water.stub();
  Context context;
  const auto stream = stub->SubmitPoses(&context);
  PosesRequest request;
  PosesResponse response;
  // A pilot boat at 6 m/s, five times a second.
  const double stepNorth = 6.0 * 0.2 / 110574.0 / 1e-5;
  for (int i = 0; i <= 40; ++i) {
    request.Clear();
    request.set_id(static_cast<std::uint64_t>(i));
    request.set_time_s(0.2 * i);
    *request.add_hulls() = poseNamed("mine", stepNorth * i);
    ASSERT_TRUE(stream->Write(request));
    ASSERT_TRUE(stream->Read(&response));
    ASSERT_EQ(response.id(), static_cast<std::uint64_t>(i));
  }
  ASSERT_EQ(response.hulls_size(), 1);
  const std::uint32_t hull = response.hulls(0).hull();
  EXPECT_EQ(response.ignored_size(), 0);
  EXPECT_EQ(water.waters.sea.hulls(8.0).at(0).hull, hull);

  // Wakes come when somebody steps there.
  StepRequest step;
  step.set_time_s(8.0);
  step.set_wait(true);
  v1::Place& place = *step.add_places();
  place.set_y_m(40.0);
  place.set_radius_m(20.0);
  StepResponse there;
  Context stepping;
  const grpc::Status status = stub->Step(&stepping, step, &there);
  ASSERT_TRUE(status.ok()) << status.error_message();
  ASSERT_TRUE(there.has_wakes_from_s());
  EXPECT_LE(there.wakes_from_s(), 8.0);
  EXPECT_GE(there.wakes_to_s(), 8.0);
  SampleRequest sampling = planeRequest(8.0, 97, 0.5);
  for (int i = 0; i < 97; ++i) {
    sampling.mutable_plane()->set_x_m(i, -24.0 + 0.5 * i);
    sampling.mutable_plane()->set_y_m(i, 40.0);
  }
  const auto largest = [&] {
    const SampleResponse answer = sample(sampling, water);
    double most = 0.0;
    for (const double height : answer.height_m()) most = std::max(most, std::abs(height));
    return most;
  };
  EXPECT_GT(largest(), 0.01);  // the sea is calm but for wakes
  sampling.set_exclude_hull(hull);
  // The scene's own pilot boat gave way to the host's; the buoy is moored.
  EXPECT_LT(largest(), 1e-6);

  stream->WritesDone();
  EXPECT_TRUE(stream->Finish().ok());
  EXPECT_TRUE(test::eventually([&] { return water.host.hulls.size() == 0; }));
  EXPECT_EQ(water.waters.sea.hulls(8.0).at(0).hull, 0u);
  EXPECT_EQ(refusal(sampling, water).error_code(), grpc::StatusCode::NOT_FOUND);
}

TEST(PoseStreams, AHullGoesWhereItsHostSaysAndOtherStreamsHullsStay) {
  ServedWater water(test::pilotScene());
  const auto stub = water.stub();
  Context first, second;
  const auto one = stub->SubmitPoses(&first), two = stub->SubmitPoses(&second);
  PosesRequest request;
  PosesResponse response;
  request.set_time_s(1.0);
  *request.add_hulls() = poseNamed("a", 0.0);
  *request.add_hulls() = poseNamed("b", 10.0, "buoy");
  ASSERT_TRUE(one->Write(request) && one->Read(&response));
  EXPECT_EQ(response.hulls_size(), 2);
  request.mutable_hulls()->RemoveLast();
  ASSERT_TRUE(two->Write(request) && two->Read(&response));
  EXPECT_EQ(response.hulls_size(), 1);
  EXPECT_EQ(water.host.hulls.size(), 3u);
  request.mutable_hulls(0)->set_gone(true);
  ASSERT_TRUE(one->Write(request) && one->Read(&response));
  ASSERT_EQ(response.hulls_size(), 1);
  EXPECT_EQ(response.hulls(0).name(), "b");
  // The same time again: it stays where it was.
  request.mutable_hulls(0)->set_gone(false);
  ASSERT_TRUE(two->Write(request) && two->Read(&response));
  EXPECT_EQ(response.ignored_size(), 1);
  two->WritesDone();
  EXPECT_TRUE(two->Finish().ok());
  EXPECT_TRUE(test::eventually([&] { return water.host.hulls.size() == 1; }));
}

TEST(PoseStreams, BadPosesEndTheStreamAndNameTheirField) {
  const auto expect = [&](const PosesRequest& request, const std::string& text) {
    Context context;
    const auto stub = served().stub();
    const auto stream = stub->SubmitPoses(&context);
    PosesResponse response;
    stream->Write(request);
    EXPECT_FALSE(stream->Read(&response));
    const grpc::Status status = stream->Finish();
    EXPECT_NE(status.error_message().find(text), std::string::npos) << status.error_message();
    EXPECT_TRUE(test::eventually([&] { return served().host.hulls.size() == 0; }));
  };
  PosesRequest request;
  request.set_time_s(0.0);
  *request.add_hulls() = poseNamed("x", 0.0, "galleon");
  expect(request, "hulls[0].vessel: 'galleon' is no vessel of the scene; must be one of: ");
  *request.mutable_hulls(0) = poseNamed("x", 0.0, served().waters.scene.vessels[0].name);
  request.mutable_hulls(0)->set_latitude_deg(std::nan(""));
  expect(request, "hulls[0].latitude_deg: nan is not allowed; must be in [-90, 90]");
  request.mutable_hulls(0)->set_latitude_deg(0.0);
  *request.add_hulls() = request.hulls(0);
  expect(request, "hulls[1].name");
  request.mutable_hulls()->RemoveLast();
  for (int i = 0; i < 65; ++i) {
    *request.add_hulls() = request.hulls(0);
    request.mutable_hulls(i + 1)->set_name("n" + std::to_string(i));
  }
  expect(request, "hulls: 66 are not allowed in one stream; at most 64");
}

TEST(PoseStreams, AStepThatTheServersEndOvertakesIsDoneOrRefused) {
  // A large window: a quarter of a second of work, or more.
  std::string text = test::pilotScene();
  const std::string small = "{cell_m: 1, window_m: 128}";
  text.replace(text.find(small), small.size(), "{cell_m: 0.5, window_m: 512}");
  ServedWater water(text);
  const auto stub = water.stub();
  Context context;
  StepRequest request;
  StepResponse response;
  request.set_time_s(1200.0);
  request.set_wait(true);
  v1::Place& place = *request.add_places();
  place.set_y_m(6000.0);
  place.set_radius_m(20.0);
  auto status =
      std::async(std::launch::async, [&] { return stub->Step(&context, request, &response); });
  status.wait_for(std::chrono::milliseconds(100));  // the step is under way, or done
  water.server->stop();
  if (const grpc::Status got = status.get(); !got.ok()) {
    // Half a second was not enough. Whether the status or the end of the connection comes first is
    // gRPC's.
    EXPECT_TRUE(got.error_code() == grpc::StatusCode::CANCELLED ||
                got.error_code() == grpc::StatusCode::UNAVAILABLE)
        << got.error_message();
  } else {
    EXPECT_EQ(response.time_s(), 1200.0);
    EXPECT_GE(response.wakes_to_s(), 1200.0);
  }
}

TEST(PoseStreams, WithoutWakesAStepIsDoneAtOnce) {
  Context context;
  StepRequest request;
  StepResponse response;
  request.set_time_s(1e6);
  request.set_wait(true);
  ServedWater water;
  ASSERT_TRUE(water.stub()->Step(&context, request, &response).ok());
  EXPECT_EQ(response.time_s(), 1e6);
  EXPECT_FALSE(response.has_wakes_from_s());
}

}  // namespace
}  // namespace seaway::bridge
