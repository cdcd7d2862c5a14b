#include <gtest/gtest.h>
#include <httplib.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>
#include <thread>

#include "surface/input_error.h"
#include "tests/sim_bridge/service/served_child.h"
#include "tests/sim_bridge/service/served_waters.h"

// Free vessels that cannot float, or cannot sail, in a scene that is to be served.
namespace seaway::bridge {
namespace {

using test::drivenVessel;
using test::freeScene;
using test::ServedWaters;
using test::TempFolder;

struct Unseaworthy {
  std::string from, to;               ///< in the vessel's file
  std::vector<std::string> messages;  ///< what the refusal says
};

const std::vector<Unseaworthy> all{
    {"13131", "40000", {"scene.yaml:3", "vessels[0].model", "below the hull's volume"}},
    {"13131", "131310", {"driven.yaml:1", "'hull'", "would sink"}},
    {"13131", "0", {"driven.yaml:5", "mass_kg"}},
    {"13131", "-5", {"driven.yaml:5", "mass_kg", "-5"}},
    {"13131", ".nan", {"driven.yaml:5", "mass_kg"}},
    {"keel_m: 0.9", "keel_m: 3.9", {"driven.yaml:1", "would capsize"}},
    {"wigley:12,3,0.8,1", "wigley:12,3,0,1", {"wigley"}},
    {"wigley:12,3,0.8,1", "gone.stl", {"gone.stl"}},
    {"propeller:", "#", {"propeller"}},
};

std::string vesselOf(const Unseaworthy& each) {
  std::string text = drivenVessel;
  const std::size_t at = text.find(each.from);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, each.from.size(), each.to);
}

/// The free scene with its vessel's files; the vessel's can be written anew.
struct Files {
  Files() {
    folder.write("launch.yaml", test::vesselText());
    folder.write("driven.yaml", drivenVessel);
    scene = folder.write("scene.yaml", freeScene()).string();
  }
  TempFolder folder;
  std::string scene;
};

TEST(ServedFreeVesselsHard, WhatCannotFloatIsRefusedAtTheStartWithFileKeyAndReason) {
  const Files files;
  for (const Unseaworthy& each : all) {
    files.folder.write("driven.yaml", vesselOf(each));
    const test::Outcome outcome = test::seaway({"serve", files.scene, "--metrics", "0"});
    EXPECT_EQ(outcome.status, 2) << each.to;
    EXPECT_EQ(outcome.err.find(" serves "), std::string::npos) << outcome.err;
    for (const std::string& message : each.messages) {
      EXPECT_NE(outcome.err.find(message), std::string::npos) << each.to << ": " << outcome.err;
    }
  }
}

TEST(ServedFreeVesselsHard, WhatCannotFloatIsRefusedAtAReloadAndTheOldOnesSailOn) {
  const Files files;
  test::ServedChild child(files.scene, {"--metrics", "0", "--clock", "x8"});
  const SocketAddress http = child.address("http://");
  const auto place = [&] {
    httplib::Client client(http.host, http.port);
    const auto answer = client.Get("/status.json");
    EXPECT_TRUE(answer && answer->status == 200);
    if (!answer) return glm::dvec2(NAN);
    const auto vessel = nlohmann::json::parse(answer->body)["vessels"][0];
    return glm::dvec2(vessel["latitude_deg"], vessel["longitude_deg"]);
  };
  for (const Unseaworthy& each : all) {
    files.folder.write("driven.yaml", vesselOf(each));
    child.send(SIGHUP);
    child.awaitText("the scene stays as it was");
    for (const std::string& message : each.messages) child.awaitText(message);
  }
  // At 4 m/s and eight times as fast 20 m take less than a second; 0.0001 degrees are 11 m.
  const glm::dvec2 last = place();
  const auto moved = [&] { return glm::distance(place(), last); };
  for (int i = 0; i < 1200 && moved() < 0.00018; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_GE(moved(), 0.00018);
  files.folder.write("driven.yaml", drivenVessel);
  child.send(SIGHUP);
  child.awaitText("is loaded anew");
  EXPECT_EQ(child.end(SIGTERM), 0);
}

// What a loader has let through is found by who serves it, before anything has changed.
TEST(ServedFreeVesselsHard, ASceneThatOnlyItsLaunchingRefusesLeavesTheServedOneWhole) {
  ServedWaters served(freeScene());
  Scene broken = served.scene;
  broken.vessels[0].model.propeller = {};
  EXPECT_NE(test::inputErrorOf([&] {
              ServedSea(broken, buildSea(broken));
            }).find("'pilot' has waypoints, but its model has no propeller and rudder"),
            std::string::npos);
  const std::uint32_t hull = served.sea.addHull(1);
  EXPECT_TRUE(served.sea.place(hull, 3.0, served.poseAt({30.0, 0.0})));
  served.bringWakes(4.0, {0.0, 10.0});
  const auto scene = served.sea.scene();
  const auto surface = served.sea.surface();
  const auto waves = served.sea.wavesVersion();
  const auto before = served.sea.hulls(4.0);
  EXPECT_THROW(served.sea.replaceScene(broken, buildSea(broken)), InputError);
  EXPECT_EQ(served.sea.scene(), scene);
  EXPECT_EQ(served.sea.surface(), surface);
  EXPECT_EQ(served.sea.wavesVersion(), waves);
  const auto after = served.sea.hulls(4.0);
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(after[i].hull, before[i].hull);
    EXPECT_EQ(after[i].outOfTime, before[i].outOfTime);
    EXPECT_EQ(after[i].pose.position, before[i].pose.position);
    EXPECT_EQ(after[i].pose.height, before[i].pose.height);
  }
  EXPECT_FALSE(after[0].outOfTime);
}

}  // namespace
}  // namespace seaway::bridge
