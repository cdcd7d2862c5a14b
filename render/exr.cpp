#include "render/exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <half.h>

#include <algorithm>
#include <stdexcept>

namespace seaway::render {
namespace {

/// `values` of the first of `names` are the first floats, those of the next one float on.
void writeExr(const std::filesystem::path& path, glm::ivec2 size,
              const std::vector<const char*>& names, const float* values) {
  Imf::Header header(size.x, size.y);
  Imf::FrameBuffer pixels;
  const std::size_t perPixel = names.size() * sizeof(float);
  for (std::size_t i = 0; i < names.size(); ++i) {
    header.channels().insert(names[i], Imf::Channel(Imf::FLOAT));
    // The library reads only, but takes pointers to what may change.
    char* first = const_cast<char*>(reinterpret_cast<const char*>(values + i));
    pixels.insert(names[i], Imf::Slice(Imf::FLOAT, first, perPixel, perPixel * size.x));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(pixels);
  file.writePixels(size.y);
}

}  // namespace

void writeDepthExr(const std::filesystem::path& path, glm::ivec2 size,
                   const std::vector<float>& metres) {
  writeExr(path, size, {"Z"}, metres.data());
}

void writeNormalsExr(const std::filesystem::path& path, glm::ivec2 size,
                     const std::vector<glm::vec3>& normals) {
  writeExr(path, size, {"N.X", "N.Y", "N.Z"}, &normals.front().x);
}

void writeRadianceExr(const std::filesystem::path& path, glm::ivec2 size,
                      const std::vector<glm::vec3>& radiance, const std::vector<float>* metres) {
  std::vector<half> halves;
  halves.reserve(3 * radiance.size());
  for (const glm::vec3& pixel : radiance) {
    for (int c = 0; c < 3; ++c) halves.emplace_back(std::min(pixel[c], float(HALF_MAX)));
  }
  Imf::Header header(size.x, size.y);
  Imf::FrameBuffer pixels;
  const std::size_t perPixel = 3 * sizeof(half);
  const char* names[] = {"R", "G", "B"};
  for (int c = 0; c < 3; ++c) {
    header.channels().insert(names[c], Imf::Channel(Imf::HALF));
    pixels.insert(names[c], Imf::Slice(Imf::HALF, reinterpret_cast<char*>(halves.data() + c),
                                       perPixel, perPixel * size.x));
  }
  if (metres) {
    header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    char* first = const_cast<char*>(reinterpret_cast<const char*>(metres->data()));
    pixels.insert("Z", Imf::Slice(Imf::FLOAT, first, sizeof(float), sizeof(float) * size.x));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(pixels);
  file.writePixels(size.y);
}

std::vector<glm::vec3> readRadianceExr(const std::filesystem::path& path, glm::ivec2& size) {
  Imf::InputFile file(path.c_str());
  const Imath::Box2i window = file.header().dataWindow();
  size = {window.max.x - window.min.x + 1, window.max.y - window.min.y + 1};
  std::vector<glm::vec3> radiance(static_cast<std::size_t>(size.x) * size.y);
  Imf::FrameBuffer pixels;
  const char* names[] = {"R", "G", "B"};
  for (int c = 0; c < 3; ++c) {
    if (!file.header().channels().findChannel(names[c])) {
      throw std::runtime_error(path.string() + ": has no channel " + names[c]);
    }
    pixels.insert(names[c], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&radiance.front()[c]),
                                       sizeof(glm::vec3), sizeof(glm::vec3) * size.x));
  }
  file.setFrameBuffer(pixels);
  file.readPixels(window.min.y, window.max.y);
  return radiance;
}

std::vector<float> readDepthExr(const std::filesystem::path& path, glm::ivec2& size) {
  Imf::InputFile file(path.c_str());
  if (!file.header().channels().findChannel("Z")) {
    throw std::runtime_error(path.string() + ": has no channel Z");
  }
  const Imath::Box2i window = file.header().dataWindow();
  size = {window.max.x - window.min.x + 1, window.max.y - window.min.y + 1};
  std::vector<float> metres(static_cast<std::size_t>(size.x) * size.y);
  Imf::FrameBuffer pixels;
  pixels.insert("Z", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(metres.data()), sizeof(float),
                                sizeof(float) * size.x));
  file.setFrameBuffer(pixels);
  file.readPixels(window.min.y, window.max.y);
  return metres;
}

}  // namespace seaway::render
