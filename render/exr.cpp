#include "render/exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>

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
