#include "sim_bridge/commands/wake.h"

#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "render/png.h"
#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/output/number_text.h"
#include "sim_bridge/output/stopwatch.h"
#include "sim_bridge/scene/schema.h"
#include "surface/angles.h"
#include "surface/constants.h"
#include "surface/disturbance/steady_wake.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

constexpr int modes = 256;
constexpr double lengthsOfTransverseWaves = 40.0;  // across the window
constexpr double widestWedge_deg = 60.0;           // that the window holds far enough astern
constexpr double least = 0.15;                     // Froude number of the hull's length

struct Figures {
  double froude = 0.0, depthFroude = 0.0;
  double wavelength = 0.0, wavelengthTheory = 0.0;  // m
  double angle_deg = NAN, extrapolated_deg = NAN, theory_deg = 0.0;
  double resistance = 0.0;  // N
  double stepMs = 0.0;
};

double medianStepMs(SteadyWake& wake) {
  std::vector<double> times;
  for (int i = 0; i < 15; ++i) {
    const Stopwatch watch;
    wake.step();
    times.push_back(watch.milliseconds());
  }
  std::nth_element(times.begin(), times.begin() + 7, times.end());
  return times[7];
}

void measureAngles(const SteadyWake& wake, double wedge, Figures& figures) {
  const double deepLength = wake.size() / lengthsOfTransverseWaves;
  // Wider than the wedge that holds the wake, and as far astern as the window has all of that.
  const double widest = 1.3 * std::tan(wedge);
  const double last = std::min(22.0 * deepLength, 0.4 * wake.size() / widest);
  const double first = std::min(6.0 * deepLength, 0.4 * last);
  const auto ridge = ridgeOf(wake, first, last, widest);
  figures.angle_deg = degreesFromRadians(std::atan(ridge.back().aside / ridge.back().astern));
  figures.extrapolated_deg =
      degreesFromRadians(figures.depthFroude > 1.0 ? frontAngle(wake, first, last, widest)
                                                   : ridgeAngleAtInfinity(ridge));
}

Figures measure(SteadyWake& wake, const WakeOptions& options) {
  const double deepLength = wake.size() / lengthsOfTransverseWaves;
  Figures figures;
  figures.froude = options.speed / std::sqrt(standardGravity * options.length);
  figures.depthFroude = options.speed / std::sqrt(standardGravity * options.depth);
  figures.wavelengthTheory = transverseWavelengthTheory(options.speed, options.depth);
  figures.wavelength = std::isnan(figures.wavelengthTheory)
                           ? figures.wavelengthTheory
                           : transverseWavelength(wake, 3.0 * deepLength, 20.0 * deepLength);
  const double wedge = wedgeAngle(options.speed, options.depth);
  figures.theory_deg = degreesFromRadians(wedge);
  if (figures.theory_deg <= widestWedge_deg) measureAngles(wake, wedge, figures);
  figures.resistance = wake.resistance();
  figures.stepMs = medianStepMs(wake);
  return figures;
}

/// Seen from above, the vessel at the right: crests light, troughs dark, brightest at three
/// standard deviations; the wedge of theory in red.
render::ColourImage picture(const SteadyWake& wake, double wedge) {
  const glm::ivec2 size(1200, 800);
  const double astern = 0.6 * wake.size(), perPixel = astern / (size.x - 60);
  std::vector<glm::dvec2> points;
  for (int row = 0; row < size.y; ++row) {
    for (int column = 0; column < size.x; ++column) {
      points.emplace_back(perPixel * (size.x - 60 - column), perPixel * (0.5 * size.y - row));
    }
  }
  const std::vector<double> heights = wake.heights(points);
  double square = 0.0;
  for (const double height : heights) square += height * height;
  const double brightest = 3.0 * std::sqrt(square / static_cast<double>(heights.size()));
  render::ColourImage image{size, {}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double part = std::clamp(0.5 + 0.5 * heights[i] / std::max(brightest, 1e-12), 0.0, 1.0);
    const auto value = [&](double dark, double light) {
      return static_cast<std::uint8_t>(std::lround(dark + (light - dark) * part));
    };
    const double edge = points[i].x * std::tan(wedge) - std::abs(points[i].y);
    const bool line = points[i].x > 0.0 && std::abs(edge) * std::cos(wedge) < 0.6 * perPixel;
    image.rgb.push_back(line ? 220 : value(8, 240));
    image.rgb.push_back(line ? 60 : value(30, 248));
    image.rgb.push_back(line ? 40 : value(60, 255));
  }
  return image;
}

