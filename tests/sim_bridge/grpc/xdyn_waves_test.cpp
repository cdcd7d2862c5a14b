#include "sim_bridge/grpc/xdyn_waves.h"

#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim_bridge/grpc/xdyn_spectrum.h"
#include "surface/water_kinematics.h"
#include "tests/sim_bridge/grpc/served_waves.h"

namespace seaway::bridge {
namespace {

using test::Context;
using test::ServedWaves;

TEST(XdynWaves, ElevationsAreOurHeightsDownwardsWithXNorthAndYEast) {
  ServedWaves served;
  XYTGrid request;
  request.set_t(7.5);
  for (int i = 0; i < 300; ++i) {
    request.add_x(1.7 * i - 100.0);
    request.add_y(-3.1 * i);
  }
  Context context;
  XYZTGrid response;
  ASSERT_TRUE(served.stub->elevations(&context, request, &response).ok());
  EXPECT_EQ(response.t(), 7.5);
  ASSERT_EQ(response.z_size(), 300);
  ASSERT_EQ(response.x_size(), 300);
  const auto surface = served.waters.sea.surface();
  for (int i = 0; i < 300; ++i) {
    EXPECT_EQ(response.x(i), request.x(i));
    EXPECT_EQ(response.z(i), -surface->sample({request.y(i), request.x(i)}, 7.5).height);
  }
}

TEST(XdynWaves, PressuresAndVelocitiesAreThoseOfTheKinematicsTurnedIntoItsFrame) {
  ServedWaves served;
  XYZTGrid request;
  request.set_t(2.0);
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 40; ++i) {
    request.add_x(5.0 * i);
    request.add_y(2.0);
    request.add_z(i == 0 ? -20.0 : 2.0 + 0.1 * i);
    points.emplace_back(2.0, 5.0 * i, -request.z(i));
  }
  std::vector<WaterKinematics> truth(points.size());
  const auto surface = served.waters.sea.surface();
  sampleKinematics(surface->at(2.0), points, truth);
  Context first, second;
  DynamicPressuresResponse pressures;
  OrbitalVelocitiesResponse velocities;
  ASSERT_TRUE(served.stub->dynamic_pressures(&first, request, &pressures).ok());
  ASSERT_TRUE(served.stub->orbital_velocities(&second, request, &velocities).ok());
  ASSERT_EQ(pressures.pdyn_size(), 40);
  ASSERT_EQ(velocities.vz_size(), 40);
  EXPECT_EQ(pressures.pdyn(0), 0.0);  // in the air
  EXPECT_EQ(velocities.vx(0), 0.0);
  for (int i = 1; i < 40; ++i) {
    const WaterKinematics& motion = truth[static_cast<std::size_t>(i)];
    EXPECT_EQ(pressures.pdyn(i), motion.dynamicPressure);
    EXPECT_EQ(velocities.vx(i), motion.velocity.y);
    EXPECT_EQ(velocities.vy(i), motion.velocity.x);
    EXPECT_EQ(velocities.vz(i), -motion.velocity.z);
    EXPECT_EQ(velocities.z(i), request.z(i));
  }
}

/// Height upwards that a spectrum means, as xdyn adds it up.
double heightOf(const SpectrumResponse& response, double x, double y, double t) {
  double height = 0.0;
  for (const Spectrum& s : response.spectrum()) {
    const double amplitude = std::sqrt(2.0 * s.si(0) * s.dj(0));
    const double along = x * std::cos(s.psi(0)) + y * std::sin(s.psi(0));
    height += amplitude * std::sin(s.k(0) * along - s.omega(0) * t + s.phase(0).phase(0));
  }
  return height;
}

// At the place and time asked the sum is the sea, but for the float arithmetic of samples (their
// own bound); a quarter of a second and half a metre away envelopes have changed by less than a
// tenth of H_m0 = 1.12 m.
TEST(XdynWaves, TheSpectrumAddsUpToTheSeaWhereAndWhenItWasAskedFor) {
  ServedWaves served;
  const auto surface = served.waters.sea.surface();
  for (const double t : {0.0, 12.5, 3600.0}) {
    SpectrumRequest request;
    request.set_x(120.0);
    request.set_y(-45.0);
    request.set_t(t);
    Context context;
    SpectrumResponse response;
    ASSERT_TRUE(served.stub->spectrum(&context, request, &response).ok());
    const auto octaves = surface->waves().octaves();
    ASSERT_EQ(static_cast<std::size_t>(response.spectrum_size()), octaves.size());
    const SurfaceSample there = surface->sample({-45.0, 120.0}, t);
    EXPECT_NEAR(heightOf(response, 120.0, -45.0, t), there.height, there.bound + 1e-9);
    const SurfaceSample near = surface->sample({-45.3, 120.4}, t + 0.25);
    EXPECT_NEAR(heightOf(response, 120.4, -45.3, t + 0.25), near.height, 0.11);
    for (std::size_t i = 0; i < octaves.size(); ++i) {
      const Spectrum& entry = response.spectrum(static_cast<int>(i));
      EXPECT_NEAR(entry.k(0), octaves[i].waveNumber, 1e-12);
      EXPECT_NEAR(std::cos(entry.psi(0)), std::sin(octaves[i].toward), 1e-12);  // north
      EXPECT_NEAR(std::sin(entry.psi(0)), std::cos(octaves[i].toward), 1e-12);  // east
      // Deep water, ω² = gk.
      EXPECT_NEAR(entry.omega(0) * entry.omega(0), 9.80665 * entry.k(0), 1e-9);
    }
  }
}

TEST(XdynWaves, FrequenciesAndDirectionsForResponseOperatorsAreTheSpectrumsOwn) {
  ServedWaves served;
  Context first, second, third;
  SpectrumResponse spectrum;
  AngularFrequenciesResponse frequencies;
  DirectionsResponse directions;
  ASSERT_TRUE(served.stub->spectrum(&first, {}, &spectrum).ok());
  ASSERT_TRUE(served.stub->angular_frequencies_for_rao(&second, {}, &frequencies).ok());
  ASSERT_TRUE(served.stub->directions_for_rao(&third, {}, &directions).ok());
  ASSERT_EQ(frequencies.angular_frequencies_size(), spectrum.spectrum_size());
  ASSERT_EQ(directions.directions_size(), spectrum.spectrum_size());
  for (int i = 0; i < spectrum.spectrum_size(); ++i) {
    EXPECT_EQ(frequencies.angular_frequencies(i).omegas(0), spectrum.spectrum(i).omega(0));
    EXPECT_EQ(directions.directions(i).psis(0), spectrum.spectrum(i).psi(0));
  }
}

// In closed form: one wave towards east over a current of 1 m/s that carries it along, in 5 m of
// water: at a fixed point ω + kU.
TEST(XdynWaves, ARegularWaveInACurrentIsItselfInItsSpectrum) {
  ServedWaves served(
      test::sceneText({{"run:", "effects: {wake: off}\nrun:"},
                       {"depth_m: inf", "depth_m: 5\n  current: {speed_m_s: 1, toward_deg: 90}"}}));
  Context setting, asking;
  SetParameterRequest parameters;
  parameters.set_parameters(
      "model: grpc\nurl: localhost:1\noctaves:\n"
      "  - {kind: regular, standard_deviation_m: 0.5, frequency_hz: 0.2, toward_deg: 90}\n");
  SetParameterResponse set;
  ASSERT_TRUE(served.stub->set_parameters(&setting, parameters, &set).ok());
  EXPECT_EQ(set.error_message(), "");
  SpectrumRequest request;
  request.set_t(11.0);
  SpectrumResponse response;
  ASSERT_TRUE(served.stub->spectrum(&asking, request, &response).ok());
  ASSERT_EQ(response.spectrum_size(), 1);
  const Spectrum& wave = response.spectrum(0);
  const double still = 2.0 * pi * 0.2;
  EXPECT_NEAR(still * still, 9.80665 * wave.k(0) * std::tanh(5.0 * wave.k(0)), 1e-9);
  EXPECT_NEAR(wave.omega(0), still + wave.k(0), 1e-9);
  EXPECT_NEAR(wave.psi(0), 0.5 * pi, 1e-12);
  EXPECT_NEAR(wave.si(0), 0.25, 1e-12);  // amplitude²/2 = a²
  // A crest at the anchor at the epoch: sin(phase) = 1.
  EXPECT_NEAR(wave.phase(0).phase(0), 0.5 * pi, 1e-9);
}

TEST(XdynWavesHard, WhatCannotBeIsToldAndLeavesTheSeaAsItWas) {
  ServedWaves served;
  const double before = served.waters.sea.surface()->sample({3.0, 4.0}, 5.0).height;
  const auto messageOf = [&](const std::string& parameters) {
    Context context;
    SetParameterRequest request;
    request.set_parameters(parameters);
    SetParameterResponse response;
    EXPECT_TRUE(served.stub->set_parameters(&context, request, &response).ok());
    return response.error_message();
  };
  EXPECT_EQ(messageOf(""), "");
  EXPECT_EQ(messageOf("model: grpc\nurl: localhost:8011\n"), "");
  EXPECT_NE(messageOf("jonswap: {hm0_m: -2, tp_s: 5, from_deg: 0}").find("'jonswap.hm0_m': -2"),
            std::string::npos);
  EXPECT_NE(messageOf("file: /etc/passwd").find("is not allowed here"), std::string::npos);
  EXPECT_NE(messageOf("a: [").find("parameters:1"), std::string::npos);
  EXPECT_EQ(served.waters.sea.surface()->sample({3.0, 4.0}, 5.0).height, before);

  Context sizes, many, far;
  XYTGrid grid;
  grid.add_x(1.0);
  XYZTGrid elevations;
  EXPECT_EQ(served.stub->elevations(&sizes, grid, &elevations).error_code(),
            grpc::StatusCode::INVALID_ARGUMENT);
  for (int i = 0; i < 1001; ++i) grid.add_x(0.0), grid.add_y(0.0);
  grid.add_y(0.0);
  EXPECT_EQ(served.stub->elevations(&many, grid, &elevations).error_code(),
            grpc::StatusCode::RESOURCE_EXHAUSTED);
  SpectrumRequest spectrum;
  spectrum.set_x(std::nan(""));
  SpectrumResponse none;
  EXPECT_EQ(served.stub->spectrum(&far, spectrum, &none).error_code(),
            grpc::StatusCode::INVALID_ARGUMENT);
}

TEST(XdynWavesHard, ASeaOfPerlinOctavesHasNoMotionAndNoSpectrum) {
  ServedWaves served(
      test::sceneText({{"run:", "effects: {wake: off}\nrun:"}, {"seed: 7", "model: perlin"}}));
  XYZTGrid grid;
  DynamicPressuresResponse pressures;
  OrbitalVelocitiesResponse velocities;
  SpectrumResponse spectrum;
  AngularFrequenciesResponse frequencies;
  DirectionsResponse directions;
  Context a, b, c, d, e;
  using grpc::StatusCode;
  EXPECT_EQ(served.stub->dynamic_pressures(&a, grid, &pressures).error_code(),
            StatusCode::UNIMPLEMENTED);
  EXPECT_EQ(served.stub->orbital_velocities(&b, grid, &velocities).error_code(),
            StatusCode::UNIMPLEMENTED);
  EXPECT_EQ(served.stub->spectrum(&c, {}, &spectrum).error_code(), StatusCode::UNIMPLEMENTED);
  EXPECT_EQ(served.stub->angular_frequencies_for_rao(&d, {}, &frequencies).error_code(),
            StatusCode::UNIMPLEMENTED);
  EXPECT_EQ(served.stub->directions_for_rao(&e, {}, &directions).error_code(),
            StatusCode::UNIMPLEMENTED);
}

}  // namespace
}  // namespace seaway::bridge
