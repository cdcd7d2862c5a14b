#include "sim_bridge/output/checkpoint.h"

#include <zlib.h>

#include <cereal/types/string.hpp>
#include <cereal/types/utility.hpp>
#include <cereal/types/vector.hpp>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>
#include <vector>

#include "sim_bridge/output/atomic_file.h"
#include "surface/state_archive.h"

namespace seaway::bridge {
namespace {

namespace fs = std::filesystem;

constexpr char heading[] = "seaway checkpoint 2\n";

std::string textOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

using Sources = std::vector<std::pair<std::string, std::string>>;

/// Files that a scene is made of, by name, with their texts.
Sources sourcesOf(const Scene& scene) {
  const fs::path folder = scene.file.parent_path();
  Sources sources{{"the scene's file", textOf(scene.file)}};
  const auto add = [&](const std::string& name) {
    if (!name.empty()) sources.emplace_back(name, textOf(folder / name));
  };
  for (const SceneVessel& vessel : scene.vessels) add(vessel.modelPath);
  if (const auto* state = std::get_if<FileState>(&scene.sea.state)) add(state->path);
  add(scene.sea.outlinePath);
  for (const SceneryObject& object : scene.scenery) add(object.meshPath);
  add(scene.terrain.path);
  return sources;
}

struct Content {
  Sources sources;
  std::int64_t seed = 0;
  double step = 0.0, time = 0.0;
  std::string state;
  std::vector<KeptText> telemetry;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(sources, seed, step, time, state, telemetry);
  }
};

std::uint32_t checksum(const std::string& text) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size()));
}

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
  throw InputError(file.string(), 0, what);
}

Content contentOf(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) fail(file, "no such file");
  std::ifstream stream(file, std::ios::binary);
  std::string first(sizeof(heading) - 1, '\0');
  stream.read(first.data(), static_cast<std::streamsize>(first.size()));
  if (first != heading) fail(file, "is no checkpoint of this version of Seaway");
  std::uint32_t sum = 0;
  stream.read(reinterpret_cast<char*>(&sum), sizeof(sum));
  const std::string body{std::istreambuf_iterator<char>(stream), {}};
  if (checksum(body) != sum) fail(file, "is damaged or cut off");
  Content content;
  try {
    std::istringstream bytes(body);
    cereal::BinaryInputArchive reader(bytes);
    reader(content);
  } catch (const std::exception&) {
    fail(file, "is damaged");
  }
  return content;
}

}  // namespace

void writeCheckpoint(const fs::path& path, const Scene& scene, const Checkpoint& checkpoint) {
  Content content{sourcesOf(scene), scene.sea.seed,   scene.run.step,
                  checkpoint.time,  checkpoint.state, checkpoint.telemetry};
  std::ostringstream bytes;
  {
    cereal::BinaryOutputArchive writer(bytes);
    writer(content);
  }
  const std::string body = std::move(bytes).str();
  const std::uint32_t sum = checksum(body);
  AtomicFile file(path);
  file.stream() << heading;
  file.stream().write(reinterpret_cast<const char*>(&sum), sizeof(sum));
  file.stream() << body;
  file.commit();
}

Checkpoint readCheckpoint(const fs::path& file, const Scene& scene) {
  Content content = contentOf(file);
  const Sources now = sourcesOf(scene);
  for (std::size_t i = 0; i < std::max(now.size(), content.sources.size()); ++i) {
    const bool same = i < now.size() && i < content.sources.size() && now[i] == content.sources[i];
    if (same) continue;
    const std::string& name = i < now.size() ? now[i].first : content.sources[i].first;
    fail(file, name + " is not what it was when the checkpoint was written");
  }
  if (content.seed != scene.sea.seed) {
    fail(file, "was written with seed " + std::to_string(content.seed) + ", not " +
                   std::to_string(scene.sea.seed));
  }
  if (content.step != scene.run.step) fail(file, "was written with another step");
  return {content.time, std::move(content.state), std::move(content.telemetry)};
}

}  // namespace seaway::bridge
