#include "sim_bridge/commands/query.h"

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <span>

#include "sim_bridge/commands/blocked_octaves_json.h"
#include "sim_bridge/commands/options.h"
#include "sim_bridge/commands/points_table.h"
#include "sim_bridge/output/number_text.h"
#include "sim_bridge/output/progress.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "sim_bridge/scene_view.h"
#include "surface/input_error.h"
#include "surface/parallel_sampling.h"
#include "surface/water_kinematics.h"

namespace seaway::bridge {
namespace {

constexpr const char* resultColumns[] = {"height_m", "slope_x", "slope_y", "velocity_z_m_s",
                                         "error_m",  "bound_m", "status"};
constexpr const char* orbitalColumns[] = {"orbital_u_m_s", "orbital_v_m_s", "orbital_w_m_s"};
constexpr const char* pressureColumn = "pressure_pa";
constexpr const char* depthColumn = "depth_m";  // of scenes with terrain

// Points that go through the surface in one call, between two looks at the progress bar.
constexpr std::size_t pointsPerCall = 1 << 18;

struct Point {
  glm::dvec2 position{0.0};      // sea plane, m
  std::optional<double> height;  // m above the still-water level; without: on the surface
  double time = 0.0;
  bool inRange = true;
};

struct Answer {
  SurfaceSample sample;
  double pressure = std::nan("");
  double depth = std::nan("");  // of the water, m; 0 where it is dry
  double ellipsoidalHeight = std::nan("");
};

double latitudeOf(const PointsTable& table, std::size_t row) {
  const double latitude_deg = table.number(row, table.columns.latitude);
  if (std::abs(latitude_deg) > 90.0) {
    table.fail(row, table.columns.latitude, "is not allowed; must be in [-90, 90] °");
  }
  return latitude_deg;
}

Point pointOf(const PointsTable& table, std::size_t row, const QueryOptions& options,
              const Geodesy& geodesy) {
  Point point;
  if (table.columns.x >= 0) {
    point.position = {table.number(row, table.columns.x), table.number(row, table.columns.y)};
    // Values that are not finite are for the surface to refuse.
    point.inRange = geodesy.describe(point.position).inRange || !std::isfinite(point.position.x) ||
                    !std::isfinite(point.position.y);
  } else {
    const double latitude_deg = latitudeOf(table, row);
    const double longitude_deg = table.number(row, table.columns.longitude);
    const SeaPlanePoint place = geodesy.seaPlaneFromGeodetic(latitude_deg, longitude_deg);
    point.position = place.position;
    point.inRange = place.inRange;
    if (!std::isfinite(latitude_deg + longitude_deg)) {
      point.position = glm::dvec2(std::nan(""));
      point.inRange = true;
    }
  }
  point.height = options.height;
  if (table.columns.height >= 0) point.height = table.number(row, table.columns.height);
  point.time = table.columns.time >= 0 ? table.number(row, table.columns.time) : *options.time;
  return point;
}

SurfaceSample unserved(SampleStatus status) {
  const double nan = std::nan("");
  SurfaceSample sample;
  sample.height = sample.verticalVelocity = sample.error = sample.bound = nan;
  sample.slope = glm::dvec2(nan);
  sample.status = status;
  return sample;
}

/// Asks the sea at one time; keeps its memory from one call to the next.
class Asker {
 public:
  Asker(const std::vector<Point>& points, const SampleOptions& options)
      : points_(points), options_(options) {}

  void ask(std::span<const std::size_t> rows, const SurfaceAtTime& now,
           std::vector<Answer>& answers) {
    places_.clear();
    for (const std::size_t row : rows) places_.push_back(points_[row].position);
    samples_.resize(rows.size());
    sampleInParallel(now, places_, samples_, options_);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Answer& answer = answers[rows[i]];
      answer.sample = samples_[i];
      const bool dry = has(samples_[i].status, SampleStatus::dry);
      answer.depth = dry ? 0.0 : samples_[i].height - now.bedAt(places_[i]);
    }
    if (options_.orbitalVelocity) askKinematics(rows, now, answers);
  }