nlohmann::ordered_json asJson(const Figures& f, const WakeOptions& options) {
  return {{"speed_m_s", options.speed},
          {"length_m", options.length},
          {"depth_m", options.depth},
          {"froude_number", f.froude},
          {"depth_froude_number", f.depthFroude},
          {"transverse_wavelength_m", f.wavelength},
          {"transverse_wavelength_theory_m", f.wavelengthTheory},
          {"cusp_angle_deg", f.angle_deg},
          {"cusp_angle_extrapolated_deg", f.extrapolated_deg},
          {"cusp_angle_theory_deg", f.theory_deg},
          {"wave_resistance_n", f.resistance},
          {"step_ms", f.stepMs}};
}

/// What does not exist, such as transverse waves beyond the critical speed, is told as "none".
std::string cell(double value) {
  return std::isfinite(value) ? fmt::format("{:.2f}", value) : "none";
}

void writeText(const Figures& f, const WakeOptions& options, std::ostream& out) {
  out << fmt::format("Wigley hull of {} m at {} m/s: Froude number {:.2f}\n",
                     numberText(options.length), numberText(options.speed), f.froude);
  out << fmt::format("                          {:>9} {:>9}\n", "measured", "theory");
  out << fmt::format("transverse wavelength  m  {:>9} {:>9}\n", cell(f.wavelength),
                     cell(f.wavelengthTheory));
  out << fmt::format("angle of the ridge   deg  {:>9}\n", cell(f.angle_deg));
  out << fmt::format("{:<21}deg  {:>9} {:>9}\n",
                     f.depthFroude > 1.0 ? "angle of the front" : "  at infinity",
                     cell(f.extrapolated_deg), cell(f.theory_deg));
  out << fmt::format("wave resistance       kN  {:>9.2f}\n", 1e-3 * f.resistance);
  out << fmt::format("a step of {}x{} cells took {:.2f} ms\n", 2 * modes, 2 * modes, f.stepMs);
  out << "written: " << (std::filesystem::path(options.out) / "wake.png").string() << '\n';
}

}  // namespace

int runWake(const WakeOptions& options, std::ostream& out) {
  requireInRange("--speed", options.speed, Range::within(0.1, 60.0), "m/s");
  requireInRange("--length", options.length, Range::within(0.5, 500.0), "m");
  requireInRange("--depth", options.depth, Range::above(0.0).orInfinite(), "m");
  const double froude = options.speed / std::sqrt(standardGravity * options.length);
  if (froude < least) {
    throw InputError("--speed: " + numberText(options.speed) + " m/s is too slow for a hull of " +
                     numberText(options.length) + " m to make waves; must be >= " +
                     numberText(least * std::sqrt(standardGravity * options.length)));
  }
  requireWritableFolder(options.out);
  const std::filesystem::path folder(options.out);
  const double deepLength = 2.0 * pi * options.speed * options.speed / standardGravity;
  const HullFootprint hull =
      HullFootprint::wigley(options.length, 0.29 * options.length, 0.067 * options.length);
  SteadyWake wake(hull, options.speed, lengthsOfTransverseWaves * deepLength, options.depth, modes);
  const Figures figures = measure(wake, options);
  render::writePng(folder / "wake.png", picture(wake, wedgeAngle(options.speed, options.depth)));
  const std::string json = asJson(figures, options).dump(2) + '\n';
  AtomicFile file(folder / "wake.json");
  file.stream() << json;
  file.commit();
  if (options.json) {
    out << json;
  } else {
    writeText(figures, options, out);
  }
  return 0;
}

void addWakeCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command = app.add_subcommand("wake", "A vessel's wake in still water, beside theory");
  auto options = std::make_shared<WakeOptions>();
  command->add_option("--speed", options->speed, "of the vessel, m/s")->required();
  command->add_option("--length", options->length, "of its hull, m")->required();
  command->add_option("--depth", options->depth, "water depth, m (default: deep)");
  command->add_option("--out", options->out, "folder for wake.png and wake.json")->required();
  command->add_flag("--json", options->json, "machine-readable");
  command->footer("Example:\n  seaway wake --speed 5 --length 12 --out out/wake");
  command->callback([=, &chosen] { chosen = [=] { return runWake(*options, std::cout); }; });
}

}  // namespace seaway::bridge
