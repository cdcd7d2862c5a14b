#include "surface/hull/hull_model.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "surface/hull/mesh_calibration.h"
#include "surface/hull/mesh_check.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

void requireSane(const HullSettings& s) {
  if (!(s.mass > 0.0) || !std::isfinite(s.mass)) {
    throw InputError("a hull's mass of " + std::to_string(s.mass) + " kg must be above 0");
  }
  const HullCoefficients& c = s.coefficients;
  for (const double value :
       {c.formDrag, c.skinFriction.value_or(0.0), c.slamming, c.windDrag, c.heaveDamping,
        c.rollDamping, c.pitchDamping, c.addedMass[0], c.addedMass[1], c.addedMass[2],
        c.addedMass[3], c.addedMass[4], c.addedMass[5], s.gyradii.x, s.gyradii.y, s.gyradii.z,
        s.shortestWavelength.value_or(0.0)}) {
    if (!(value >= 0.0) || !std::isfinite(value)) {
      throw InputError("a hull's coefficient of " + std::to_string(value) + " must be >= 0");
    }
  }
  if (!std::isfinite(s.centreOfGravity.x + s.centreOfGravity.y + s.centreOfGravity.z)) {
    throw InputError("a hull's centre of gravity must be finite");
  }
  if (s.columns.x < 2 || s.columns.y < 2 || s.columns.x > 1000 || s.columns.y > 1000) {
    throw InputError("a hull needs 2 to 1000 columns along and across");
  }
}

TriangleMesh checked(TriangleMesh mesh) {
  const MeshReport report = checkMesh(mesh);
  std::string all;
  for (const std::string& fault : faultsOf(report)) all += (all.empty() ? "" : "; ") + fault;
  if (!all.empty()) throw InputError("the hull's mesh " + all);
  return report.facesOutward ? mesh : turnedInsideOut(mesh);
}

