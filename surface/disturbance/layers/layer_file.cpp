#include "surface/disturbance/layers/layer_file.h"

#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include <algorithm>
#include <cmath>

#include "surface/input_error.h"

namespace seaway {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
  throw InputError(file.string(), 0, what);
}

/// Runs what calls OpenVDB; its faults name the file.
template <class Action>
auto guarded(const fs::path& file, Action action) {
  static const bool ready = (openvdb::initialize(), true);
  static_cast<void>(ready);
  try {
    return action();
  } catch (const InputError&) {
    throw;
  } catch (const openvdb::Exception& fault) {
    fail(file, std::string("is no readable OpenVDB file: ") + fault.what());
  } catch (const std::bad_alloc&) {
    fail(file, "is damaged: it asks for more memory than there is");
  } catch (const std::exception& fault) {
    fail(file, std::string("is no readable OpenVDB file: ") + fault.what());
  }
}

openvdb::GridPtrVec gridsOf(const fs::path& file, bool metadataOnly) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) fail(file, "no such file");
  openvdb::io::File stream(file.string());
  stream.open(false);  // no delayed loading: faults show here
  const openvdb::GridPtrVecPtr grids =
      metadataOnly ? stream.readAllGridMetadata() : stream.getGrids();
  stream.close();
  return *grids;
}

openvdb::FloatGrid::Ptr emptyGrid(const std::string& name, double cellSize, glm::dvec2 origin) {
  auto grid = openvdb::FloatGrid::create(0.0f);
  auto transform = openvdb::math::Transform::createLinearTransform(cellSize);
  transform->postTranslate({origin.x + 0.5 * cellSize, origin.y + 0.5 * cellSize, 0.0});
  grid->setTransform(transform);
  grid->setName(name);
  grid->setGridClass(openvdb::GRID_FOG_VOLUME);
  grid->setCreator("Seaway");
  return grid;
}

std::string namesOf(const openvdb::GridPtrVec& grids) {
  std::string names;
  for (const auto& grid : grids) {
    names += (names.empty() ? "'" : ", '") + grid->getName() + "'";
  }
  return names.empty() ? "none" : names;
}

openvdb::GridBase::Ptr pick(const fs::path& file, const openvdb::GridPtrVec& grids,
                            const std::string& name) {
  if (grids.empty()) fail(file, "holds no grid");
  if (name.empty() && grids.size() == 1) return grids.front();
  for (const auto& grid : grids) {
    if (grid->getName() == name) return grid;
  }
  if (name.empty()) {
    for (const auto& grid : grids) {
      if (grid->getName() == "density" || grid->getName() == "cover") return grid;
    }
    fail(file, "holds several grids; name one of: " + namesOf(grids));
  }
  fail(file, "holds no grid '" + name + "'; there is " + namesOf(grids));
}

/// Where a grid's voxels lie: a scale and a shift along each axis.
struct Placement {
  openvdb::Vec3d voxel, origin;  // m; origin: centre of voxel (0, 0, 0)

  double column(double x) const { return (x - origin.x()) / voxel.x(); }
  double row(double y) const { return (y - origin.y()) / voxel.y(); }
  glm::dvec2 at(double i, double j) const {
    return {origin.x() + i * voxel.x(), origin.y() + j * voxel.y()};
  }
};

Placement placementOf(const fs::path& file, const openvdb::GridBase& grid) {
  const openvdb::math::Transform& transform = grid.transform();
  const openvdb::Vec3d origin = transform.indexToWorld(openvdb::Vec3d(0.0));
  Placement placement{openvdb::Vec3d(0.0), origin};
  bool straight = transform.isLinear();
  for (int axis = 0; straight && axis < 3; ++axis) {
    openvdb::Vec3d unit(0.0);
    unit[axis] = 1.0;
    const openvdb::Vec3d step = transform.indexToWorld(unit) - origin;
    placement.voxel[axis] = step[axis];
    for (int other = 0; other < 3; ++other) {
      if (other != axis)
        straight = straight && std::abs(step[other]) <= 1e-9 * std::abs(step[axis]);
    }
  }
  const bool sized = placement.voxel.x() > 0.0 && placement.voxel.y() > 0.0;
  if (!straight || !sized || !std::isfinite(origin.x() + origin.y())) {
    fail(file, "grid '" + grid.getName() +
                   "' is turned or warped; its voxels must lie along east and north");
  }
  return placement;
}

void requireCover(const fs::path& file, const std::string& name, double value) {
  if (value >= 0.0 && value <= 1.0) return;
  fail(file, "grid '" + name + "' holds the value " + std::to_string(value) +
                 "; cover must be in [0, 1]");
}

void requirePainted(const fs::path& file, const std::string& name, Painted painted) {
  const std::string grid = "grid '" + name + "' ";
  switch (painted) {
    case Painted::done:
      return;
    case Painted::notFinite:
      fail(file, grid + "reaches farther from the anchor than a layer does");
    case Painted::tooEarly:
      fail(file, grid + "comes before what the layer remembers");
    case Painted::tooLarge:
    case Painted::full:
      fail(file, grid + "covers more cells than a layer may hold; use larger cells");
  }
}

