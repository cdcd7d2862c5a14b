#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "render/exr.h"
#include "render/png.h"
#include "tests/sim_bridge/test_support.h"

// What commands write of a frame beside its PNG.
namespace seaway::bridge {
namespace {

using nlohmann::json;
using test::seaway;
using test::TempFolder;
using test::writeScene;

/// The launch seen from the side, near by.
const std::vector<std::pair<std::string, std::string>> seenFromAstern{
    {"  - name: bow\n    mount: launch\n    position_m: [3, 0, 3.2]\n",
     "  - name: chase\n    mount: launch\n    stabilised: true\n    position_m: [-19, 9, 6.5]\n"
     "    yaw_deg: 24\n    pitch_deg: -11\n"}};

glm::dvec3 vec(const json& list) { return {list[0], list[1], list[2]}; }

glm::dmat3 rows(const json& lists) {
  return glm::transpose(glm::dmat3(vec(lists[0]), vec(lists[1]), vec(lists[2])));
}

TEST(FrameOutputs, OneFrameGivesAllOfThem) {
  const TempFolder folder;
  const std::string scene = writeScene(folder, seenFromAstern).string();
  const auto at = [&](const char* name) { return (folder / name).string(); };
  const auto outcome =
      seaway({"render",       scene,        "--time",       "1",
              "--size",       "160x120",    "--out",        at("a.png"),
              "--depth",      at("a.exr"),  "--radiance",   at("a.exr"),
              "--normals",    at("n.exr"),  "--labels",     at("labels.png"),
              "--frame-json", at("a.json"), "--distortion", "-0.1,0.02,0.001,-0.001"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  glm::ivec2 size;
  const std::vector<float> depth = render::readDepthExr(folder / "a.exr", size);
  EXPECT_EQ(size, glm::ivec2(160, 120));
  EXPECT_EQ(render::readRadianceExr(folder / "a.exr", size).size(), 19200u);
  const std::vector<std::uint16_t> labels = render::readGreyPng(folder / "labels.png", size);
  const json frame = json::parse(test::readFile(folder / "a.json"));
  EXPECT_EQ(frame["time_s"], 1.0);
  EXPECT_EQ(frame["camera"]["distortion"]["k1"], -0.1);
  EXPECT_EQ(frame["camera"]["distortion"]["p1"], 0.001);
  ASSERT_EQ(frame["instances"].size(), 1u);
  const json& launch = frame["instances"][0];
  EXPECT_EQ(launch["name"], "launch");
  EXPECT_EQ(launch["label"], 16);
  // Every label that the picture has is in its table; the box is that of the launch's.
  glm::ivec2 least(1000), most(-1);
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    EXPECT_TRUE(frame["labels"].contains(std::to_string(labels[i]))) << labels[i];
    EXPECT_EQ(labels[i] == 0, std::isinf(depth[i])) << i;
    if (labels[i] != 16) continue;
    const glm::ivec2 pixel(static_cast<int>(i % 160), static_cast<int>(i / 160));
    least = glm::min(least, pixel);
    most = glm::max(most, pixel + 1);
    ++pixels;
  }
  EXPECT_GT(pixels, 100u);
  EXPECT_EQ(launch["visible_pixels"], pixels);
  EXPECT_EQ(launch["box_2d_px"], (json{least.x, least.y, most.x, most.y}));
  std::set<std::string> on;
  for (const json& effect : frame["effects_on"]) on.insert(effect["name"]);
  EXPECT_TRUE(on.contains("water") && on.contains("vessel_meshes"));
}

// A perception engineer's reading of the file: corners of the 3-D box through pose, camera and
// pinhole fall around the 2-D box.
TEST(FrameOutputs, BoxesFollowFromPosesByTheConventionsStated) {
  const TempFolder folder;
  const std::string scene = writeScene(folder, seenFromAstern).string();
  const auto outcome =
      seaway({"render", scene, "--time", "1", "--size", "320x240", "--intrinsics",
              "300,280,150.5,130.25", "--out", (folder / "a.png").string(), "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json frame = json::parse(outcome.out)["frame"];
  const json& camera = frame["camera"];
  const json& launch = frame["instances"][0];
  const glm::dmat3 worldFromBody = rows(launch["sea_plane"]["world_from_body"]);
  const glm::dmat3 cameraFromWorld = rows(camera["opencv"]["camera_from_world"]);
  glm::dvec2 least(1e9), most(-1e9);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 low = vec(launch["box_3d"]["least_m"]), high = vec(launch["box_3d"]["most_m"]);
    const glm::dvec3 body(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y,
                          corner & 4 ? high.z : low.z);
    const glm::dvec3 world = worldFromBody * body + vec(launch["sea_plane"]["position_m"]) -
                             glm::dvec3(0, 0, launch["drawn_lower_by_m"].get<double>());
    const glm::dvec3 p = cameraFromWorld * world + vec(camera["opencv"]["translation_m"]);
    ASSERT_GT(p.z, 0.0);
    const glm::dvec2 pixel(300.0 * p.x / p.z + 150.5, 280.0 * p.y / p.z + 130.25);
    least = glm::min(least, pixel);
    most = glm::max(most, pixel);
  }
  const json& box = launch["box_2d_px"];
  // The visible part lies within the box of the corners, and fills it but for what the sea hides
  // below and a hull that is slimmer at its ends.
  EXPECT_GE(box[0].get<double>(), least.x - 1.0);
  EXPECT_GE(box[1].get<double>(), least.y - 1.0);
  EXPECT_LE(box[2].get<double>(), most.x + 1.5);
  EXPECT_LE(box[3].get<double>(), most.y + 1.5);
  EXPECT_GT(box[2].get<double>() - box[0].get<double>(), 0.6 * (most.x - least.x));
  // The matrices are rotations and agree with quaternion and place.
  EXPECT_NEAR(glm::determinant(worldFromBody), 1.0, 1e-12);
  EXPECT_NEAR(glm::determinant(cameraFromWorld), 1.0, 1e-12);
  const glm::dvec3 atCamera = cameraFromWorld * vec(camera["sea_plane"]["position_m"]) +
                              vec(camera["opencv"]["translation_m"]);
  EXPECT_LE(glm::length(atCamera), 1e-9);
}

TEST(FrameOutputs, ARunWritesWhatIsAskedForAndARunAfterItTakesItAway) {
  const TempFolder folder;
  const std::string scene = writeScene(folder).string(), out = (folder / "out").string();
  ASSERT_EQ(seaway({"run", scene, "--out", out, "--also", "json,labels,depth", "--also",
                    "normals,radiance"})
                .status,
            0);
  for (const char* suffix :
       {".png", ".json", ".labels.png", ".depth.exr", ".normals.exr", ".radiance.exr"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / ("out/frames/000001" + std::string(suffix))))
        << suffix;
  }
  const json frame = json::parse(test::readFile(folder / "out/frames/000001.json"));
  EXPECT_EQ(frame["time_s"], 0.5);
  folder.write("out/frames/000001.notes", "mine");
  ASSERT_EQ(seaway({"run", scene, "--out", out, "--fps", "1"}).status, 0);
  std::vector<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "out/frames")) {
    left.push_back(entry.path().filename().string());
  }
  std::sort(left.begin(), left.end());
  EXPECT_EQ(left, (std::vector<std::string>{"000000.png", "000001.notes"}));
}

TEST(FrameOutputs, SamplesMakeAPictureOfTheSameSize) {
  const TempFolder folder;
  const std::string scene = writeScene(folder).string();
  for (const char* samples : {"1", "3"}) {
    ASSERT_EQ(seaway({"render", scene, "--time", "1", "--aa", samples, "--out",
                      (folder / (std::string(samples) + ".png")).string()})
                  .status,
              0);
  }
  const render::ColourImage once = render::readPng(folder / "1.png"),
                            often = render::readPng(folder / "3.png");
  EXPECT_EQ(once.size, often.size);
  EXPECT_NE(once.rgb, often.rgb);
}

TEST(FrameOutputs, ASceneCamerasPinholeAndLensAreReadCheckedAndDrawn) {
  const TempFolder folder;
  const auto withCamera = [&](const std::string& keys) {
    return writeScene(folder, {{"    fov_deg: 60\n", keys}}).string();
  };
  const auto render = [&](const std::string& scene) {
    return seaway({"render", scene, "--time", "0", "--size", "64x48", "--out",
                   (folder / "a.png").string(), "--json"});
  };
  const std::string pinhole =
      "    intrinsics: {fx_px: 1000, fy_px: 1000, cx_px: 600, cy_px: 500, size: [1280, 960]}\n";
  const auto drawn = render(withCamera(pinhole + "    distortion: {k1: -0.2, p2: 0.001}\n"));
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  const json camera = json::parse(drawn.out)["frame"]["camera"];
  EXPECT_NEAR(camera["intrinsics"]["fx_px"].get<double>(), 50.0, 1e-12);
  EXPECT_NEAR(camera["intrinsics"]["cx_px"].get<double>(), 600.5 / 20.0 - 0.5, 1e-12);
  EXPECT_EQ(camera["distortion"]["p2"], 0.001);
  const auto fault = [&](const std::string& keys, const std::string& named) {
    const auto outcome = render(withCamera(keys));
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(named), std::string::npos) << outcome.err;
  };
  fault("    fov_deg: 60\n" + pinhole, "fov_deg");
  fault("    intrinsics: {fx_px: 0, fy_px: 1, cx_px: 1, cy_px: 1, size: [9, 9]}\n", "fx_px");
  fault("    intrinsics: {fx_px: 1, fy_px: 1, cx_px: 1, cy_px: 1, size: [900, 900]}\n", "89.9");
  fault("    intrinsics: {fx_px: 9, fy_px: 9, cx_px: 1, cy_px: 1}\n", "size");
  fault("    distortion: {k1: -9}\n", "k1 = -9");
  fault("    distortion: {k4: 1}\n", "k4");
}