 private:
  // On the surface the stretched dynamic pressure and the weight of the water cancel.
  void askKinematics(std::span<const std::size_t> rows, const SurfaceAtTime& now,
                     std::vector<Answer>& answers) {
    below_.clear();
    depths_.clear();
    for (const std::size_t row : rows) {
      Answer& answer = answers[row];
      if (points_[row].height && !std::isnan(answer.sample.height)) {
        below_.push_back(row);
        depths_.emplace_back(points_[row].position, *points_[row].height);
      } else if (std::isfinite(answer.sample.orbitalVelocity.x)) {
        answer.pressure = 0.0;
      }
    }
    motions_.resize(below_.size());
    sampleKinematics(now, depths_, motions_, options_);
    for (std::size_t i = 0; i < below_.size(); ++i) {
      Answer& answer = answers[below_[i]];
      answer.sample.orbitalVelocity = motions_[i].velocity;
      answer.sample.status |= motions_[i].status;
      answer.pressure = motions_[i].pressure;
    }
  }

  const std::vector<Point>& points_;
  SampleOptions options_;
  std::vector<glm::dvec2> places_;
  std::vector<SurfaceSample> samples_;
  std::vector<std::size_t> below_;  // rows that have a height
  std::vector<glm::dvec3> depths_;
  std::vector<WaterKinematics> motions_;
};

/// The surface at rising times: with vessels' wakes where points are within their reach.
class WakenedSea {
 public:
  WakenedSea(const Scene& scene, const Sea& sea) : scene_(scene), sea_(sea) {}

  const WaterSurface& at(double t, const std::vector<Point>& points,
                         std::span<const std::size_t> rows) {
    std::vector<WakeListener> places;
    for (const std::size_t row : rows) places.push_back({points[row].position, 0.0, 0});
    if (!wakesReach(scene_, sea_, t, places)) return withoutWakes(t);
    if (simulation_) {
      simulation_ = simulation_->movedTo(t);
    } else {
      simulation_ = replayWithProgress(scene_, sea_, t);
    }
    simulation_->attend({.cameras = {}, .places = std::move(places)});
    return simulation_->surface();
  }

 private:
  /// What lies on the water and ripples it is there all the same.
  const WaterSurface& withoutWakes(double t) {
    if (!detail_) detail_.emplace(scene_, sea_);
    detail_->advance(t);
    if (!detail_->detail()) return sea_.surface;
    surface_ = sea_.surface;
    surface_->setDetail(detail_->detail());
    return *surface_;
  }

  const Scene& scene_;
  const Sea& sea_;
  std::optional<Simulation> simulation_;
  std::optional<SceneDetail> detail_;
  std::optional<WaterSurface> surface_;
};

/// The sea at the points; those of one time go through it together.
std::vector<Answer> askAll(const std::vector<Point>& points, const Scene& scene, const Sea& sea,
                           const SampleOptions& options) {
  std::map<double, std::vector<std::size_t>> rowsAt;
  std::vector<Answer> answers(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].inRange && !std::isnan(points[i].time)) {
      rowsAt[points[i].time].push_back(i);
    } else {
      answers[i].sample =
          unserved(points[i].inRange ? SampleStatus::notFinite : SampleStatus::outOfRange);
    }
  }
  Progress progress("points", points.size());
  std::size_t done = 0;
  Asker asker(points, options);
  WakenedSea wakened(scene, sea);
  for (const auto& [time, rows] : rowsAt) {
    const SurfaceAtTime now = wakened.at(time, points, rows).at(time);
    for (std::size_t first = 0; first < rows.size(); first += pointsPerCall) {
      const std::size_t count = std::min(pointsPerCall, rows.size() - first);
      asker.ask(std::span(rows).subspan(first, count), now, answers);
      progress.update(done += count);
    }
  }
  return answers;
}

double ellipsoidalHeight(const Sea& sea, const Point& point, const SurfaceSample& sample) {
  if (!std::isfinite(sample.height)) return std::nan("");
  const GeodeticPosition place = sea.geodesy.geodeticFromSeaPlane(point.position);
  return sea.level.ellipsoidalHeight(place.latitude_deg, place.longitude_deg) + sample.height;
}

std::vector<double> numbersOf(const SurfaceSample& sample) {
  return {sample.height,           sample.slope.x, sample.slope.y,
          sample.verticalVelocity, sample.error,   sample.bound};
}

