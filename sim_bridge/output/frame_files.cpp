#include "sim_bridge/output/frame_files.h"

#include <nlohmann/json.hpp>

#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/output/labels.h"
#include "sim_bridge/output/picture_file.h"
#include "surface/input_error.h"

namespace seaway::bridge {

const std::vector<FrameFileKind>& frameFileKinds() {
  static const std::vector<FrameFileKind> kinds{
      {"depth", ".depth.exr", &FrameFiles::depth},
      {"normals", ".normals.exr", &FrameFiles::normals},
      {"radiance", ".radiance.exr", &FrameFiles::radiance},
      {"labels", ".labels.png", &FrameFiles::labels},
      {"json", ".json", &FrameFiles::json}};
  return kinds;
}

const FrameFileKind& frameFileKind(const std::string& word) {
  std::string all;
  for (const FrameFileKind& kind : frameFileKinds()) {
    if (kind.word == word) return kind;
    all += (all.empty() ? "" : ", ") + kind.word;
  }
  throw InputError("--also: '" + word + "' is not allowed; must be of: " + all);
}

void requireWritable(const FrameFiles& files) {
  for (const std::filesystem::path* exr : {&files.depth, &files.normals, &files.radiance}) {
    if (!exr->empty()) requireWritableExr(*exr);
  }
  if (!files.normals.empty() && (files.normals == files.depth || files.normals == files.radiance)) {
    throw InputError(files.normals.string() + ": normals need a file of their own");
  }
  if (!files.labels.empty()) requireWritablePicture(files.labels);
  if (!files.json.empty()) requireWritableFile(files.json);
}

void askFor(const FrameFiles& files, render::View& view) {
  view.wantsNormals = !files.normals.empty();
  view.wantsRadiance = !files.radiance.empty();
  view.wantsLabels = files.needLabels();
}

void write(const FrameFiles& files, const DescribedFrame& described) {
  const render::Frame& frame = described.frame;
  const bool inOne = !files.depth.empty() && files.depth == files.radiance;
  if (!files.depth.empty() && !inOne) writeDepth(files.depth, frame);
  if (!files.normals.empty()) writeNormals(files.normals, frame);
  if (!files.radiance.empty()) writeRadiance(files.radiance, frame, inOne);
  if (!files.labels.empty()) writeLabels(files.labels, frame.colour.size, labelsOf(frame));
  if (files.json.empty()) return;
  AtomicFile file(files.json);
  file.stream() << frameJson(described).dump(2) << '\n';
  file.commit();
}

}  // namespace seaway::bridge
