#include "sim_bridge/grpc/water_service.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "sim_bridge/scene/sea_state_file.h"
#include "surface/water_kinematics.h"
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

SampleResponse sample(const SampleRequest& request, ServedWater& water = served()) {
  Context context;
  SampleResponse response;
  const grpc::Status status = water.stub()->Sample(&context, request, &response);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return response;
}

grpc::Status refusal(const SampleRequest& request, ServedWater& water = served()) {
  Context context;
  SampleResponse response;
  return water.stub()->Sample(&context, request, &response);
}

TEST(WaterService, HeightsAreTheLibrarysToTheBit) {
  // More than a piece, so that pieces are put together too.
  for (const std::size_t count :
       {std::size_t{0}, std::size_t{1}, std::size_t{1000}, std::size_t{10000}}) {
    SampleRequest request = planeRequest(12.5, count);
    request.set_id(77);
    const auto places = test::placesOf(request);
    std::vector<SurfaceSample> samples(count);
    served().waters.sea.surface()->sample(places, 12.5, samples);
    const SampleResponse response = sample(request);
    EXPECT_EQ(response.id(), 77u);
    EXPECT_EQ(response.time_s(), 12.5);
    ASSERT_EQ(static_cast<std::size_t>(response.height_m_size()), count);
    EXPECT_EQ(response.slope_east_size(), 0);
    EXPECT_EQ(response.status_size(), 0);
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_EQ(response.height_m(static_cast<int>(i)), samples[i].height);
    }
  }
}

TEST(WaterService, TakesSixDecimalsOfEveryQuantityAndTellsWhatAToleranceLeavesOut) {
  SampleRequest request = planeRequest(3.0, 200);
  for (const auto what : {QUANTITY_HEIGHT, QUANTITY_SLOPE, QUANTITY_VERTICAL_VELOCITY,
                          QUANTITY_ORBITAL_VELOCITY, QUANTITY_PRESSURE, QUANTITY_ERROR}) {
    request.add_quantities(what);
  }
  request.set_tolerance_m(0.05);
  const SampleOptions options{.tolerance = 0.05, .orbitalVelocity = true};
  const auto places = test::placesOf(request);
  std::vector<SurfaceSample> samples(places.size());
  served().waters.sea.surface()->sample(places, 3.0, samples, options);
  const SampleResponse response = sample(request);
  ASSERT_EQ(response.status_size(), 200);
  EXPECT_GT(response.largest_error_m(), 0.0);
  EXPECT_LE(response.largest_error_m(), 0.05);
  for (int i = 0; i < 200; ++i) {
    const SurfaceSample& truth = samples[static_cast<std::size_t>(i)];
    EXPECT_EQ(response.slope_east(i), static_cast<float>(truth.slope.x));
    EXPECT_EQ(response.slope_north(i), static_cast<float>(truth.slope.y));
    EXPECT_EQ(response.vertical_velocity_m_s(i), static_cast<float>(truth.verticalVelocity));
    EXPECT_EQ(response.velocity_east_m_s(i), static_cast<float>(truth.orbitalVelocity.x));
    EXPECT_EQ(response.velocity_north_m_s(i), static_cast<float>(truth.orbitalVelocity.y));
    EXPECT_EQ(response.velocity_up_m_s(i), static_cast<float>(truth.orbitalVelocity.z));
    EXPECT_EQ(response.error_m(i), static_cast<float>(truth.error));
    EXPECT_EQ(response.bound_m(i), static_cast<float>(truth.bound));
    EXPECT_EQ(response.pressure_pa(i), 0.0f);
    EXPECT_EQ(response.status(i), static_cast<std::uint32_t>(SampleStatus::truncated));
  }
}