void writeCsv(const PointsTable& table, const std::vector<Answer>& answers,
              const QueryOptions& options, const Sea& sea, std::ostream& out) {
  const bool depths = sea.surface.terrain() != nullptr;
  std::string text;
  for (const std::string& name : table.header) text += csvCell(name) + ",";
  const char* separator = "";
  for (const char* name : resultColumns) {
    text += separator + std::string(name);
    separator = ",";
  }
  if (options.orbital) {
    for (const char* name : orbitalColumns) text += "," + std::string(name);
  }
  if (options.pressure) text += "," + std::string(pressureColumn);
  if (depths) text += "," + std::string(depthColumn);
  text += options.ellipsoidal ? ",ellipsoidal_height_m\n" : "\n";
  for (std::size_t row = 0; row < answers.size(); ++row) {
    for (const std::string& cell : table.rows[row]) text += csvCell(cell) + ",";
    for (const double number : numbersOf(answers[row].sample)) text += numberText(number) + ",";
    text += statusText(answers[row].sample.status);
    for (int i = 0; options.orbital && i < 3; ++i) {
      text += "," + numberText(answers[row].sample.orbitalVelocity[i]);
    }
    if (options.pressure) text += "," + numberText(answers[row].pressure);
    if (depths) text += "," + numberText(answers[row].depth);
    if (options.ellipsoidal) text += "," + numberText(answers[row].ellipsoidalHeight);
    text += '\n';
  }
  out << text << std::flush;
}

void writeJson(const PointsTable& table, const std::vector<Answer>& answers,
               const QueryOptions& options, const Sea& sea, std::ostream& out) {
  nlohmann::ordered_json points = nlohmann::ordered_json::array();
  for (std::size_t row = 0; row < answers.size(); ++row) {
    nlohmann::ordered_json point;
    for (std::size_t i = 0; i < table.header.size(); ++i) {
      const int column = static_cast<int>(i);
      const PointsTable::Columns& known = table.columns;
      const bool numeric = column == known.latitude || column == known.longitude ||
                           column == known.x || column == known.y || column == known.height ||
                           column == known.time;
      if (numeric) {
        point[table.header[i]] = table.number(row, column);
      } else {
        point[table.header[i]] = table.rows[row][i];
      }
    }
    const std::vector<double> numbers = numbersOf(answers[row].sample);
    for (std::size_t i = 0; i < numbers.size(); ++i) point[resultColumns[i]] = numbers[i];
    point["status"] = statusText(answers[row].sample.status);
    for (int i = 0; options.orbital && i < 3; ++i) {
      point[orbitalColumns[i]] = answers[row].sample.orbitalVelocity[i];
    }
    if (options.pressure) point[pressureColumn] = answers[row].pressure;
    if (sea.surface.terrain()) point[depthColumn] = answers[row].depth;
    if (options.ellipsoidal) point["ellipsoidal_height_m"] = answers[row].ellipsoidalHeight;
    points.push_back(std::move(point));
  }
  out << nlohmann::ordered_json{{"points", std::move(points)},
                                {"sea", {{"blocked_octaves", asJson(sea.blocked)}}}}
             .dump(2)
      << '\n';
}

PointsTable pointsTable(const QueryOptions& options, std::istream& in) {
  if (options.points.empty() == options.at.empty()) {
    throw InputError(
        "points are wanted: either --points FILE (- for standard input) or --at LAT,LON");
  }
  if (!options.at.empty()) return pointsFromArguments(options.at);
  if (options.points == "-") return readPoints(in, "standard input");
  std::ifstream file(options.points, std::ios::binary);
  if (!file || std::filesystem::is_directory(options.points)) {
    throw InputError(options.points, 0, "no such file, or it cannot be read");
  }
  return readPoints(file, options.points);
}

// Throws where a column that came in has the name of one that goes out.
void requireNoneOf(std::span<const char* const> names, const PointsTable& table) {
  for (const char* name : names) {
    if (std::find(table.header.begin(), table.header.end(), name) != table.header.end()) {
      throw InputError(table.source, 1,
                       std::string("column '") + name + "' would be written twice; rename it");
    }
  }
}

