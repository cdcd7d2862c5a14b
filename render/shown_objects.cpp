#include "render/shown_objects.h"

#include <algorithm>
#include <string>

#include "render/scene_object.h"

namespace seaway::render {
namespace {

struct Kind {
  ObjectKind kind;
  const char* seen;
  const char* unseen;
};
constexpr Kind kinds[] = {
    {ObjectKind::vessel, "a vessel is in the camera's view", "no vessel in view"},
    {ObjectKind::scenery, "scenery is in the camera's view", "no scenery in view"},
};

}  // namespace

Effect effectOf(ObjectKind kind) {
  switch (kind) {
    case ObjectKind::vessel:
      return Effect::vesselMeshes;
    case ObjectKind::scenery:
      return Effect::scenery;
  }
  return Effect::count;
}

View withoutSwitchedOff(const View& view, std::vector<SceneObject>& kept) {
  const auto isOff = [&](const SceneObject& o) { return view.effects->isOff(effectOf(o.kind)); };
  View result = view;
  if (!std::any_of(view.objects.begin(), view.objects.end(), isOff)) return result;
  kept.clear();
  std::remove_copy_if(view.objects.begin(), view.objects.end(), std::back_inserter(kept), isOff);
  result.objects = kept;
  return result;
}

std::optional<Effect> decideObjects(const View& view) {
  std::optional<Effect> payer;
  for (const Kind& k : kinds) {
    const bool inside = std::any_of(
        view.objects.begin(), view.objects.end(),
        [&](const SceneObject& o) { return o.kind == k.kind && inView(o, view.camera); });
    const Effect effect = effectOf(k.kind);
    if (!view.effects->decide(effect, inside, inside ? k.seen : k.unseen) || !inside) continue;
    if (payer) view.effects->chargeInside(effect, *payer);
    if (!payer) payer = effect;
  }
  return payer;
}

}  // namespace seaway::render