TEST(WaterService, VelocityAndPressureAtAHeightAreThoseOfTheKinematics) {
  SampleRequest request = planeRequest(3.0, 50);
  request.add_quantities(QUANTITY_ORBITAL_VELOCITY);
  request.add_quantities(QUANTITY_PRESSURE);
  std::vector<glm::dvec3> points;
  for (const glm::dvec2 place : test::placesOf(request)) {
    points.emplace_back(place, points.empty() ? 50.0 : -0.2 * static_cast<double>(points.size()));
    request.add_height_m(points.back().z);
  }
  std::vector<WaterKinematics> truth(points.size());
  const auto surface = served().waters.sea.surface();
  sampleKinematics(surface->at(3.0), points, truth);
  const SampleResponse response = sample(request);
  ASSERT_EQ(response.pressure_pa_size(), 50);
  EXPECT_EQ(response.status(0), static_cast<std::uint32_t>(SampleStatus::aboveSurface));
  EXPECT_TRUE(std::isnan(response.pressure_pa(0)));
  for (int i = 10; i < 50; ++i) {
    const WaterKinematics& motion = truth[static_cast<std::size_t>(i)];
    EXPECT_EQ(response.velocity_east_m_s(i), static_cast<float>(motion.velocity.x));
    EXPECT_EQ(response.velocity_up_m_s(i), static_cast<float>(motion.velocity.z));
    EXPECT_EQ(response.pressure_pa(i), static_cast<float>(motion.pressure));
    EXPECT_EQ(response.dynamic_pressure_pa(i), static_cast<float>(motion.dynamicPressure));
  }
}

// PlanePlacer's half a millimetre, on slopes below 1; vectors turn with the meridian.
TEST(WaterService, GeodeticPointsAreThoseOfThePlaneWithVectorsToTrueEastAndNorth) {
  const Geodesy& geodesy = served().waters.sea.geodesy();
  const GeodeticPosition anchor = geodesy.anchor();
  SampleRequest request;
  request.set_time_s(8.0);
  request.add_quantities(QUANTITY_HEIGHT);
  request.add_quantities(QUANTITY_SLOPE);
  for (int i = 0; i < 20; ++i) {
    request.mutable_geodetic()->add_latitude_deg(anchor.latitude_deg + 1.5 + 1e-4 * i);
    request.mutable_geodetic()->add_longitude_deg(anchor.longitude_deg + 1.5);
  }
  const SampleResponse response = sample(request);
  ASSERT_EQ(response.height_m_size(), 20);
  for (int i = 0; i < 20; ++i) {
    const SeaPlanePoint point = geodesy.seaPlaneFromGeodetic(request.geodetic().latitude_deg(i),
                                                             request.geodetic().longitude_deg(i));
    const SurfaceSample truth = served().waters.sea.surface()->sample(point.position, 8.0);
    EXPECT_NEAR(response.height_m(i), truth.height, 5e-4);
    const double c = std::cos(point.convergence), s = std::sin(point.convergence);
    // Slopes change by less than 4 a metre: waves of 1 m and half a millimetre of place.
    EXPECT_NEAR(response.slope_east(i), c * truth.slope.x + s * truth.slope.y, 2e-3);
    EXPECT_NEAR(response.slope_north(i), c * truth.slope.y - s * truth.slope.x, 2e-3);
  }
}

TEST(WaterService, AStreamAnswersBatchAfterBatchInOrderAndTimeMayGoBack) {
  Context context;
  const auto stub = served().stub();
  const auto stream = stub->SampleStream(&context);
  const auto surface = served().waters.sea.surface();
  SampleResponse response;
  for (int i = 0; i < 50; ++i) {
    const double t = i % 2 ? 100.0 - i : -1e4 + i;
    SampleRequest request = planeRequest(t, static_cast<std::size_t>(1 + 131 * (i % 40)));
    request.set_id(static_cast<std::uint64_t>(i));
    ASSERT_TRUE(stream->Write(request));
    ASSERT_TRUE(stream->Read(&response));
    EXPECT_EQ(response.id(), static_cast<std::uint64_t>(i));
    EXPECT_EQ(response.height_m(0), surface->sample(test::placesOf(request)[0], t).height);
  }
  stream->WritesDone();
  EXPECT_FALSE(stream->Read(&response));
  EXPECT_TRUE(stream->Finish().ok());
}

