#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <vector>

#include "render/frame.h"

namespace seaway::bridge {

/// Throws InputError unless `path` ends in .png (in any case) and can be written.
void requireWritablePicture(const std::filesystem::path& path);

/// render::writePng, leaving nothing behind when a signal ends the program.
void writePicture(const std::filesystem::path& path, const render::ColourImage& image);

/// Throws InputError unless `path` ends in .exr (in any case) and can be written.
void requireWritableExr(const std::filesystem::path& path);

/// Depth and normals as OpenEXR files that appear whole or not at all; the latter need a frame drawn
/// with normals.
void writeDepth(const std::filesystem::path& path, const render::Frame& frame);
void writeNormals(const std::filesystem::path& path, const render::Frame& frame);

/// Linear radiance likewise, with depth in the same file if asked; needs a frame drawn with radiance.
void writeRadiance(const std::filesystem::path& path, const render::Frame& frame, bool withDepth);
/// Numbers of pixels as a grey PNG (render::writeGreyPng), leaving nothing behind when a signal ends the
/// program.
void writeLabels(const std::filesystem::path& path, glm::ivec2 size,
                 const std::vector<std::uint16_t>& labels);

/// Throws std::runtime_error where the machine, the process's limits or its control group leave too
/// little memory to draw a picture of `size` pixels: 160 MB and 64 bytes a pixel (measured in
/// software: 130 MB and 45 to 52 bytes, 256² to 3072² pixels). To be asked before the work: a
/// system that lends more memory than it has kills instead of refusing.
void requireMemoryForPicture(glm::ivec2 size);

}  // namespace seaway::bridge
