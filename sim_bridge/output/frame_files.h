#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim_bridge/output/frame_json.h"

namespace seaway::bridge {

/// What is written of a frame beside its PNG; empty paths: not that.
struct FrameFiles {
  std::filesystem::path depth;     ///< OpenEXR, Z in m; where it is `radiance` too, in that file
  std::filesystem::path normals;   ///< OpenEXR, N.X, N.Y, N.Z
  std::filesystem::path radiance;  ///< OpenEXR, R, G, B
  std::filesystem::path labels;    ///< PNG, see labels.h
  std::filesystem::path json;      ///< see frame_json.h

  bool needLabels() const { return !labels.empty() || !json.empty(); }
};

/// Kinds of such files by the words of `seaway run --also`, with what their names end in.
struct FrameFileKind {
  std::string word;    ///< "depth", "labels" …
  std::string suffix;  ///< ".depth.exr"
  std::filesystem::path FrameFiles::*path;
};
const std::vector<FrameFileKind>& frameFileKinds();
/// The kind of a word. Throws InputError, with those there are, for any other.
const FrameFileKind& frameFileKind(const std::string& word);

/// Throws InputError unless all of them end as they should and can be written.
void requireWritable(const FrameFiles& files);

/// Asks a view for what the files hold.
void askFor(const FrameFiles& files, render::View& view);

/// Writes them; each appears whole or not at all.
void write(const FrameFiles& files, const DescribedFrame& described);

}  // namespace seaway::bridge