TEST(WaterService, BadRequestsAreRefusedByFieldValueAndWhatIsAllowedAndCounted) {
  const auto before = served().refused(Refusal::badValue);
  const auto expect = [&](const SampleRequest& request, grpc::StatusCode code,
                          const std::string& text) {
    const grpc::Status status = refusal(request);
    EXPECT_EQ(status.error_code(), code) << status.error_message();
    EXPECT_NE(status.error_message().find(text), std::string::npos) << status.error_message();
  };
  using grpc::StatusCode;
  SampleRequest request;
  request.set_time_s(0.0);
  expect(request, StatusCode::INVALID_ARGUMENT, "points: nothing is not allowed; must be plane");
  request = planeRequest(0.0, 3);
  request.mutable_plane()->add_x_m(0.0);
  expect(request, StatusCode::INVALID_ARGUMENT, "plane.x_m, y_m: 4 and 3 values");
  request = planeRequest(0.0, 3);
  request.set_tolerance_m(-1.0);
  expect(request, StatusCode::INVALID_ARGUMENT, "tolerance_m: -1 is not allowed; must be >= 0");
  request.set_tolerance_m(0.0);
  request.set_shortest_wavelength_m(std::nan(""));
  expect(request, StatusCode::INVALID_ARGUMENT, "shortest_wavelength_m: nan is not allowed");
  request = planeRequest(0.0, 3);
  request.add_height_m(0.0);
  request.add_height_m(0.0);
  expect(request, StatusCode::INVALID_ARGUMENT, "height_m: 2 values is not allowed");
  request = planeRequest(0.0, 3);
  request.add_quantities(static_cast<Quantity>(9));
  expect(request, StatusCode::INVALID_ARGUMENT, "quantities: 9 is not allowed");
  request = planeRequest(0.0, 3);
  request.clear_time_s();
  expect(request, StatusCode::FAILED_PRECONDITION, "time_s: is missing");
  EXPECT_EQ(served().refused(Refusal::badValue) - before, 7u);
  request = planeRequest(0.0, 3);
  request.set_exclude_hull(4711);
  expect(request, StatusCode::NOT_FOUND, "exclude_hull: 4711 is no hull");
}

TEST(WaterService, WithAClockOfItsOwnARequestMayLeaveItsTimeOut) {
  ServedWater water(test::wakelessText(), {}, {}, "x2");
  SampleRequest request = planeRequest(0.0, 1);
  request.clear_time_s();
  const double first = sample(request, water).time_s();
  const double second = sample(request, water).time_s();
  EXPECT_GE(first, 0.0);
  EXPECT_GT(second, first);
}

TEST(WaterService, NaNAndFarPointsGetNaNAndAStatusAndTheOthersAreUnharmed) {
  const double nan = std::nan("");
  SampleRequest request = planeRequest(5.0, 6);
  request.mutable_plane()->set_x_m(2, nan);
  request.mutable_plane()->set_y_m(4, 1e13);
  request.add_quantities(QUANTITY_HEIGHT);
  request.add_quantities(QUANTITY_PRESSURE);
  request.add_height_m(-2.0);
  const SampleResponse response = sample(request);
  const SampleResponse all = sample(planeRequest(5.0, 6));
  for (int i = 0; i < 6; ++i) {
    if (i == 2 || i == 4) {
      EXPECT_TRUE(std::isnan(response.height_m(i)));
      EXPECT_TRUE(std::isnan(response.pressure_pa(i)));
      EXPECT_EQ(response.status(i) & (i == 2 ? STATUS_NOT_FINITE : STATUS_OUT_OF_RANGE),
                static_cast<unsigned>(i == 2 ? STATUS_NOT_FINITE : STATUS_OUT_OF_RANGE));
    } else {
      EXPECT_EQ(response.height_m(i), all.height_m(i));
      EXPECT_EQ(response.status(i), 0u);
    }
  }
  request.set_time_s(nan);
  const SampleResponse never = sample(request);
  EXPECT_TRUE(std::isnan(never.height_m(0)));
  EXPECT_TRUE(std::isnan(never.pressure_pa(0)));
  SampleRequest geodetic;
  geodetic.set_time_s(0.0);
  geodetic.mutable_geodetic()->add_latitude_deg(nan);
  geodetic.mutable_geodetic()->add_longitude_deg(0.0);
  EXPECT_TRUE(std::isnan(sample(geodetic).height_m(0)));
}

