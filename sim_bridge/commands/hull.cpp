#include "sim_bridge/commands/hull.h"

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "sim_bridge/commands/hull_figures.h"
#include "sim_bridge/commands/options.h"
#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/output/number_text.h"
#include "sim_bridge/report/plot.h"
#include "sim_bridge/scene/schema.h"
#include "sim_bridge/vessel/hull_source.h"
#include "surface/angles.h"
#include "surface/hull/hull_repair.h"
#include "surface/hull/mesh_calibration.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

void requireSane(const HullOptions& o) {
  requireInRange("--unit", o.file.metresPerUnit, Range::above(0.0), "m");
  requireInRange("--density", o.density, Range::within(100.0, 20000.0), "kg/m3");
  if (o.draft) requireInRange("--draft", *o.draft, Range::above(0.0), "m");
  if (o.mass) requireInRange("--mass", *o.mass, Range::above(0.0), "kg");
  if (o.heel_deg) requireInRange("--heel", *o.heel_deg, Range::within(-180.0, 180.0), "deg");
  if (o.knownVolume) requireInRange("--volume", *o.knownVolume, Range::above(0.0), "m3");
  if (o.knownWaterplane) {
    requireInRange("--waterplane", *o.knownWaterplane, Range::above(0.0), "m2");
    if (!o.knownVolume) throw InputError("--waterplane: needs --volume beside it");
  }
  for (const double value : o.distanceAt) requireInRange("--distance", value, Range::any(), "m");
  requireInRange("--voxel", o.voxelSize, Range::atLeast(0.0), "m");
  requireInRange("--hole", o.widestHole, Range::atLeast(0.0), "m");
  for (const double value : o.gravity) requireInRange("--cg", value, Range::any(), "m");
  if (o.triangles < 50 || o.triangles > 1000000) {
    throw InputError("--triangles: " + std::to_string(o.triangles) +
                     " is not allowed; must be in [50, 1000000]");
  }
  if (o.draft && o.mass) throw InputError("--draft and --mass exclude each other");
}

TriangleMesh repairedFile(const TriangleMesh& mesh, const HullOptions& options) {
  const TriangleMesh whole =
      repaired(mesh, {.voxelSize = options.voxelSize, .widestHole = options.widestHole});
  const std::string bytes = hullFileBytes(options.repair, whole);
  AtomicFile file(options.repair);
  file.stream() << bytes;
  file.commit();
  spdlog::info("{} written: {} triangles, in metres, x forward, z up", options.repair,
               whole.triangles.size());
  return whole;
}

/// Stops at faults, after telling them in JSON where that is asked for; warns of the rest.
void requireFloatable(const HullOptions& options, const MeshReport& check, std::ostream& out) {
  std::string faults;
  for (const std::string& fault : faultsOf(check)) faults += (faults.empty() ? "" : "; ") + fault;
  if (!faults.empty()) {
    if (options.json) out << faultsAsJson(options.mesh, check).dump(2) << '\n';
    throw InputError(options.mesh + ": " + faults + "; `--repair OUT` makes a watertight mesh");
  }
  for (const std::string& warning : warningsOf(check)) {
    spdlog::warn("{}: {}", options.mesh, warning);
  }
}

/// The waterplane upright: at the draft asked for, under the mass, or through the origin.
WaterPlane uprightPlane(const HullOptions& o, const TriangleMesh& mesh, const MeshBounds& bounds) {
  if (o.mass) return planeOfVolume(mesh, *o.mass / o.density);
  WaterPlane plane = WaterPlane::at(o.draft ? bounds.lower.z + *o.draft : 0.0);
  if (plane.height > bounds.lower.z && plane.height < bounds.upper.z) return plane;
  if (!o.draft) {
    throw InputError(o.mesh + ": does not cross z = 0, its waterline: give --draft or --mass");
  }
  throw InputError("--draft: " + numberText(*o.draft) + " m is not below the hull's depth of " +
                   numberText(bounds.size().z) + " m");
}

/// The mesh with the displacement and waterplane that are known of it.
TriangleMesh calibratedFile(const HullOptions& o, const TriangleMesh& mesh) {
  if (!o.knownWaterplane) return mesh;
  const double waterline = uprightPlane(o, mesh, boundsOf(mesh)).height;
  const TriangleMesh lowered = moved(mesh, {0.0, 0.0, -waterline});
  return moved(calibrated(lowered, *o.knownVolume, *o.knownWaterplane), {0.0, 0.0, waterline});
}

/// Distances from the hull at the points asked for, to a 300th of its longest side; a tenth of it
/// at the most.
std::vector<double> distancesOf(const HullOptions& o, const TriangleMesh& mesh) {
  std::vector<double> distances;
  if (o.distanceAt.empty()) return distances;
  const glm::dvec3 size = boundsOf(mesh).size();
  const double longest = std::max({size.x, size.y, size.z});
  const HullDistance distance(mesh, longest / 150.0, longest / 10.0);
  for (std::size_t i = 0; i + 2 < o.distanceAt.size(); i += 3) {
    distances.push_back(distance.at({o.distanceAt[i], o.distanceAt[i + 1], o.distanceAt[i + 2]}));
  }
  return distances;
}

std::vector<double> heels() {
  std::vector<double> all;
  for (int degree = 0; degree <= 180; degree += 5) all.push_back(radiansFromDegrees(degree));
  return all;
}