/// Paints what a box of voxels holds; `largestAt(i, j)` of those above one another.
template <class LargestAt>
void paintBox(const fs::path& file, const std::string& name, const Placement& place,
              const openvdb::CoordBBox& box, double t, LargestAt largestAt, SurfaceLayer& layer) {
  const openvdb::Coord low = box.min(), high = box.max();
  const glm::dvec2 lower = place.at(low.x() - 0.5, low.y() - 0.5);
  const glm::dvec2 upper = place.at(high.x() + 0.5, high.y() + 0.5);
  requirePainted(file, name, layer.paint(lower, upper, t, [&](glm::dvec2 centre) {
    const auto i = static_cast<int>(std::floor(place.column(centre.x) + 0.5));
    const auto j = static_cast<int>(std::floor(place.row(centre.y) + 0.5));
    return largestAt(std::clamp(i, low.x(), high.x()), std::clamp(j, low.y(), high.y()));
  }));
}

template <class Grid>
bool paintGrid(const fs::path& file, const openvdb::GridBase& base, double t, SurfaceLayer& layer) {
  if (!base.isType<Grid>()) return false;
  const Grid& grid = static_cast<const Grid&>(base);
  const std::string name = grid.getName();
  const Placement place = placementOf(file, grid);
  for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf) {
    for (auto value = leaf->cbeginValueOn(); value; ++value) requireCover(file, name, *value);
    const openvdb::CoordBBox box = leaf->getNodeBoundingBox();
    const auto largestAt = [&](int i, int j) {
      float largest = 0.0f;
      for (int k = box.min().z(); k <= box.max().z(); ++k) {
        const openvdb::Coord at(i, j, k);
        if (leaf->isValueOn(at))
          largest = std::max(largest, static_cast<float>(leaf->getValue(at)));
      }
      return largest;
    };
    paintBox(file, name, place, box, t, largestAt, layer);
  }
  auto tile = grid.cbeginValueOn();
  tile.setMaxDepth(decltype(tile)::LEAF_DEPTH - 1);
  for (; tile; ++tile) {
    requireCover(file, name, *tile);
    openvdb::CoordBBox box;
    tile.getBoundingBox(box);
    const auto value = static_cast<float>(*tile);
    paintBox(
        file, name, place, box, t, [=](int, int) { return value; }, layer);
  }
  return true;
}

}  // namespace

void writeLayers(const fs::path& file, const std::vector<LayerGrid>& layers, double t,
                 const std::map<std::string, std::string>& notes) {
  guarded(file, [&] {
    openvdb::GridPtrVec grids;
    for (const LayerGrid& each : layers) {
      const LayerSettings& settings = each.layer->settings();
      const glm::dvec2 origin = settings.drift * t;
      auto cover = emptyGrid(each.name, settings.cellSize, origin);
      auto age = emptyGrid(each.name + "_age", settings.cellSize, origin);
      auto coverCells = cover->getAccessor(), ageCells = age->getAccessor();
      each.layer->visit(t, [&](const SurfaceLayer::Cell& cell) {
        const openvdb::Coord at(static_cast<int>(cell.i), static_cast<int>(cell.j), 0);
        coverCells.setValue(at, cell.cover);
        ageCells.setValue(at, cell.age);
      });
      grids.insert(grids.end(), {cover, age});
    }
    openvdb::MetaMap metadata;
    metadata.insertMeta("time_s", openvdb::DoubleMetadata(t));
    for (const auto& [key, value] : notes) {
      metadata.insertMeta(key, openvdb::StringMetadata(value));
    }
    openvdb::io::File stream(file.string());
    stream.write(grids, metadata);
    stream.close();
  });
}

std::vector<GridSummary> describeGrids(const fs::path& file) {
  return guarded(file, [&] {
    std::vector<GridSummary> summaries;
    for (const auto& grid : gridsOf(file, false)) {
      GridSummary summary{
          grid->getName(), grid->valueType(), grid->activeVoxelCount(), {}, {}, 0.0};
      const openvdb::CoordBBox box = grid->evalActiveVoxelBoundingBox();
      if (summary.voxels > 0) {
        const auto& transform = grid->transform();
        const auto low = transform.indexToWorld(box.min().asVec3d() - 0.5);
        const auto high = transform.indexToWorld(box.max().asVec3d() + 0.5);
        summary.lower = {low.x(), low.y()};
        summary.upper = {high.x(), high.y()};
      }
      summary.voxelSize = grid->voxelSize().x();
      summaries.push_back(summary);
    }
    return summaries;
  });
}

void readLayer(const fs::path& file, const std::string& name, double t, SurfaceLayer& layer) {
  guarded(file, [&] {
    const openvdb::GridBase::Ptr grid = pick(file, gridsOf(file, false), name);
    if (grid->getGridClass() == openvdb::GRID_LEVEL_SET) {
      fail(file,
           "grid '" + grid->getName() + "' is a level set (distances); cover is a fog volume");
    }
    const bool painted = paintGrid<openvdb::FloatGrid>(file, *grid, t, layer) ||
                         paintGrid<openvdb::DoubleGrid>(file, *grid, t, layer);
    if (!painted) {
      fail(file, "grid '" + grid->getName() + "' holds values of type " + grid->valueType() +
                     "; must be float or double");
    }
  });
}

}  // namespace seaway