TEST(WaterService, DescribesWhatItServes) {
  Context context;
  DescribeResponse about;
  ASSERT_TRUE(served().stub()->Describe(&context, {}, &about).ok());
  const Scene& scene = served().waters.scene;
  EXPECT_EQ(about.version(), "0.1.0");
  EXPECT_EQ(about.anchor_latitude_deg(), scene.sea.anchor.latitude_deg);
  EXPECT_TRUE(std::isinf(about.depth_m()));
  ASSERT_EQ(about.vessels_size(), 1);
  EXPECT_EQ(about.vessels(0).name(), scene.vessels[0].name);
  EXPECT_EQ(about.cameras_size(), static_cast<int>(scene.cameras.size()));
  EXPECT_EQ(about.effects_size(), static_cast<int>(effectDescriptions().size()));
  EXPECT_FALSE(about.has_clock_s());
  EXPECT_EQ(about.limits().points(), 250000u);
  // H_m0 = 4√Σa² by construction; the fit keeps the height that is asked for (1.12 m).
  EXPECT_NEAR(about.sea().hm0_asked_m(), 1.12, 0.01);
  EXPECT_NEAR(about.sea().hm0_realised_m(), 1.12, 0.01);
  double squares = 0.0;
  for (const auto& octave : about.sea().octaves()) {
    squares += std::pow(octave.standard_deviation_m(), 2);
  }
  EXPECT_NEAR(4.0 * std::sqrt(squares), about.sea().hm0_realised_m(), 1e-9);
  EXPECT_EQ(about.sea().left_out_m_size(), about.sea().octaves_size());
  EXPECT_EQ(about.sea().left_out_m(about.sea().octaves_size() - 1), 0.0);
}

TEST(WaterService, SetsSeasByParametersAndOctavesAndGoesBackToTheScenes) {
  ServedWater water;
  const auto stub = water.stub();
  const auto set = [&](const SetSeaStateRequest& request) {
    Context context;
    SetSeaStateResponse response;
    const grpc::Status status = stub->SetSeaState(&context, request, &response);
    EXPECT_TRUE(status.ok()) << status.error_message();
    return response.sea();
  };
  const double before = sample(planeRequest(4.0, 1), water).height_m(0);
  SetSeaStateRequest request;
  request.mutable_jonswap()->set_hm0_m(2.5);
  request.mutable_jonswap()->set_tp_s(8.0);
  request.mutable_jonswap()->set_from_deg(90.0);
  request.mutable_jonswap()->set_spread_s(std::numeric_limits<double>::infinity());
  const auto jonswap = set(request);
  EXPECT_NEAR(jonswap.hm0_asked_m(), 2.5, 1e-3);
  EXPECT_NEAR(jonswap.hm0_realised_m(), 2.5, 0.025);
  EXPECT_NEAR(jonswap.peak_from_deg(), 90.0, 1e-6);
  // A crest at the anchor at t = 0: the amplitude, √2 times the standard deviation.
  request.Clear();
  v1::Octave& octave = *request.mutable_octaves()->add_octaves();
  octave.set_kind("regular");
  octave.set_standard_deviation_m(1.0);
  octave.set_frequency_hz(0.125);
  octave.set_toward_deg(0.0);
  EXPECT_NEAR(set(request).hm0_realised_m(), 4.0, 1e-12);
  SampleRequest anchor;
  anchor.set_time_s(0.0);
  anchor.mutable_plane()->add_x_m(0.0);
  anchor.mutable_plane()->add_y_m(0.0);
  EXPECT_NEAR(sample(anchor, water).height_m(0), std::sqrt(2.0), 1e-6);
  request.mutable_calm();
  EXPECT_EQ(set(request).hm0_realised_m(), 0.0);
  EXPECT_EQ(sample(anchor, water).height_m(0), 0.0);
  request.mutable_scene();
  set(request);
  EXPECT_EQ(sample(planeRequest(4.0, 1), water).height_m(0), before);
}

