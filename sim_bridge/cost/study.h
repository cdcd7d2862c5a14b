#pragma once

#include <functional>
#include <string>
#include <vector>

/// The cost report: for every dial, how wrong the answers are and what they cost.
namespace seaway::bridge {

struct Scene;
struct Sea;

/// One setting of a dial.
struct CostPoint {
  std::string setting;  ///< such as "octaves 4"
  double error = 0.0;   ///< against the study's truth, in Study::unitError
  double cost = 0.0;    ///< median over repetitions, in Study::unitCost
  double spread = 0.0;  ///< half the distance between the cost's quartiles
  double dial = 0.0;    ///< the setting as a number, such as vertices a side; 0: it has none
};

/// Error against cost along one dial, all points measured in one process.
struct Study {
  std::string name;
  std::string summary;  ///< what was measured, against which truth
  std::string unitError;
  std::string unitCost;
  std::vector<CostPoint> points;
  std::string chosen = {};  ///< the setting that the scene has; empty: it has none of them
};

struct StudyOptions {
  bool quick = false;              ///< fewer points, pixels and repetitions
  std::string backend = "osmesa";  ///< of pictures; see makeHeadlessContext
};

/// A median of wall times and half their interquartile range.
struct Timing {
  double median = 0.0;
  double spread = 0.0;
};

/// What costs were measured on: processor, threads, graphics.
std::string machineLine();

/// Runs `work` once to warm up and `repetitions` ≥ 3 times under the clock; seconds a run.
Timing timeRepeated(const std::function<void()>& work, int repetitions);

/// Several works by turns, so that what else the machine does strikes all alike: each once to warm
/// up, then all of them `repetitions` ≥ 3 times over.
std::vector<Timing> timeByTurns(const std::vector<std::function<void()>>& works, int repetitions);

/// The points that no other beats in both error and cost, by rising cost. Errors that are no
/// numbers are in none.
std::vector<CostPoint> paretoFront(std::vector<CostPoint> points);

/// Height error (m rms) against ns a point, by number of octaves kept. Truth: all octaves. `scene`
/// has `sea`: its tolerance is the setting that is marked.
Study studyQueryOctaves(const Scene& scene, const Sea& sea, const StudyOptions& options);

/// The same heights by the ways to ask for them: in double precision, by each instruction set that
/// the machine has, singly, in batches, by many threads; largest difference from double precision
/// (m) against ns a point. Not while other threads sample.
Study studyQueryWays(const Sea& sea, const StudyOptions& options);

/// Two studies of other ways to make the scene's sea beside the wave field, ns a point: residual of
/// the spectrum each stands for, and height error (m rms) against its own exact field.
std::vector<Study> studyFieldModels(const Sea& sea, const StudyOptions& options);

/// Residual of fits of group octaves to a JONSWAP spectrum against ms a fit, by number of octaves.
Study studyFitOctaves(const StudyOptions& options);

/// Four studies of loads on a 12 m hull about the scene's sea: rms error of its buoyancy in % of
/// its weight against us an evaluation, by columns, by triangles without and with the waves' own
/// pressure, and by cut-off of short waves.
std::vector<Study> studyHullLoads(const Sea& sea, const StudyOptions& options);

/// Three studies of the layers on the water, by the side of their cells: what a launch's trail
/// costs in MB, in ms to paint and in ns to sample, against finer cells.
std::vector<Study> studyLayers(const StudyOptions& options);

/// Six studies of the scene's first camera, ms a frame. By grid size: place of the surface in the
/// picture (rms pixels) against a ray-cast, axial depth of water pixels (median m) against a
/// ray-march, and height of the field where pixels lie (rms m); by technique and the size of its
/// table, place and depth; by number of octaves drawn, height. None where the camera sees no water.
std::vector<Study> studyImages(const Scene& scene, const Sea& sea, const StudyOptions& options);

/// Two studies of the colours of the scene's first camera, rms of 255 against ms a frame: by the
/// picture's size and samples a pixel, and by effects left out.
std::vector<Study> studyPictures(const Scene& scene, const Sea& sea, const StudyOptions& options);

/// Share of a projected grid's vertices that lie outside the picture (median over ordinary views)
/// against ms to place 256x512 of them, by where its rows end.
Study studyVertexEfficiency(const Sea& sea, const StudyOptions& options);

/// Two studies of the scene's first camera, by grid size, ms a frame: how much the drawn surface of
/// a frozen sea changes a frame (px rms) as the camera moves ahead, and as it turns.
std::vector<Study> studySwimming(const Scene& scene, const Sea& sea, const StudyOptions& options);

/// By the tolerance of a terrain's levels of detail: height of drawn ground off the map's (px rms)
/// against ms to select and raster it, over all the scene's cameras. None without terrain.
std::vector<Study> studyTerrain(const Scene& scene, const Sea& sea, const StudyOptions& options);

/// By the size of shadow maps: pixels whose sunlight is wrong, in % of those in shadow, against
/// rays to the sun, and ms to draw the maps; of the first camera that sees shadows. None where none
/// does.
std::vector<Study> studyShadows(const Scene& scene, const Sea& sea, const StudyOptions& options);

/// By samples a pixel: radiance under water, rms in % of its mean, against 36 samples, and ms a
/// frame; of the first camera that sees water from inside. None where none does.
std::vector<Study> studyUnderWater(const Scene& scene, const Sea& sea, const StudyOptions& options);

/// Three studies of the wake of the scene's first vessel under way, by cell size, step and window:
/// rms error in % of the wake's height around the vessel against us of work in 0.1 s. None where no
/// vessel is under way.
std::vector<Study> studyWakes(const Scene& scene, const StudyOptions& options);

}  // namespace seaway::bridge
