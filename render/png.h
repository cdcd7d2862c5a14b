#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "render/frame.h"

namespace seaway::render {

/// What a PNG is called beside its name while it is written.
inline constexpr const char* partialPngSuffix = ".partial";

/// Writes an 8-bit sRGB PNG beside `path` and renames it, so that no partial file is ever seen.
/// Throws InputError where the file cannot be written.
void writePng(const std::filesystem::path& path, const ColourImage& image);

/// The same as a file's bytes. Throws InputError for a picture that is empty or of another size
/// than its pixels.
std::string pngBytes(const ColourImage& image);

/// Writes numbers as a grey PNG, row by row from the top left, the same way: 16 bits a pixel, or 8 where
/// none is above 255. Throws InputError where the file cannot be written.
void writeGreyPng(const std::filesystem::path& path, glm::ivec2 size,
                  const std::vector<std::uint16_t>& values);

/// Reads such a file's numbers. Throws InputError where it cannot.
std::vector<std::uint16_t> readGreyPng(const std::filesystem::path& path, glm::ivec2& size);

/// Reads an 8-bit RGB PNG. Throws InputError where it cannot.
ColourImage readPng(const std::filesystem::path& path);

}  // namespace seaway::render
