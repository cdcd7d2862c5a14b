#include "sim_bridge/scene/yaml_value.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim_bridge/scene/schema.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::inputErrorOf;

TEST(YamlValue, KnowsKeyAndLineOfEveryValue) {
  const YamlValue document = parseYaml("a:\n  b:\n    - {c: 1}\n    - {c: 2}\n", "f.yaml");
  const YamlValue& second = *document.find("a")->find("b")->values[1].find("c");
  EXPECT_EQ(second.key, "a.b[1].c");
  EXPECT_EQ(second.line, 4);
  EXPECT_EQ(second.scalar, "2");
}

TEST(YamlValue, SyntaxErrorsTellFileAndLine) {
  const std::string message = inputErrorOf([] { parseYaml("a: 1\nb: [1, 2\nc: 3\n", "f.yaml"); });
  EXPECT_EQ(message.rfind("f.yaml:3: not valid YAML", 0), 0u) << message;
}

TEST(YamlValue, KeyGivenTwiceIsAnError) {
  EXPECT_EQ(inputErrorOf([] { parseYaml("a: 1\nb: 2\na: 3\n", "f.yaml"); }),
            "f.yaml:3: key 'a': is given twice");
}

TEST(YamlValue, ASecondDocumentIsAnErrorNotIgnored) {
  EXPECT_EQ(inputErrorOf([] { parseYaml("a: 1\n---\nb: 2\n", "f.yaml"); }),
            "f.yaml:3: a second YAML document starts here; a file holds one");
  EXPECT_EQ(inputErrorOf([] { parseYaml("---\na: 1\n...\n", "f.yaml"); }), "");
  EXPECT_EQ(inputErrorOf([] { parseYaml("", "f.yaml"); }), "");
}

TEST(YamlValueHard, EndlessNestingAndAliasBombsEndWithAMessage) {
  const std::string deep = std::string(200, '[') + std::string(200, ']');
  EXPECT_NE(inputErrorOf([&] { parseYaml(deep, "f.yaml"); }).find("too deep"), std::string::npos);
  std::string bomb = "a: &a [1,1,1,1,1,1,1,1,1,1]\n";
  for (char name = 'b'; name <= 'i'; ++name) {
    const std::string before(1, static_cast<char>(name - 1));
    bomb += std::string(1, name) + ": &" + name + " [*" + before;
    for (int i = 0; i < 9; ++i) bomb += ",*" + before;
    bomb += "]\n";
  }
  EXPECT_NE(inputErrorOf([&] { parseYaml(bomb, "f.yaml"); }).find("too large"), std::string::npos);
}

TEST(Schema, NumbersTakeEveryYamlSpelling) {
  const auto read = [](const std::string& text, Range range = Range::any()) {
    return readNumber(*parseYaml("v: " + text, "f").find("v"), range, "m");
  };
  EXPECT_EQ(read("1e3"), 1000.0);
  EXPECT_EQ(read("+.5"), 0.5);
  EXPECT_EQ(read("-0"), 0.0);
  EXPECT_TRUE(std::isinf(read(".inf", Range::above(0.0).orInfinite())));
  EXPECT_TRUE(std::isinf(read("inf", Range::above(0.0).orInfinite())));
}

TEST(Schema, RefusesWhatIsNoNumberOrOutOfRange) {
  const auto message = [](const std::string& text, const Range& range) {
    return inputErrorOf([&] { readNumber(*parseYaml("v: " + text, "f").find("v"), range, "m"); });
  };
  EXPECT_EQ(message("1 m", Range::above(0.0)),
            "f:1: key 'v': '1 m' is not a number; must be > 0 m");
  EXPECT_EQ(message("0", Range::above(0.0)), "f:1: key 'v': 0 is not allowed; must be > 0 m");
  EXPECT_EQ(message(".nan", Range::any()), "f:1: key 'v': .nan is not allowed; must be finite m");
  EXPECT_NE(message(".inf", Range::above(0.0)), "");
  EXPECT_NE(message("1e999", Range::any()), "");
  EXPECT_NE(message("[1]", Range::any()), "");
  EXPECT_NE(message("", Range::any()), "");
}

TEST(Schema, NearestNameFindsSlipsButNoFarFetchedOnes) {
  EXPECT_EQ(nearestName("stat", {"anchor", "state", "seed"}), "state");
  EXPECT_EQ(nearestName("fov_degs", {"fov_deg", "yaw_deg"}), "fov_deg");
  EXPECT_EQ(nearestName("zzzzzz", {"anchor", "state", "seed"}), "");
}

}  // namespace
}  // namespace seaway::bridge