TEST(WaterService, SeasThatAreNotAllowedAreRefusedByKeyAndLeaveTheSeaAsItWas) {
  const double before = sample(planeRequest(4.0, 1)).height_m(0);
  const auto expect = [&](const SetSeaStateRequest& request, const std::string& text) {
    Context context;
    SetSeaStateResponse response;
    const grpc::Status status = served().stub()->SetSeaState(&context, request, &response);
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_NE(status.error_message().find(text), std::string::npos) << status.error_message();
  };
  SetSeaStateRequest request;
  expect(request, "state: nothing is not allowed; must be one of: scene, calm");
  request.mutable_jonswap()->set_hm0_m(-1.0);
  expect(request, "key 'jonswap.hm0_m': -1");
  request.mutable_jonswap()->set_hm0_m(std::nan(""));
  expect(request, "key 'jonswap.hm0_m'");
  request.mutable_jonswap()->set_hm0_m(1.0);
  expect(request, "lacks 'tp_s'");
  request.mutable_wmo()->set_state(12);
  request.mutable_wmo()->set_from_deg(0.0);
  expect(request, "key 'wmo.state': 12 is not allowed");
  request.mutable_octaves()->add_octaves()->set_kind("square");
  expect(request, "must be one of: perlin, group, regular");
  EXPECT_EQ(sample(planeRequest(4.0, 1)).height_m(0), before);
}

TEST(WaterService, DrawsThePictureOfTheFrameMakerAsPngAndAsRawBytesWithDepth) {
  RenderRequest request;
  request.set_time_s(1.0);
  request.set_width(64);
  request.set_height(40);
  request.set_format(PICTURE_FORMAT_RGB8);
  request.set_depth(true);
  const auto stub = served().stub();
  Context context, another;
  RenderResponse raw, png;
  const grpc::Status status = stub->Render(&context, request, &raw);
  ASSERT_TRUE(status.ok()) << status.error_message();
  const auto frame = served().frames.draw({.t = 1.0, .size = {64, 40}});
  ASSERT_EQ(raw.picture().size(), 64u * 40u * 3u);
  EXPECT_TRUE(raw.picture() == std::string(frame->colour.rgb.begin(), frame->colour.rgb.end()));
  ASSERT_EQ(raw.depth_m_size(), 64 * 40);
  EXPECT_TRUE(std::equal(raw.depth_m().begin(), raw.depth_m().end(), frame->depth.metres.begin()));
  request.set_format(PICTURE_FORMAT_PNG);
  request.set_depth(false);
  request.mutable_free()->set_latitude_deg(served().waters.scene.sea.anchor.latitude_deg);
  request.mutable_free()->set_longitude_deg(served().waters.scene.sea.anchor.longitude_deg);
  request.mutable_free()->set_height_m(20.0);
  ASSERT_TRUE(stub->Render(&another, request, &png).ok());
  EXPECT_EQ(png.picture().substr(1, 3), "PNG");
  EXPECT_EQ(png.depth_m_size(), 0);
}

TEST(WaterService, PicturesThatCannotBeAreRefused) {
  const auto expect = [&](const RenderRequest& request, grpc::StatusCode code,
                          const std::string& text) {
    Context context;
    RenderResponse response;
    const grpc::Status status = served().stub()->Render(&context, request, &response);
    EXPECT_EQ(status.error_code(), code);
    EXPECT_NE(status.error_message().find(text), std::string::npos) << status.error_message();
  };
  RenderRequest request;
  request.set_time_s(0.0);
  request.set_camera("crow");
  expect(request, grpc::StatusCode::NOT_FOUND, "camera: 'crow' is not there; must be one of: ");
  request.clear_camera();
  request.set_width(5000);
  request.set_height(10);
  expect(request, grpc::StatusCode::INVALID_ARGUMENT, "width: 5000 is not allowed");
  request.set_width(10);
  request.mutable_free()->set_fov_deg(500.0);
  expect(request, grpc::StatusCode::INVALID_ARGUMENT, "free.fov_deg");
}

}  // namespace
}  // namespace seaway::bridge
