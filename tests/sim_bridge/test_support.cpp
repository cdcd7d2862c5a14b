#include "tests/sim_bridge/test_support.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "surface/input_error.h"

namespace seaway::bridge::test {
namespace {

namespace fs = std::filesystem;

std::string quoted(const std::string& argument) {
  std::string text = "'";
  for (const char c : argument) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string replaced(std::string text,
                     const std::vector<std::pair<std::string, std::string>>& replacements) {
  for (const auto& [from, to] : replacements) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("not in the fixture: " + from);
    text.replace(at, from.size(), to);
  }
  return text;
}

}  // namespace

TempFolder::TempFolder() {
  std::string pattern = (fs::temp_directory_path() / "seaway_test_XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("no temporary folder");
  path_ = pattern;
}

TempFolder::~TempFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path TempFolder::write(const std::string& name, const std::string& text) const {
  fs::create_directories((path_ / name).parent_path());
  std::ofstream(path_ / name, std::ios::binary) << text;
  return path_ / name;
}

std::vector<std::string> TempFolder::files() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(path_)) {
    if (entry.is_regular_file()) names.push_back(fs::relative(entry.path(), path_).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string readFile(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  EXPECT_TRUE(stream) << file;
  return {std::istreambuf_iterator<char>(stream), {}};
}

Outcome seaway(const std::vector<std::string>& arguments, const std::string& input) {
  const TempFolder folder;
  const fs::path in = folder.write("in", input);
  std::string command = quoted(SEAWAY_COMMAND);
  for (const std::string& argument : arguments) command += " " + quoted(argument);
  command += " <" + quoted(in.string()) + " >" + quoted((folder / "out").string()) + " 2>" +
             quoted((folder / "err").string());
  const int status = std::system(command.c_str());
  Outcome outcome;
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  outcome.out = readFile(folder / "out");
  outcome.err = readFile(folder / "err");
  return outcome;
}

std::string inputErrorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& fault) {
    return fault.what();
  }
  return "";
}

std::string sceneText(const std::vector<std::pair<std::string, std::string>>& replacements) {
  static const std::string text = R"(sea:
  anchor: {latitude_deg: 28.878, longitude_deg: -78.467}
  depth_m: inf
  seed: 7
  state:
    jonswap:
      hm0_m: 1.12
      tp_s: 5.6
      from_deg: 196
vessels:
  - name: launch
    model: launch.yaml
    start: {latitude_deg: 28.878, longitude_deg: -78.467, heading_deg: 30}
    speed_m_s: 6
    turn_deg_s: 1
cameras:
  - name: bow
    mount: launch
    position_m: [3, 0, 3.2]
    fov_deg: 60
run: {duration_s: 1, fps: 2, size: [64, 48], step_s: 0.02}
)";
  return replaced(text, replacements);
}

std::string vesselText(const std::vector<std::pair<std::string, std::string>>& replacements) {
  static const std::string text = R"(description: test launch
hull:
  length_m: 12
  beam_m: 3.6
  depth_m: 2.0
  draft_m: 0.55
  centre_of_gravity_above_keel_m: 1.25
)";
  return replaced(text, replacements);
}

fs::path writeScene(const TempFolder& folder,
                    const std::vector<std::pair<std::string, std::string>>& replacements) {
  folder.write("launch.yaml", vesselText());
  return folder.write("scene.yaml", sceneText(replacements));
}

fs::path writeWakelessScene(const TempFolder& folder,
                            std::vector<std::pair<std::string, std::string>> replacements) {
  replacements.emplace_back("run:", "effects: {wake: off}\nrun:");
  return writeScene(folder, replacements);
}

}  // namespace seaway::bridge::test
