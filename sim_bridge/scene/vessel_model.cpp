#include "sim_bridge/scene/vessel_model.h"

#include "sim_bridge/scene/light_schema.h"
#include "sim_bridge/scene/schema_fields.h"

namespace seaway::bridge {
namespace {

// The three mappings that fill one BoxHull, each with the keys of its topic.
Mapping<BoxHull> boxSchema() {
  return Mapping<BoxHull>(
      {
          number("length_m", &BoxHull::length, "m", Range::above(0.0), "length of the waterplane",
                 Need::required),
          number("beam_m", &BoxHull::beam, "m", Range::above(0.0), "beam of the waterplane",
                 Need::required),
          number("depth_m", &BoxHull::depth, "m", Range::above(0.0), "keel to deck edge",
                 Need::required),
          number("draft_m", &BoxHull::givenDraft, "m", Range::above(0.0),
                 "draft at rest in sea water of 1026 kg/m³; exactly one of this and mass_kg"),
          number("mass_kg", &BoxHull::givenMass, "kg", Range::above(0.0),
                 "mass; exactly one of this and draft_m"),
          number("centre_of_gravity_above_keel_m", &BoxHull::centreOfGravityAboveKeel, "m",
                 Range::atLeast(0.0), "height of the centre of gravity", Need::required),
          number("roll_gyradius_m", &BoxHull::givenRollGyradius, "m", Range::above(0.0),
                 "radius of gyration about the fore-and-aft axis; else 0.35 beam_m"),
          number("pitch_gyradius_m", &BoxHull::givenPitchGyradius, "m", Range::above(0.0),
                 "radius of gyration about the athwartships axis; else 0.25 length_m"),
          number("heave_damping", &BoxHull::heaveDamping, "1", Range::atLeast(0.0),
                 "part of critical damping, relative to the water's vertical velocity"),
          number("roll_damping", &BoxHull::rollDamping, "1", Range::atLeast(0.0),
                 "part of critical damping, relative to the turning of the water's slope"),
          number("pitch_damping", &BoxHull::pitchDamping, "1", Range::atLeast(0.0),
                 "part of critical damping, relative to the turning of the water's slope"),
          vector("columns", &BoxHull::columns, "", Range::within(2, 200),
                 "sampled columns, along and across"),
      },
      [](const BoxHull& hull, const YamlValue& value) {
        if (const auto fault = hull.fault()) value.fail(*fault);
      });
}

Mapping<VesselDrawing> drawingSchema() {
  const Range reflectance = Range::within(0.0, 1.0);
  return Mapping<VesselDrawing>({
      choice("shape", &VesselDrawing::shape,
             {{"launch", VesselShape::launch},
              {"open_launch", VesselShape::openLaunch},
              {"buoy", VesselShape::buoy},
              {"mesh", VesselShape::mesh}},
             "what is drawn, stretched to the hull's dimensions; open_launch has a cockpit aft; "
             "mesh: as `source` has it, the sea kept out of its hollows"),
      text(
          "source", &VesselDrawing::source,
          "of shape mesh: as `source` of `mesh`, with its unit, axes and origin; else that itself"),
      vector("hull_colour", &VesselDrawing::hullColour, "", reflectance,
             "linear reflectance: red, green, blue"),
      vector("deck_colour", &VesselDrawing::deckColour, "", reflectance,
             "linear reflectance: red, green, blue"),
      vector("house_colour", &VesselDrawing::houseColour, "", reflectance,
             "linear reflectance: red, green, blue"),
  });
}

Mapping<VesselWake> wakeSchema() {
  return Mapping<VesselWake>({
      choice(
          "form", &VesselWake::form,
          {{"drawn", WakeForm::drawn}, {"box", WakeForm::box}, {"wigley", WakeForm::wigley}},
          "hull that makes the waves: as drawn below the water (of shape mesh: the mesh that "
          "loads are taken on), the box, or Wigley's parabolic hull of the same length, beam and "
          "draft"),
      number("strength", &VesselWake::strength, "1", Range::within(0.0, 2.0),
             "part of the waves that linear theory gives such a hull; less for one that planes"),
      choice("felt_by_itself", &VesselWake::feltByItself, {{"true", true}, {"false", false}},
             "whether the hull rides its own waves too; their resistance is in its prescribed "
             "speed"),
  });
}

}  // namespace

const Mapping<VesselModel>& vesselModelSchema() {
  static const Mapping<VesselModel> schema({
      text("description", &VesselModel::description, "a line for people"),
      mapping("hull", &VesselModel::hull, boxSchema(), "the box that floats", Need::required),
      mapping("drawing", &VesselModel::drawing, drawingSchema(), "how it looks"),
      mapping("mesh", &VesselModel::mesh, hullMeshSchema(),
              "the closed hull that loads on a free vessel are taken on"),
      mapping("propeller", &VesselModel::propeller, propellerSchema(), "of a free vessel"),
      mapping("rudder", &VesselModel::rudder, rudderSchema(), "of a free vessel"),
      mapping("lights", &VesselModel::lights, vesselLightsSchema(), "navigation lights"),
      mapping("wake", &VesselModel::wake, wakeSchema(), "the waves it makes under way"),
  });
  return schema;
}

VesselModel loadVesselModel(const std::filesystem::path& file) {
  VesselModel model = vesselModelSchema().read(readYaml(file));
  model.mesh.folder = file.parent_path();
  return model;
}

}  // namespace seaway::bridge
