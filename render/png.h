#pragma once

#include <filesystem>
#include <string>

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

/// Reads an 8-bit RGB PNG. Throws InputError where it cannot.
ColourImage readPng(const std::filesystem::path& path);

}  // namespace seaway::render
