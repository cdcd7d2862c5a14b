#include "surface/disturbance/vessel_wake.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "surface/constants.h"
#include "surface/dispersion.h"
#include "surface/state_archive.h"

namespace seaway {
namespace {

/// Rounding of times that are meant to lie on the grid, in steps.
constexpr double onGrid = 1e-6;

/// The window's centre lies this part of its size behind a vessel under way: waves are left astern,
/// and the vessel keeps 0.3 of the size from the seam.
constexpr double lag = 0.2;

/// The border works at this interval or more often, s.
constexpr double borderInterval = 0.8;

/// Waves made where the vessel was this far away, in sizes, have left the window: they are at most
/// half way to it, for their energy travels at half the vessel's speed or less.
constexpr double leftBehind = 1.5;

/// Absorption at the seam, 1/s: enough for the time that waves take through the border by
/// themselves (their speed grows with √size) and as it passes over them with the vessel.
double absorptionRate(double size, double speed) {
  return std::min(5.0, std::max(0.7 * std::sqrt(256.0 / size), 32.0 * speed / size));
}

/// The power of two of cells, 64 to `most`, that covers a length.
int cellsFor(double length, double cell, int most) {
  int cells = 64;
  while (cells < most && cells * cell < length) cells *= 2;
  return cells;
}

glm::dvec2 wantedAstern(glm::dvec2 velocity, double size) {
  // In full from 2 m/s up: a vessel at rest lies in the middle.
  return -lag * size * velocity / std::max(2.0, glm::length(velocity));
}

}  // namespace

std::vector<WakeLevel> standardCascade(double hullLength, double depth) {
  return cascadeOf(hullLength, depth, 0.0, 0.0);
}

std::vector<WakeLevel> cascadeOf(double hullLength, double depth, double cell, double window) {
  double scale = 1.0;
  while (hullLength > 64.0 * scale) scale *= 2.0;
  if (cell > 0.0) scale = 2.0 * cell;
  WakeLevel fine;
  fine.step = 0.1 * std::sqrt(scale);
  fine.window.cellSize = 0.5 * scale;
  fine.window.cells = 512;
  fine.window.depth = depth;
  fine.window.band = {2.0 * scale, 4.0 * scale};
  const double wanted = window > 0.0 ? window : 1024.0 * scale;
  if (wanted <= fine.window.size()) {
    fine.window.cells = cellsFor(wanted, fine.window.cellSize, fine.window.cells);
    fine.window.modes = fine.window.cells / 2;
    return {fine};
  }
  fine.window.band.longAll = 16.0 * scale;
  fine.window.band.longNone = 32.0 * scale;
  WakeLevel coarse = fine;
  coarse.step = 4.0 * fine.step;
  coarse.window.cellSize = 4.0 * scale;
  coarse.window.cells = cellsFor(wanted, coarse.window.cellSize, 1024);
  coarse.window.modes = coarse.window.cells / 2;
  coarse.window.band = {16.0 * scale, 32.0 * scale};
  return {fine, coarse};
}

double memoryOf(const WakeLevel& level) {
  const double slowest = groupSpeed(2.0 * pi / level.window.band.shortAll, level.window.depth);
  return 0.8 * level.window.size() / slowest;
}

double reachOf(const std::vector<WakeLevel>& cascade) { return 0.7 * cascade.back().window.size(); }

LevelWake::LevelWake(const WakeLevel& level, std::shared_ptr<const WakeTables> tables,
                     std::shared_ptr<const FootprintTable> hull, bool withPotential)
    : level_(level),
      window_(std::move(tables), std::move(hull)),
      pool_(level.window.cells, withPotential) {}

bool LevelWake::advance(const PoseLog& log, double time) {
  const double known = std::min(time, log.latest());
  const auto target = static_cast<long long>(std::floor(known / level_.step + onGrid)) + 1;
  if (running_ && steps_ == target) return false;
  if (!running_ || steps_ > target || target - steps_ > memoryOf(level_) / level_.step) {
    start(log, known);
  }
  while (steps_ < target) {
    // Only the last two steps are looked at.
    if (steps_ == target - 1 && !after_) draw();
    step(log);
    if (steps_ >= target - 1) draw();
  }
  return true;
}

void LevelWake::start(const PoseLog& log, double time) {
  const double from = std::max(
      {log.lastJump(time), log.timeAway(time, leftBehind * size()), time - memoryOf(level_)});
  steps_ = static_cast<long long>(std::ceil(from / level_.step - onGrid));
  // A log that begins within the step: the vessel lay at its first place before.
  steps_ = std::min(steps_, static_cast<long long>(std::floor(time / level_.step + onGrid)));
  before_ = after_ = nullptr;
  settle(log);
  running_ = true;
}

void LevelWake::settle(const PoseLog& log) {
  const HullPlace place = log.placeOrFirst(time(), time());
  const HullPlace next = log.placeOrFirst(time() + level_.step, time());
  window_.settle(place);
  place_ = place;
  velocity_ = (next.position - place.position) / level_.step;
  astern_ = wantedAstern(velocity_, size());
  centre_ = place.position + astern_;
}

void LevelWake::step(const PoseLog& log) {
  if (log.jumpedWithin(time() - level_.step, time())) settle(log);
  const HullPlace from = log.placeOrFirst(time(), time());
  const HullPlace to = log.placeOrFirst(time() + level_.step, time());
  window_.step(level_.step, from, to);
  place_ = to;
  velocity_ = (to.position - from.position) / level_.step;
  ++steps_;
  follow();
}

void LevelWake::follow() {
  const double speed = glm::length(velocity_);
  // The seam moves gently, for it takes waves away as it passes.
  const glm::dvec2 change = wantedAstern(velocity_, size()) - astern_;
  const double most = (0.5 * speed + 1.0) * level_.step, wanted = glm::length(change);
  astern_ += wanted > most ? change * (most / wanted) : change;
  centre_ = place_.position + astern_;

  const double rate = absorptionRate(size(), speed) * level_.window.absorption;
  const double interval = rate > 1.0 ? borderInterval / rate : borderInterval;
  const auto every = std::max(1LL, static_cast<long long>(interval / level_.step + onGrid));
  if (steps_ % every != 0) return;
  const double seconds = static_cast<double>(every) * level_.step;
  window_.absorb(centre_, seconds * absorptionRate(size(), speed));
  meanWaveNumber_ = window_.meanWaveNumber();
}

void LevelWake::draw() {
  const std::shared_ptr<WakeGrid> grid = pool_.take();
  window_.drawFilled(place_, velocity_, *grid);
  before_ = std::exchange(after_, grid);
}

WakeSheet LevelWake::sheet() const {
  return {before_,
          after_,
          static_cast<double>(steps_ - 1) * level_.step,
          time(),
          level_.window.cellSize,
          centre_};
}

double LevelWake::waveEnergy(const PoseLog& log) {
  return window_.waveEnergy(log.placeOrFirst(time(), time()));
}

std::size_t LevelWake::memoryBytes() const {
  // The grid before the last two is still with readers, or spare.
  return window_.memoryBytes() + (after_ ? 3 * after_->memoryBytes() : 0);
}

namespace {

template <class Archive>
void archiveGrid(Archive& archive, std::shared_ptr<const WakeGrid>& grid, int cells) {
  bool there = grid != nullptr;
  archivePlain(archive, there);
  if (!there) {
    grid = nullptr;
    return;
  }
  bool withPotential = grid && !grid->potential.empty();
  archivePlain(archive, withPotential);
  auto held = std::make_shared<WakeGrid>(cells, withPotential);
  const std::size_t size = held->surface.size(), depths = held->potential.size();
  if constexpr (!isReader<Archive>) *held = *grid;
  archiveRow(archive, held->surface);
  archiveRow(archive, held->potential);
  archivePlain(archive, held->largestHeight);
  archivePlain(archive, held->largestRate);
  if (held->surface.size() != size || held->potential.size() != depths) {
    throw InputError("a checkpoint is damaged: a wake's surface has another size");
  }
  if constexpr (isReader<Archive>) grid = held;
}

}  // namespace

template <class Archive>
void LevelWake::archive(Archive& archive) {
  window_.archive(archive);
  archivePlain(archive, running_);
  archivePlain(archive, steps_);
  archivePlain(archive, astern_);
  archivePlain(archive, centre_);
  archivePlain(archive, place_);
  archivePlain(archive, velocity_);
  archivePlain(archive, meanWaveNumber_);
  archiveGrid(archive, before_, level_.window.cells);
  archiveGrid(archive, after_, level_.window.cells);
}

template void LevelWake::archive(StateWriter&);
template void LevelWake::archive(StateReader&);

}  // namespace seaway
