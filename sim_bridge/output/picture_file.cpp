#include "sim_bridge/output/picture_file.h"

#include <spdlog/fmt/fmt.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "render/exr.h"
#include "render/png.h"
#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/output/unfinished_files.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

constexpr double bytesPerPixel = 64.0, bytesOfAnyPicture = 1.6e8;
constexpr double mebibyte = 1048576.0;
constexpr double unlimited = std::numeric_limits<double>::infinity();

std::optional<double> numberIn(const char* file, const std::string& label = "") {
  std::ifstream stream(file);
  std::string word;
  if (!label.empty()) {
    while (stream >> word && word != label) {
    }
  }
  double value = 0.0;
  if (stream >> value) return value;
  return std::nullopt;
}

double leftInAddressSpace() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
  const double used =
      numberIn("/proc/self/statm").value_or(0.0) * static_cast<double>(sysconf(_SC_PAGESIZE));
  return static_cast<double>(limit.rlim_cur) - used;
}

double leftInControlGroup() {
  const auto most = numberIn("/sys/fs/cgroup/memory.max");  // "max" is no number: no limit
  const auto used = numberIn("/sys/fs/cgroup/memory.current");
  return most && used ? *most - *used : unlimited;
}

double availableMemory() {
  const auto machine = numberIn("/proc/meminfo", "MemAvailable:");  // kB
  return std::min(
      {machine ? *machine * 1024.0 : unlimited, leftInAddressSpace(), leftInControlGroup()});
}

/// Throws unless `path` has the ending, in any case, and can be written.
void requireEnding(const std::filesystem::path& path, const std::string& wanted,
                   const std::string& what) {
  requireWritableFile(path);
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending != wanted) {
    throw InputError(what + ", the name must end in " + wanted);
  }
}

/// Writes beside `path`, then renames.
template <typename Write>
void writeWhole(const std::filesystem::path& path, Write write) {
  std::filesystem::path beside = path;
  beside += ".partial";
  const UnfinishedFile unfinished(beside);
  try {
    write(beside);
    std::filesystem::rename(beside, path);
  } catch (const std::exception& error) {
    std::error_code ignored;
    std::filesystem::remove(beside, ignored);
    throw std::runtime_error(path.string() + ": cannot be written: " + error.what());
  }
}

}  // namespace

void requireWritablePicture(const std::filesystem::path& path) {
  requireEnding(path, ".png",
                "--out: '" + path.string() + "' is not allowed; pictures are PNG");
}

void requireWritableExr(const std::filesystem::path& path) {
  requireEnding(path, ".exr",
                "'" + path.string() + "' is not allowed; depth, normals and radiance are OpenEXR");
}

void writeDepth(const std::filesystem::path& path, const render::Frame& frame) {
  writeWhole(path, [&](const std::filesystem::path& beside) {
    render::writeDepthExr(beside, frame.depth.size, frame.depth.metres);
  });
}

void writeNormals(const std::filesystem::path& path, const render::Frame& frame) {
  writeWhole(path, [&](const std::filesystem::path& beside) {
    render::writeNormalsExr(beside, frame.depth.size, frame.normals);
  });
}

void writeRadiance(const std::filesystem::path& path, const render::Frame& frame, bool withDepth) {
  writeWhole(path, [&](const std::filesystem::path& beside) {
    render::writeRadianceExr(beside, frame.depth.size, frame.radiance,
                             withDepth ? &frame.depth.metres : nullptr);
  });
}

void writeLabels(const std::filesystem::path& path, glm::ivec2 size,
                 const std::vector<std::uint16_t>& labels) {
  std::filesystem::path beside = path;
  beside += render::partialPngSuffix;
  const UnfinishedFile unfinished(beside);
  render::writeGreyPng(path, size, labels);
}

void writePicture(const std::filesystem::path& path, const render::ColourImage& image) {
  std::filesystem::path beside = path;
  beside += render::partialPngSuffix;
  const UnfinishedFile unfinished(beside);
  render::writePng(path, image);
}

void requireMemoryForPicture(glm::ivec2 size) {
  const double wanted = bytesOfAnyPicture + bytesPerPixel * size.x * size.y;
  const double available = availableMemory();
  if (wanted <= available) return;
  throw std::runtime_error(
      fmt::format("not enough memory: a picture of {}x{} pixels takes up to {:.0f} MiB to draw, "
                  "{:.0f} MiB are free",
                  size.x, size.y, wanted / mebibyte, std::max(0.0, available) / mebibyte));
}

}  // namespace seaway::bridge