TEST(FrameOutputs, WhatCannotBeIsRefusedBeforeAnyWork) {
  const TempFolder folder;
  const std::string scene = writeScene(folder).string(), png = (folder / "a.png").string();
  const auto fault = [&](std::vector<std::string> more, const std::string& named) {
    std::vector<std::string> words{"render", scene, "--time", "1", "--out", png};
    words.insert(words.end(), more.begin(), more.end());
    const auto outcome = seaway(words);
    EXPECT_EQ(outcome.status, 2) << named;
    EXPECT_NE(outcome.err.find(named), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(png)) << named;
  };
  fault({"--aa", "17"}, "17");
  fault({"--aa", "0"}, "[1, 16]");
  fault({"--aa", "16", "--size", "8192x8192"}, "33554432");
  fault({"--intrinsics", "1,2,3"}, "FX,FY,CX,CY");
  fault({"--intrinsics", "0.001,0.001,32,24"}, "89.9");
  fault({"--intrinsics", "nan,1,32,24"}, "FX,FY,CX,CY");
  fault({"--distortion", "-3,0,0,0"}, "folds");
  fault({"--distortion", "a,0,0,0"}, "K1,K2,P1,P2");
  fault({"--distortion", "-0.1,0,0,0", "--compare", "reference"}, "pinholes");
  fault({"--labels", (folder / "l.exr").string()}, ".png");
  fault({"--radiance", (folder / "r.png").string()}, ".exr");
  fault({"--radiance", "/proc/none/r.exr"}, "cannot be written");
  fault({"--frame-json", "/proc/none/f.json"}, "cannot be written");
  EXPECT_EQ(seaway({"run", scene, "--out", (folder / "o").string(), "--also", "colour"}).status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "o"));
}