void requireSound(const QueryOptions& options, const PointsTable& table) {
  requireInRange("--tolerance", options.tolerance, Range::atLeast(0.0), "m");
  requireInRange("--cutoff", options.cutoff, Range::atLeast(0.0), "m");
  if (options.time) requireSeaTime(*options.time);
  if (options.height) {
    requireInRange("--z", *options.height, Range::any(), "m");
    if (!options.orbital && !options.pressure) {
      throw InputError("--z has no effect without --orbital or --pressure");
    }
    if (table.columns.height >= 0) {
      throw InputError(table.source, 1, "column 'z_m' and --z both give the height; give one");
    }
  }
  if (!options.time && table.columns.time < 0) {
    throw InputError("--time is wanted, or a column t_s with each point's own time");
  }
  requireNoneOf(resultColumns, table);
  if (options.orbital) requireNoneOf(orbitalColumns, table);
  if (options.pressure) requireNoneOf(std::span(&pressureColumn, 1), table);
  const char* ellipsoidal = "ellipsoidal_height_m";
  if (options.ellipsoidal) requireNoneOf(std::span(&ellipsoidal, 1), table);
}

}  // namespace

int runQuery(const QueryOptions& options, std::istream& in, std::ostream& out) {
  Scene scene = loadScene(options.scene);
  if (!options.model.empty()) overrideModel(scene, options.model);
  const PointsTable table = pointsTable(options, in);
  requireSound(options, table);
  const Sea sea = buildSea(scene);
  if (sea.surface.terrain()) requireNoneOf(std::span(&depthColumn, 1), table);
  std::vector<Point> points;
  points.reserve(table.rows.size());
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    points.push_back(pointOf(table, row, options, sea.geodesy));
  }
  if (options.ellipsoidal && !sea.level.hasGeoid()) {
    spdlog::warn("no geoid data: the geoid is taken to be the ellipsoid in ellipsoidal_height_m");
  }
  std::vector<Answer> answers = askAll(points, scene, sea,
                                       {.tolerance = options.tolerance,
                                        .shortestWavelength = options.cutoff,
                                        .orbitalVelocity = options.orbital || options.pressure});
  for (std::size_t i = 0; options.ellipsoidal && i < points.size(); ++i) {
    answers[i].ellipsoidalHeight = ellipsoidalHeight(sea, points[i], answers[i].sample);
  }
  if (options.json) {
    writeJson(table, answers, options, sea, out);
  } else {
    writeCsv(table, answers, options, sea, out);
  }
  return 0;
}

void addQueryCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command = app.add_subcommand("query", "Ask the sea for heights, slopes and velocities");
  auto options = std::make_shared<QueryOptions>();
  command->add_option("SCENE", options->scene, "scene file")->required();
  command->add_option("--time", options->time, "seconds since the scene's epoch, also before it");
  command->add_option(
      "--points", options->points,
      "CSV with a header: latitude_deg,longitude_deg or x_m,y_m, optionally z_m (height "
      "above the still-water level, for --orbital and --pressure), "
      "t_s (each point's own time); other columns pass through; - reads standard "
      "input");
  command->add_option("--at", options->at, "LATITUDE,LONGITUDE in degrees; may be repeated")
      ->expected(1, -1);
  command->add_option("--tolerance", options->tolerance,
                      "height that may be left out, m, one standard deviation");
  command->add_option("--cutoff", options->cutoff,
                      "wavelength below which waves may be left out, m; for a hull, a quarter of "
                      "its length");
  command->add_option("--model", options->model,
                      "kind of octaves, group or perlin (default: the scene's)");
  command->add_flag("--orbital", options->orbital,
                    "add orbital_u_m_s, orbital_v_m_s, orbital_w_m_s: velocity of the water, east, "
                    "north, up, at the surface or at z_m");
  command->add_flag("--pressure", options->pressure,
                    "add pressure_pa: gauge pressure, hydrostatic plus dynamic, at z_m; 0 at the "
                    "surface, where points without z_m are");
  command->add_option("--z", options->height,
                      "height of all points above the still-water level, m, negative below; else "
                      "column z_m, else the surface");
  command->add_flag("--ellipsoidal", options->ellipsoidal,
                    "add ellipsoidal_height_m: of the surface above the WGS84 ellipsoid");
  command->add_flag("--json", options->json, "machine-readable");
  command->footer(
      "Examples:\n  seaway query configs/scenes/canaveral.yaml --time 12.5 --at 28.878,-78.467\n"
      "  seaway query configs/scenes/canaveral.yaml --time 0 --points points.csv > heights.csv\n"
      "  seaway query configs/scenes/canaveral.yaml --time 0 --at 28.878,-78.467 --z -3 --orbital "
      "--pressure");
  command->callback(
      [=, &chosen] { chosen = [=] { return runQuery(*options, std::cin, std::cout); }; });
}

}  // namespace seaway::bridge
