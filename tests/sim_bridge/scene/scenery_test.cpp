#include "sim_bridge/scene/scenery.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "render/technique_choice.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene_view.h"
#include "sim_bridge/scenery_objects.h"
#include "surface/angles.h"
#include "surface/input_error.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

namespace fs = std::filesystem;

class SceneryFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              ("seaway_scenery_" + std::to_string(::getpid()) + "_" +
               ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  std::string fault(const fs::path& file) const {
    try {
      readColouredMesh(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  /// A scene with one thing of that mesh, at line 5.
  std::string scene(const std::string& mesh, const std::string& more = "") const {
    return "sea: {anchor: {latitude_deg: 10, longitude_deg: 20}, state: {calm: {}}}\n"
           "cameras: [{name: eye, place: {latitude_deg: 10, longitude_deg: 20, height_m: 3}}]\n"
           "scenery:\n"
           "  - name: thing\n"
           "    mesh: " +
           mesh +
           "\n"
           "    place: {latitude_deg: 10.0001, longitude_deg: 20, height_m: 1}\n" +
           more;
  }
  std::string sceneFault(const std::string& yaml) const {
    try {
      sceneFromText(yaml, folder_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  static void expectSays(const std::string& message, const std::string& part) {
    EXPECT_NE(message.find(part), std::string::npos) << "'" << message << "' lacks " << part;
  }

  fs::path folder_;
  const std::string triangle_ = "v 0 0 0\nv 1 0 0\nv 0 0 2\n";
};

using SceneryFilesHard = SceneryFiles;

TEST_F(SceneryFiles, MaterialsOfAnObjGiveColoursAndWhatHasNoneTheScenes) {
  write("m.mtl", "newmtl blue\nKd 0.1 0.2 0.9\nnewmtl red\nKd 0.8 0.1 0.0\n");
  write("painted.obj",
        "mtllib m.mtl\n" + triangle_ +
            "v 3 0 0\nv 3 1 0\nv 3 0 1\nusemtl red\nf 4 5 6\nusemtl blue\nf 1 2 3\n");
  write("bare.obj", triangle_ + "f 1 2 3\n");
  const auto drawn = [&](const char* file) {
    const Scene scene = sceneFromText(
        this->scene(file, "    colour: [0.3, 0.4, 0.5]\n    scale: 2\n    file: {unit_m: 0.5}\n"),
        folder_);
    return sceneryMesh(scene.scenery.at(0));
  };
  const render::Mesh painted = drawn("painted.obj");
  ASSERT_EQ(painted.parts.size(), 2u);
  for (const render::Mesh::Part& part : painted.parts) {
    ASSERT_EQ(part.vertices.size(), 3u);
    const bool blue = part.vertices[0].x < 2.0f;
    EXPECT_EQ(part.colour, blue ? glm::vec3(0.1f, 0.2f, 0.9f) : glm::vec3(0.8f, 0.1f, 0.0f));
  }
  EXPECT_FLOAT_EQ(static_cast<float>(painted.boundingRadius), std::sqrt(10.0f));
  const render::Mesh bare = drawn("bare.obj");
  ASSERT_EQ(bare.parts.size(), 1u);
  EXPECT_EQ(bare.parts[0].colour, glm::vec3(0.3f, 0.4f, 0.5f));
}

TEST_F(SceneryFiles, AGltfsBaseColourIsTaken) {
  // One triangle: three positions of three floats in the buffer.
  write(
      "t.gltf",
      R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],)"
      R"("materials":[{"name":"paint","pbrMetallicRoughness":{"baseColorFactor":[0.25,0.5,0.75,1]}}],)"
      R"("buffers":[{"uri":"data:application/octet-stream;base64,)"
      R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA","byteLength":36}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",)"
      R"("min":[0,0,0],"max":[1,1,0]}]})");
  const ColouredMesh mesh = readColouredMesh(folder_ / "t.gltf");
  ASSERT_EQ(mesh.parts.size(), 1u);
  EXPECT_EQ(mesh.parts[0].colour, glm::vec3(0.25f, 0.5f, 0.75f));
  EXPECT_EQ(mesh.parts[0].mesh.triangles.size(), 1u);
}

TEST_F(SceneryFiles, AFaultNamesSceneLineKeyAndFile) {
  const std::string missing = sceneFault(scene("none.obj"));
  expectSays(missing, "<text>:5");
  expectSays(missing, "scenery[0].mesh");
  expectSays(missing, (folder_ / "none.obj").string());
  write("empty.obj", "");
  expectSays(sceneFault(scene("empty.obj")), "<text>:5");
  expectSays(sceneFault(scene("empty.obj")), (folder_ / "empty.obj").string());
  write("ok.obj", triangle_ + "f 1 2 3\n");
  expectSays(sceneFault(scene("ok.obj", "    scale: 0\n")), "must be > 0");
  expectSays(sceneFault(scene("ok.obj", "    colour: [2, 0, 0]\n")), "[0, 1]");
  expectSays(sceneFault(scene("ok.obj", "    file: {forward: +z}\n")), "same axis");
  const std::string far =
      "scenery: [{name: a, mesh: ok.obj, place: {latitude_deg: 50, "
      "longitude_deg: 20}}]\n";
  expectSays(
      sceneFault("sea: {anchor: {latitude_deg: 10, longitude_deg: 20}, state: {calm: {}}}\n" + far),
      "km from the scene's anchor");
  const std::string twice = scene("ok.obj") +
                            "  - {name: thing, mesh: ok.obj, place: {latitude_deg: 10, "
                            "longitude_deg: 20}}\n";
  expectSays(sceneFault(twice), "given twice");
}

TEST_F(SceneryFilesHard, WhatAMeshRefersToMustBeThere) {
  write("a.obj", "mtllib gone.mtl\nusemtl x\n" + triangle_ + "f 1 2 3\n");
  expectSays(fault(folder_ / "a.obj"), "gone.mtl");
  write("m.mtl", "newmtl x\nKd 1 1 1\nmap_Kd gone.png\n");
  write("b.obj", "mtllib m.mtl\nusemtl x\n" + triangle_ + "f 1 2 3\n");
  expectSays(fault(folder_ / "b.obj"), (folder_ / "gone.png").string());
  write("gone.png", "x");
  EXPECT_EQ(readColouredMesh(folder_ / "b.obj").remarks.size(), 1u);
}

TEST_F(SceneryFilesHard, MeshesThatHoldNothingToDrawAreRefused) {
  write("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 0 2\nf 1 2 3\n");
  expectSays(fault(folder_ / "nan.obj"), "nan.obj");
  write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\nf 1 1 2\n");
  expectSays(fault(folder_ / "flat.obj"), "no triangle that has an area");
  write("points.obj", "v 0 0 0\nv 1 0 0\n");
  expectSays(fault(folder_ / "points.obj"), "points.obj");
  write("noise.stl", "not a mesh at all");
  expectSays(fault(folder_ / "noise.stl"), "noise.stl");
  write("noise.gltf", "{");
  expectSays(fault(folder_ / "noise.gltf"), "noise.gltf");
  expectSays(fault(folder_), "is no file");
  write("some.obj", triangle_ + "f 1 2 3\nf 1 1 2\n");
  const ColouredMesh some = readColouredMesh(folder_ / "some.obj");
  EXPECT_EQ(some.parts.at(0).mesh.triangles.size(), 1u);
}

TEST_F(SceneryFiles, AThingStandsWhereItsPlaceSaysAndFloatsOnTheWaves) {
  write("ok.obj", triangle_ + "f 1 2 3\n");
  Scene scene =
      sceneFromText(this->scene("ok.obj", "    heading_deg: 90\n    pitch_deg: 10\n"), folder_);
  const Geodesy geodesy({10.0, 20.0, 0.0});
  const render::Mesh mesh = sceneryMesh(scene.scenery[0]);
  const WaterSurface wave(WaveField({makeRegularWave(0.7, 0.1, 0.0, 0.3)}));
  const render::SceneObject fixed = placedScenery(scene.scenery[0], mesh, geodesy, wave, 2.0);
  EXPECT_EQ(fixed.kind, render::ObjectKind::scenery);
  EXPECT_NEAR(fixed.position.x, 0.0, 1e-6);
  EXPECT_NEAR(fixed.position.y, 11.06, 0.01);  // 0.0001° of the meridian at 10° N
  EXPECT_EQ(fixed.position.z, 1.0);
  const glm::dvec3 forward = fixed.worldFromBody * glm::dvec3(1, 0, 0);
  EXPECT_NEAR(forward.x, std::cos(radiansFromDegrees(10.0)), 1e-9);  // heading 90: east
  EXPECT_NEAR(forward.z, std::sin(radiansFromDegrees(10.0)), 1e-9);
  scene.scenery[0].floats = true;
  scene.scenery[0].pitch_deg = 0.0;
  const render::SceneObject afloat = placedScenery(scene.scenery[0], mesh, geodesy, wave, 2.0);
  const SurfaceSample water = wave.sample(glm::dvec2(fixed.position), 2.0);
  EXPECT_NEAR(afloat.position.z, 1.0 + water.height, 1e-9);
  const glm::dvec3 up = afloat.worldFromBody * glm::dvec3(0, 0, 1);
  EXPECT_NEAR(glm::length(up - water.normal()), 0.0, 1e-9);
}

TEST_F(SceneryFiles, AllTechniquesDrawItAndItsEffectSwitchesItOff) {
  write("wall.obj", "v 0 -9 -2\nv 0 9 -2\nv 0 9 6\nv 0 -9 6\nf 1 2 3 4\n");
  const std::string yaml = scene("wall.obj", "    heading_deg: 0\n") + "run: {size: [64, 48]}\n";
  for (const bool off : {false, true}) {
    const Scene scene = sceneFromText(yaml + (off ? "effects: {scenery: off}\n" : ""), folder_);
    const Sea sea = buildSea(scene);
    const Simulation simulation(scene, sea);
    SceneView view(scene);
    for (const std::string_view technique : render::techniqueNames()) {
      EffectLedger ledger(scene.effects);
      const auto drawn =
          render::makeTechnique(
              {.technique = std::string(technique), .grid = {64, 64}, .backend = "osmesa"})
              ->draw(view.view(simulation, scene.cameras[0], {64, 48}, ledger));
      const bool shown =
          std::count(drawn.classes.begin(), drawn.classes.end(), render::PixelClass::object) > 100;
      EXPECT_EQ(shown, !off) << technique;
      const EffectReport report = ledger.report()[static_cast<std::size_t>(Effect::scenery)];
      EXPECT_EQ(report.state, off ? EffectState::off : EffectState::on) << report.reason;
      EXPECT_EQ(report.memoryBytes > 0, !off) << technique;
    }
  }
}

TEST(VesselDrawnAsAMesh, StandsInTheSceneAsItsHullFloats) {
  const Scene scene = loadScene(fs::path(SEAWAY_SOURCE_DIR) / "configs/scenes/harbour.yaml");
  const auto lighter = std::find_if(scene.vessels.begin(), scene.vessels.end(),
                                    [](const SceneVessel& v) { return v.name == "lighter"; });
  ASSERT_NE(lighter, scene.vessels.end());
  ASSERT_EQ(lighter->model.drawing.shape, VesselShape::mesh);
  const Sea sea = buildSea(scene);
  const Simulation simulation(scene, sea);
  SceneView view(scene);
  EffectLedger ledger(scene.effects);
  const render::View seen = view.view(simulation, scene.cameras[0], {64, 48}, ledger);
  const auto& mesh = *seen.objects[static_cast<std::size_t>(lighter - scene.vessels.begin())].mesh;
  float lowest = 0.0f, highest = 0.0f, longest = 0.0f;
  for (const auto& part : mesh.parts) {
    for (const glm::vec3& v : part.vertices) {
      lowest = std::min(lowest, v.z);
      highest = std::max(highest, v.z);
      longest = std::max(longest, v.x);
    }
  }
  EXPECT_NEAR(highest - lowest, 2.5, 0.01);  // Wigley's 1.4 m of draft and 1.1 m of freeboard
  EXPECT_NEAR(longest, 8.0, 0.01);
}

}  // namespace
}  // namespace seaway::bridge
