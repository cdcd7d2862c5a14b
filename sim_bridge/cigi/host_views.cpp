#include "sim_bridge/cigi/host_views.h"

#include <algorithm>
#include <cmath>

namespace seaway::bridge::cigi {
namespace {

constexpr std::size_t mostViews = 64;
constexpr double widest_deg = 85.0;
constexpr double narrowest_deg = 0.01;

void take(bool enabled, double& value, float given) {
  if (enabled && std::isfinite(given)) value = given;
}

bool isDrawable(const HostView& view) {
  const auto within = [](double low, double high) {
    return low >= -widest_deg && high <= widest_deg && high - low >= narrowest_deg;
  };
  return within(view.left_deg, view.right_deg) && within(view.bottom_deg, view.top_deg);
}

}  // namespace

bool HostView::isCentred() const {
  return std::abs(top_deg + bottom_deg) < 1e-3 && std::abs(left_deg + right_deg) < 1e-3;
}

template <class Action>
void HostViews::forEach(std::uint16_t view, std::uint8_t group, Action action) {
  if (group == 0) {
    if (views_.contains(view) || views_.size() < mostViews) action(views_[view]);
    return;
  }
  for (auto& [number, each] : views_) {
    const auto of = groups_.find(number);
    if (of != groups_.end() && of->second == group) action(each);
  }
}

void HostViews::set(const ViewControl& control) {
  forEach(control.view, control.group, [&](HostView& view) {
    view.placed = true;
    view.entity = control.entity;
    take(control.xEnabled, view.x, control.x);
    take(control.yEnabled, view.y, control.y);
    take(control.zEnabled, view.z, control.z);
    take(control.rollEnabled, view.roll_deg, control.roll);
    take(control.pitchEnabled, view.pitch_deg, control.pitch);
    take(control.yawEnabled, view.yaw_deg, control.yaw);
  });
}

bool HostViews::set(const ViewDefinition& definition) {
  if (definition.orthographic || definition.mirror != 0) return false;
  const auto known = views_.find(definition.view);
  if (known == views_.end() && views_.size() >= mostViews) return false;
  HostView wanted = known == views_.end() ? HostView{} : known->second;
  take(definition.leftEnabled, wanted.left_deg, definition.left);
  take(definition.rightEnabled, wanted.right_deg, definition.right);
  take(definition.bottomEnabled, wanted.bottom_deg, definition.bottom);
  take(definition.topEnabled, wanted.top_deg, definition.top);
  if (!isDrawable(wanted)) return false;
  views_[definition.view] = wanted;
  groups_[definition.view] = definition.group;
  return true;
}

}  // namespace seaway::bridge::cigi
