#include "sim_bridge/commands/hull_figures.h"

#include <spdlog/fmt/fmt.h>

#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/output/number_text.h"
#include "sim_bridge/report/html_page.h"
#include "sim_bridge/report/plot.h"
#include "surface/angles.h"

namespace seaway::bridge {
namespace {

using Json = nlohmann::ordered_json;

Json vectorJson(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

/// One figure of the results: for JSON, text and report alike.
struct Figure {
  const char* key;
  const char* name;
  const char* unit;
  double value;
};

std::vector<Figure> figuresOf(const HullFigures& f) {
  const SubmergedPart& p = f.rest.part;
  const double keel = f.bounds.lower.z;
  return {
      {"displacement_m3", "displacement", "m3", f.volumeFactor * p.volume},
      {"mass_kg", "mass", "kg", f.body.mass},
      {"draft_m", "draft amidships", "m", f.draft},
      {"heel_deg", "heel, starboard down", "deg", degreesFromRadians(f.rest.heel)},
      {"trim_deg", "trim, bow up", "deg", degreesFromRadians(f.rest.trim)},
      {"kb_m", "KB", "m", p.centre.z - keel},
      {"kg_m", "KG", "m", f.body.centreOfGravity.z - keel},
      {"bm_t_m", "BM, transverse", "m", p.transverseRadius()},
      {"bm_l_m", "BM, longitudinal", "m", p.longitudinalRadius()},
      {"gm_t_m", "GM, transverse", "m", f.rest.transverseMetacentricHeight},
      {"gm_l_m", "GM, longitudinal", "m", f.rest.longitudinalMetacentricHeight},
      {"waterplane_area_m2", "waterplane area", "m2", p.waterplaneArea},
      {"waterplane_inertia_t_m4", "its moment, transverse", "m4", p.transverseMoment},
      {"waterplane_inertia_l_m4", "its moment, longitudinal", "m4", p.longitudinalMoment},
      {"tpc_t_per_cm", "tonnes per cm", "t/cm", 1e-5 * f.body.waterDensity * p.waterplaneArea},
      {"wetted_area_m2", "wetted area", "m2", p.wettedArea},
  };
}

Json checkJson(const MeshReport& c) {
  return {{"watertight", c.watertight()},
          {"triangles", c.triangles},
          {"vertices", c.vertices},
          {"parts", c.parts},
          {"open_edges", c.openEdges},
          {"crowded_edges", c.crowdedEdges},
          {"reversed_edges", c.reversedEdges},
          {"zero_area_triangles", c.zeroAreaTriangles},
          {"self_intersections", c.selfIntersections},
          {"faces_outward", c.facesOutward},
          {"faults", faultsOf(c)},
          {"warnings", warningsOf(c)}};
}

std::string leverPlot(const HullFigures& f) {
  Curve lever{"GZ", {}, {}}, initial{"GM sin(heel)", {}, {}, CurveStyle::dashed};
  for (const RightingLever& each : f.levers) {
    lever.x.push_back(degreesFromRadians(each.heel));
    lever.y.push_back(each.lever);
    if (each.heel > radiansFromDegrees(60.0)) continue;
    initial.x.push_back(lever.x.back());
    initial.y.push_back(f.rest.transverseMetacentricHeight * std::sin(each.heel));
  }
  return svgOf("Righting lever", {.label = "heel (deg)"}, {.label = "GZ (m)"}, {lever, initial});
}

std::string draftPlot(const HullFigures& f) {
  Curve volume{"displacement (m3)", {}, {}}, area{"waterplane area (m2)", {}, {}};
  const double keel = f.bounds.lower.z, depth = f.bounds.size().z;
  for (int i = 1; i <= 60; ++i) {
    const double draft = depth * i / 60.0;
    const SubmergedPart part = submergedPart(*f.body.mesh, WaterPlane::at(keel + draft));
    volume.x.push_back(draft);
    volume.y.push_back(f.volumeFactor * part.volume);
    area.x.push_back(draft);
    area.y.push_back(part.waterplaneArea);
  }
  return svgOf("Hydrostatics upright", {.label = "draft (m)"}, {.label = "m2, m3"}, {volume, area});
}

}  // namespace

Json asJson(const HullFigures& f) {
  Json json{{"mesh", f.name}};
  for (const Figure& figure : figuresOf(f)) json[figure.key] = figure.value;
  json["centre_of_buoyancy_m"] = vectorJson(f.rest.part.centre);
  json["centre_of_flotation_m"] = vectorJson(f.rest.part.waterplaneCentre);
  json["centre_of_gravity_m"] = vectorJson(f.body.centreOfGravity);
  json["centre_of_gravity_assumed"] = f.gravityAssumed;
  json["volume_factor"] = f.volumeFactor;
  json["hull"] = {{"lower_m", vectorJson(f.bounds.lower)},
                  {"upper_m", vectorJson(f.bounds.upper)},
                  {"volume_m3", f.whole.volume},
                  {"area_m2", f.whole.area},
                  {"centroid_m", vectorJson(f.whole.centroid)}};
  Json levers = Json::array();
  for (const RightingLever& lever : f.levers) {
    levers.push_back({{"heel_deg", degreesFromRadians(lever.heel)},
                      {"gz_m", lever.lever},
                      {"trim_deg", degreesFromRadians(lever.trim)}});
  }
  json["righting_levers"] = std::move(levers);
  json.update(checkJson(f.check));
  return json;
}

Json faultsAsJson(const std::string& name, const MeshReport& check) {
  Json json{{"mesh", name}};
  for (const char* key : {"displacement_m3", "centre_of_buoyancy_m", "waterplane_area_m2", "bm_t_m",
                          "gm_t_m", "draft_m", "wetted_area_m2"}) {
    json[key] = nullptr;
  }
  json.update(checkJson(check));
  return json;
}

void writeText(const HullFigures& f, std::ostream& out) {
  const glm::dvec3 size = f.bounds.size(), b = f.rest.part.centre, g = f.body.centreOfGravity;
  out << fmt::format("{}: {} triangles, {:.4g} x {:.4g} x {:.4g} m, encloses {:.6g} m3\n", f.name,
                     f.check.triangles, size.x, size.y, size.z, f.whole.volume);
  for (const Figure& figure : figuresOf(f)) {
    out << fmt::format("  {:<26} {:>12.6g} {}\n", figure.name, figure.value, figure.unit);
  }
  out << fmt::format("  {:<26} {:.5g}, {:.5g}, {:.5g} m\n", "centre of buoyancy", b.x, b.y, b.z);
  out << fmt::format("  {:<26} {:.5g}, {:.5g}, {:.5g} m{}\n", "centre of gravity", g.x, g.y, g.z,
                     f.gravityAssumed ? " (assumed: give --cg)" : "");
}

void writeHullReport(const HullFigures& f, const std::filesystem::path& folder) {
  HtmlPage page("Hull: " + f.name);
  std::vector<std::vector<std::string>> rows;
  for (const Figure& figure : figuresOf(f)) {
    rows.push_back({figure.name, fmt::format("{:.6g}", figure.value), figure.unit});
  }
  page.table({"at rest", "", "unit"}, rows);
  page.table({"mesh", ""}, {{"triangles", std::to_string(f.check.triangles)},
                            {"volume inside", fmt::format("{:.6g} m3", f.whole.volume)},
                            {"passing through each other",
                             std::to_string(f.check.selfIntersections) + " pairs"}});
  for (const std::string& warning : warningsOf(f.check))
    page.paragraph("The mesh " + warning + ".");
  page.heading("Righting levers");
  page.figure(leverPlot(f), "Free to sink and trim at every heel; positive where it rights.");
  page.heading("Over the draft");
  page.figure(draftPlot(f), "Upright, of the polyhedron.");
  AtomicFile json(folder / "hull.json"), html(folder / "report.html");
  json.stream() << asJson(f).dump(2) << '\n';
  html.stream() << page.text();
  json.commit();
  html.commit();
}

}  // namespace seaway::bridge
