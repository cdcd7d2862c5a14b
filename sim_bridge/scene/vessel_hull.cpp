#include "sim_bridge/scene/vessel_hull.h"

#include "sim_bridge/scene/schema_fields.h"
#include "sim_bridge/vessel/hull_source.h"
#include "surface/hull/analytic_hulls.h"

namespace seaway::bridge {
namespace {

TriangleMesh meshOf(const VesselHullMesh& m, const BoxHull& box) {
  if (!m.source.empty()) return hullMeshOf(m);
  return boxMesh(box.length, box.beam, box.depth, box.draft(),
                 static_cast<std::size_t>(m.triangles));
}

}  // namespace

TriangleMesh hullMeshOf(const VesselHullMesh& m) {
  const bool shape = m.source.find(':') != std::string::npos;
  const std::string source = shape ? m.source : (m.folder / m.source).string();
  const HullFileSettings settings{m.metresPerUnit, m.forward, m.up};
  return moved(hullByName(source, settings, static_cast<std::size_t>(m.triangles)), -m.origin);
}

std::shared_ptr<const HullModel> hullModelOf(const VesselHullMesh& m, const BoxHull& box) {
  const TriangleMesh mesh = meshOf(m, box);
  HullSettings settings;
  settings.level = m.level;
  settings.mass = box.mass();
  settings.gyradii = {box.rollGyradius(), box.pitchGyradius(), box.pitchGyradius()};
  settings.columns = box.columns;
  settings.knownVolume = m.knownVolume;
  settings.knownWaterplane = m.knownWaterplane;
  HullCoefficients& c = settings.coefficients;
  c.formDrag = m.formDrag;
  c.skinFriction = m.skinFriction;
  c.slamming = m.slamming;
  c.windDrag = m.windDrag;
  c.heaveDamping = box.heaveDamping;
  c.rollDamping = box.rollDamping;
  c.pitchDamping = box.pitchDamping;
  for (int i = 0; i < 3; ++i) {
    c.addedMass[static_cast<std::size_t>(i)] = m.addedMass[i];
    c.addedMass[static_cast<std::size_t>(i) + 3] = m.addedInertia[i];
  }
  // At rest upright first: that gives the centre of buoyancy, and checks the mesh.
  const HullModel upright(mesh, settings);
  const glm::dvec3 buoyancy = upright.atRest().centre;
  settings.centreOfGravity = {buoyancy.x, buoyancy.y,
                              upright.bounds().lower.z + box.centreOfGravityAboveKeel};
  return std::make_shared<HullModel>(mesh, settings);
}

Mapping<VesselHullMesh> hullMeshSchema() {
  using M = VesselHullMesh;
  const std::vector<std::pair<std::string, std::string>> axes{
      {"+x", "+x"}, {"-x", "-x"}, {"+y", "+y"}, {"-y", "-y"}, {"+z", "+z"}, {"-z", "-z"}};
  return Mapping<M>({
      text(
          "source", &M::source,
          "STL, OBJ or glTF file, relative to the vessel file; or box:L,B,D wigley:L,B,T,FREEBOARD "
          "open_wigley:L,B,T,FREEBOARD,WALL sphere:R spar:D,T,FREEBOARD in m; else the box of "
          "`hull`"),
      integer("triangles", &M::triangles, 50, 100000, "of such a shape, about"),
      number("unit_m", &M::metresPerUnit, "m", Range::above(0.0), "length of the file's unit"),
      choice("forward", &M::forward, axes, "axis of the file to the bow"),
      choice("up", &M::up, axes, "axis of the file that points up"),
      vector("origin_m", &M::origin, "m", Range::any(),
             "body origin, in the file's frame once turned and in metres"),
      choice("level", &M::level,
             {{"columns", LoadLevel::columns},
              {"mesh", LoadLevel::mesh},
              {"mesh_dynamic", LoadLevel::meshDynamic}},
             "vertical columns; wet triangles; the waves' own pressure on them too"),
      number("displacement_m3", &M::knownVolume, "m³", Range::above(0.0),
             "known displacement below the body's z = 0, which the mesh is calibrated to"),
      number("waterplane_m2", &M::knownWaterplane, "m²", Range::above(0.0),
             "known area of the waterplane there; needs displacement_m3"),
      number("form_drag", &M::formDrag, "1", Range::atLeast(0.0),
             "C of the pressure ½ρC u|u| on panels; a plate across the flow has 2C"),
      number("skin_friction", &M::skinFriction, "1", Range::atLeast(0.0),
             "coefficient; else the ITTC 1957 line"),
      number("slamming", &M::slamming, "1", Range::atLeast(0.0),
             "C of the pressure ½ρC u² on panels that enter the water; 0: off"),
      number("wind_drag", &M::windDrag, "1", Range::atLeast(0.0), "as form_drag, in air"),
      vector("added_mass", &M::addedMass, "1", Range::within(0.0, 10.0),
             "in surge, sway, heave, parts of the mass"),
      vector("added_inertia", &M::addedInertia, "1", Range::within(0.0, 10.0),
             "in roll, pitch, yaw, parts of the moments of inertia"),
  });
}

Mapping<Propeller> propellerSchema() {
  using P = Propeller;
  return Mapping<P>({
      number("diameter_m", &P::diameter, "m", Range::above(0.0), "of the disc", Need::required),
      vector("position_m", &P::position, "m", Range::within(-1000.0, 1000.0),
             "centre of the disc: forward, to port, up from the body origin", Need::required),
      number("bollard_thrust", &P::bollardThrust, "1", Range::within(0.0, 2.0), "K_T at J = 0"),
      number("zero_thrust_advance", &P::zeroThrustAdvance, "1", Range::within(0.1, 5.0),
             "J at which K_T is 0"),
      number("wake_fraction", &P::wakeFraction, "1", Range::within(0.0, 0.9),
             "part of the speed that the hull takes from the inflow"),
      number("thrust_deduction", &P::thrustDeduction, "1", Range::within(0.0, 0.9),
             "part of the thrust that the hull does not feel"),
      number("most_revolutions_s", &P::mostRevolutions, "1/s", Range::above(0.0), "either way"),
  });
}

Mapping<Rudder> rudderSchema() {
  using R = Rudder;
  return Mapping<R>({
      number("area_m2", &R::area, "m²", Range::above(0.0), "of its side", Need::required),
      vector("position_m", &R::position, "m", Range::within(-1000.0, 1000.0),
             "forward, to port, up from the body origin", Need::required),
      number("aspect_ratio", &R::aspectRatio, "1", Range::within(0.1, 10.0), "height over chord"),
      number("most_angle_deg", &R::mostAngle_deg, "°", Range::within(1.0, 60.0), "either side"),
      number("most_rate_deg_s", &R::mostRate_deg, "°/s", Range::above(0.0), "of turning it"),
  });
}

}  // namespace seaway::bridge