/// Heights at which the upright through a place crosses the mesh.
std::vector<double> crossings(const TriangleMesh& mesh, glm::dvec2 place) {
  std::vector<double> heights;
  for (const auto& t : mesh.triangles) {
    const glm::dvec3 &a = mesh.vertices[t.x], &b = mesh.vertices[t.y], &c = mesh.vertices[t.z];
    const auto side = [&](const glm::dvec3& from, const glm::dvec3& to) {
      return (to.x - from.x) * (place.y - from.y) - (to.y - from.y) * (place.x - from.x);
    };
    const double u = side(b, c), v = side(c, a), w = side(a, b), sum = u + v + w;
    // Half-open, so that an edge counts for one of its triangles.
    const bool within = (u >= 0.0) == (v >= 0.0) && (v >= 0.0) == (w >= 0.0);
    if (within && sum != 0.0) heights.push_back((u * a.z + v * b.z + w * c.z) / sum);
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

double safeRoot(double value) { return value > 0.0 ? std::sqrt(value) : 0.0; }

}  // namespace

HullModel::HullModel(TriangleMesh mesh, const HullSettings& settings) : settings_(settings) {
  requireSane(settings);
  mesh_ = checked(std::move(mesh));
  if (settings.knownWaterplane) {
    if (!settings.knownVolume) {
      throw InputError("a known waterplane needs a known displacement beside it");
    }
    mesh_ = calibrated(mesh_, *settings.knownVolume, *settings.knownWaterplane);
  }
  bounds_ = boundsOf(mesh_);
  const glm::dvec3 size = bounds_.size();
  const auto given = [](double value, double otherwise) { return value > 0.0 ? value : otherwise; };
  gyradii_ = {given(settings.gyradii.x, 0.35 * size.y), given(settings.gyradii.y, 0.25 * size.x),
              given(settings.gyradii.z, 0.25 * size.x)};
  shortestWavelength_ = settings.shortestWavelength.value_or(cutoffFor(size.x));
  if (settings.knownVolume) {
    const double own = submergedPart(mesh_, WaterPlane::at(0.0)).volume;
    volumeFactor_ = *settings.knownVolume / own;
    if (!(volumeFactor_ > 0.5) || !(volumeFactor_ < 2.0)) {
      throw InputError("a known displacement of " + std::to_string(*settings.knownVolume) +
                       " m3 is not within a factor of two of the mesh's, " + std::to_string(own) +
                       " m3 below z = 0");
    }
  }
  setPanels();
  setRest();
  setColumns();
}

void HullModel::setPanels() {
  const glm::dvec3 size = bounds_.size();
  // Half-way down at most, so that probes are in the water that the hull sits in.
  for (int i = 0; i < probes; ++i) {
    const glm::dvec2 part((i / probesAcross + 0.5) / probesAlong,
                          (i % probesAcross + 0.5) / probesAcross);
    probePlaces_[static_cast<std::size_t>(i)] = {bounds_.lower.x + part.x * size.x,
                                                 bounds_.lower.y + part.y * size.y, 0.0};
  }
  for (const auto& t : mesh_.triangles) {
    Panel panel;
    panel.corners = t;
    panel.area = areaVector(mesh_, t);
    panel.size = glm::length(panel.area);
    if (panel.size > 0.0) panel.normal = panel.area / panel.size;
    panel.middle = (mesh_.vertices[t.x] + mesh_.vertices[t.y] + mesh_.vertices[t.z]) / 3.0;
    for (int i = 0; i < 3; ++i) {
      panel.moments[static_cast<std::size_t>(i)] =
          glm::cross((3.0 * panel.middle + mesh_.vertices[t[i]]) / 12.0, panel.area);
    }
    const auto cell = [&](double part, int cells) {
      return std::clamp(static_cast<int>(part * cells), 0, cells - 1);
    };
    panel.probe = cell((panel.middle.x - bounds_.lower.x) / size.x, probesAlong) * probesAcross +
                  cell((panel.middle.y - bounds_.lower.y) / size.y, probesAcross);
    panels_.push_back(panel);
  }
}

void HullModel::setRest() {
  const HullSettings& s = settings_;
  const double volume = s.mass / (seaWaterDensity * volumeFactor_);
  const WaterPlane plane = planeOfVolume(mesh_, volume);
  restHeight_ = -plane.height;
  atRest_ = submergedPart(mesh_, plane);
  for (glm::dvec3& probe : probePlaces_) probe.z = 0.5 * (plane.height + bounds_.lower.z);
  const double weightDensity = seaWaterDensity * standardGravity * volumeFactor_;
  const double rise = atRest_.centre.z - s.centreOfGravity.z;
  const double weight = s.mass * standardGravity;
  const double heave = weightDensity * atRest_.waterplaneArea;
  const double roll = weight * (atRest_.transverseRadius() + rise);
  const double pitch = weight * (atRest_.longitudinalRadius() + rise);
  const glm::dvec3 inertia = s.mass * gyradii_ * gyradii_;
  heaveFrequency_ = safeRoot(heave / s.mass);
  rollFrequency_ = safeRoot(roll / inertia.x);
  pitchFrequency_ = safeRoot(pitch / inertia.y);
  const HullCoefficients& c = s.coefficients;
  for (std::size_t i = 0; i < 3; ++i) {
    addedMass_[i] = c.addedMass[i] * s.mass;
    addedMass_[i + 3] = c.addedMass[i + 3] * inertia[static_cast<int>(i)];
  }
  damping_ = {2.0 * c.heaveDamping * safeRoot(heave * (s.mass + addedMass_[2])),
              2.0 * c.rollDamping * safeRoot(roll * (inertia.x + addedMass_[3])),
              2.0 * c.pitchDamping * safeRoot(pitch * (inertia.y + addedMass_[4]))};
}

// Columns stand at the middles of equal cells; their areas are scaled to the mesh's displacement
// and their places to its waterplane's second moments at rest.
void HullModel::setColumns() {
  if (settings_.level != LoadLevel::columns) return;
  const glm::ivec2 count = settings_.columns;
  const glm::dvec3 size = bounds_.size();
  const double area = size.x * size.y / (count.x * count.y);
  for (int i = 0; i < count.x; ++i) {
    for (int j = 0; j < count.y; ++j) {
      const glm::dvec2 place(bounds_.lower.x + (i + 0.5) / count.x * size.x,
                             bounds_.lower.y + (j + 0.5) / count.y * size.y);
      const std::vector<double> heights = crossings(mesh_, place);
      for (std::size_t k = 0; k + 1 < heights.size(); k += 2) {
        columns_.push_back({place, area, heights[k], heights[k + 1]});
      }
    }
  }
  double volume = 0.0, along = 0.0, across = 0.0, waterplane = 0.0;
  for (const MeshColumn& column : columns_) {
    volume += column.area * std::clamp(-restHeight_ - column.low, 0.0, column.high - column.low);
    if (column.low >= -restHeight_ || column.high <= -restHeight_) continue;
    const glm::dvec2 arm = column.place - glm::dvec2(atRest_.waterplaneCentre);
    waterplane += column.area;
    along += column.area * arm.x * arm.x;
    across += column.area * arm.y * arm.y;
  }
  if (!(volume > 0.0) || !(along > 0.0) || !(across > 0.0)) {
    throw InputError("a hull's columns miss its underwater part: more of them are needed");
  }
  const double share = atRest_.volume / volume;
  const glm::dvec2 stretch(std::sqrt(atRest_.longitudinalMoment / (along * share)),
                           std::sqrt(atRest_.transverseMoment / (across * share)));
  const glm::dvec2 centre(atRest_.waterplaneCentre);
  for (MeshColumn& column : columns_) {
    column.area *= share;
    column.place = centre + stretch * (column.place - centre);
  }
}

std::size_t HullModel::memoryBytes() const {
  return sizeof(HullModel) + mesh_.vertices.size() * sizeof(glm::dvec3) +
         mesh_.triangles.size() * sizeof(TriangleMesh::Triangle) + panels_.size() * sizeof(Panel) +
         columns_.size() * sizeof(MeshColumn);
}

}  // namespace seaway