HullFigures figuresOf(const HullOptions& o, const TriangleMesh& mesh, const MeshReport& check) {
  HullFigures f;
  f.name = o.mesh;
  f.check = check;
  f.bounds = boundsOf(mesh);
  f.whole = massProperties(mesh);
  const SubmergedPart upright = submergedPart(mesh, uprightPlane(o, mesh, f.bounds));
  f.gravityAssumed = o.gravity.empty();
  f.volumeFactor = o.knownVolume ? *o.knownVolume / upright.volume : 1.0;
  const double density = o.density * f.volumeFactor;
  f.body = {&mesh,
            o.mass.value_or(density * upright.volume),
            {upright.centre.x, upright.centre.y, f.whole.centroid.z},
            density};
  if (!f.gravityAssumed) f.body.centreOfGravity = {o.gravity[0], o.gravity[1], o.gravity[2]};
  const double heel = radiansFromDegrees(o.heel_deg.value_or(0.0));
  if (o.draft && !o.heel_deg) {
    f.rest.plane = uprightPlane(o, mesh, f.bounds);
    f.rest.part = upright;
    f.rest.converged = true;
    const double rise = upright.centre.z - f.body.centreOfGravity.z;
    f.rest.transverseMetacentricHeight = upright.transverseRadius() + rise;
    f.rest.longitudinalMetacentricHeight = upright.longitudinalRadius() + rise;
  } else {
    f.rest = equilibrium(f.body, heel, 0.0, !o.heel_deg);
  }
  if (!f.rest.converged) {
    throw std::runtime_error(o.mesh + ": no attitude of rest was found near upright");
  }
  const glm::dvec3 middle = f.bounds.middle(), up = f.rest.plane.up;
  f.draft = (f.rest.plane.height - up.x * middle.x - up.y * middle.y) / up.z - f.bounds.lower.z;
  return f;
}

}  // namespace

int runHull(const HullOptions& options, std::ostream& out) {
  requireSane(options);
  if (!options.repair.empty()) {
    requireHullFormat(options.repair);
    requireWritableFile(options.repair);
  }
  TriangleMesh mesh = hullByName(options.mesh, options.file, options.triangles);
  if (!options.repair.empty()) mesh = repairedFile(mesh, options);
  const MeshReport check = checkMesh(mesh);
  requireFloatable(options, check, out);
  if (!check.facesOutward) mesh = turnedInsideOut(mesh);
  mesh = calibratedFile(options, mesh);
  if (!options.report.empty()) {
    requireWritableFolder(options.report);
    requirePlotter();
  }
  HullFigures figures = figuresOf(options, mesh, check);
  if (options.json || !options.report.empty()) {
    figures.levers = rightingLevers(figures.body, heels());
  }
  if (!options.report.empty()) writeHullReport(figures, options.report);
  const std::vector<double> distances = distancesOf(options, mesh);
  if (options.json) {
    auto json = asJson(figures);
    if (!distances.empty()) json["distances_m"] = distances;
    out << json.dump(2) << '\n';
  } else {
    writeText(figures, out);
    for (const double distance : distances) {
      out << "distance from the hull, m, negative inside: " << numberText(distance) << '\n';
    }
  }
  return 0;
}

void addHullCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command = app.add_subcommand("hull", "Check a hull's mesh and tell its hydrostatics");
  auto o = std::make_shared<HullOptions>();
  command
      ->add_option("MESH", o->mesh,
                   "STL, OBJ or glTF file; or box:L,B,D wigley:L,B,T,FREEBOARD "
                   "open_wigley:L,B,T,FREEBOARD,WALL sphere:R spar:D,T,FREEBOARD")
      ->required();
  command->add_option("--unit", o->file.metresPerUnit, "metres per unit of the file (default 1)");
  command->add_option("--forward", o->file.forward, "axis of the file to the bow (default +x)");
  command->add_option("--up", o->file.up, "axis of the file that points up (default +z)");
  command->add_option("--triangles", o->triangles, "of a shape, about (default 800)");
  command->add_option("--draft", o->draft, "upright, above the lowest point, m");
  command->add_option("--mass", o->mass, "kg: heel and trim follow; default: waterline at z = 0");
  command->add_option("--heel", o->heel_deg, "held at this, starboard down, degrees");
  command
      ->add_option("--cg", o->gravity,
                   "centre of gravity x y z, m (default: above B, at the "
                   "height of the volume's centroid)")
      ->expected(3);
  command->add_option("--density", o->density, "of the water, kg/m3 (default 1026)");
  command->add_option("--volume", o->knownVolume,
                      "known displacement upright, m3: what the mesh lacks is made up for");
  command->add_option("--waterplane", o->knownWaterplane,
                      "its area there, m2, beside --volume: the mesh is widened to meet both");
  command
      ->add_option("--distance", o->distanceAt,
                   "x y z, m, again and again: distance from the hull, negative inside")
      ->type_size(3);
  command->add_option("--repair", o->repair, "write a watertight mesh (.stl, .obj, .glb); use it");
  command->add_option("--voxel", o->voxelSize, "of the repair, m (default: length/150)");
  command->add_option("--hole", o->widestHole, "widest to be closed, m (default: 4 voxels)");
  command->add_option("--report", o->report, "folder for report.html and hull.json")
      ->check(mustBeNamed);
  command->add_flag("--json", o->json, "machine-readable");
  command->footer("Example:\n  seaway hull wigley:10,1,0.625,0.4 --report out/hull");
  command->callback([=, &chosen] { chosen = [=] { return runHull(*o, std::cout); }; });
}

}  // namespace seaway::bridge