TEST(FrameOutputsHard, AFullDiskLeavesNothingHalfWritten) {
  // /dev/full takes no bytes: a link to it in place of the file is no regular one.
  const TempFolder folder;
  const std::string scene = writeScene(folder).string();
  std::filesystem::create_symlink("/dev/full", folder / "full.json");
  const auto outcome = seaway({"render", scene, "--time", "1", "--out", (folder / "a.png").string(),
                               "--frame-json", (folder / "full.json").string()});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("regular file"), std::string::npos) << outcome.err;
  // A file may grow to 8 blocks: depth does not fit.
  const std::string command = "ulimit -f 8; " + std::string(SEAWAY_COMMAND) + " render " + scene +
                              " --time 1 --size 320x200 --out " + (folder / "b.png").string() +
                              " --depth " + (folder / "b.exr").string() + " 2>/dev/null";
  EXPECT_NE(std::system(("trap '' XFSZ; " + command).c_str()), 0);
  for (const std::string& name : folder.files()) {
    EXPECT_TRUE(name != "b.exr" && name != "b.png" && name.find("part") == std::string::npos)
        << name;
  }
}

TEST(FrameOutputsHard, OnePixelGivesAllOfThemToo) {
  const TempFolder folder;
  const std::string scene = writeScene(folder).string();
  const auto outcome =
      seaway({"render", scene, "--time", "1", "--size", "1x1", "--aa", "16", "--out",
              (folder / "a.png").string(), "--radiance", (folder / "a.exr").string(), "--labels",
              (folder / "l.png").string(), "--json", "--distortion", "-0.1,0,0,0"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

}  // namespace
}  // namespace seaway::bridge
