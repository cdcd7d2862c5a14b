#include "sim_bridge/service/frame_maker.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <utility>

#include "render/headless_context.h"
#include "render/technique_choice.h"
#include "sim_bridge/scene_view.h"
#include "sim_bridge/scene_wakes.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

constexpr int largest = 4096;
constexpr double longestWait = 5.0;  // s, for wakes and what lies on the water

void requireDrawable(const FrameRequest& request) {
  if (!(std::abs(request.t) <= WaveField::latest)) {
    throw InputError("a picture's time must be finite, within 1e12 s of the scene's epoch");
  }
  if (request.size == glm::ivec2(0)) return;
  const bool allowed = request.size.x >= 1 && request.size.x <= largest && request.size.y >= 1 &&
                       request.size.y <= largest;
  if (!allowed) {
    throw InputError("a picture of " + std::to_string(request.size.x) + "x" +
                     std::to_string(request.size.y) +
                     " pixels is not allowed; must be within 1x1 and 4096x4096");
  }
}

}  // namespace

/// What pictures of one scene are drawn with.
struct FrameMaker::Scenery {
  Scenery(std::shared_ptr<const ServedScene> of, const std::string& backend)
      : scene(std::move(of)),
        view(scene->scene),
        technique(render::makeTechnique({.grid = scene->scene.accuracy.grid, .backend = backend})) {
  }

  std::shared_ptr<const ServedScene> scene;
  SceneView view;
  std::unique_ptr<render::RenderTechnique> technique;
};

FrameMaker::FrameMaker(ServedSea& sea, std::string backend)
    : sea_(sea), backend_(std::move(backend)) {
  render::requireBackend(backend_);
  thread_ = std::thread([this] { run(); });
}

FrameMaker::~FrameMaker() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    posted_.notify_all();
  }
  thread_.join();
}

void FrameMaker::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    posted_.wait(lock, [&] { return ending_ || !jobs_.empty(); });
    if (ending_) break;
    const auto job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    job();
    lock.lock();
  }
  jobs_.clear();  // whose promises are broken
  lock.unlock();
  scenery_ = nullptr;  // a graphics context goes on the thread that made it
}

std::shared_ptr<const render::Frame> FrameMaker::draw(const FrameRequest& request) {
  requireDrawable(request);
  auto task = std::make_shared<std::packaged_task<Picture()>>(
      [this, &request] { return drawHere(request); });
  auto picture = task->get_future();
  {
    const std::lock_guard lock(mutex_);
    if (ending_) throw std::runtime_error("the service ends");
    jobs_.emplace_back([task] { (*task)(); });
    posted_.notify_one();
  }
  task = nullptr;
  try {
    return picture.get();
  } catch (const std::future_error&) {
    throw std::runtime_error("the service ends");
  }
}

void FrameMaker::setCamera(const std::string& name, const std::optional<SceneCamera>& camera,
                           std::uint32_t hull) {
  const std::lock_guard lock(mutex_);
  if (camera) {
    cameras_[name] = {*camera, hull};
  } else {
    cameras_.erase(name);
  }
}

std::vector<std::string> FrameMaker::cameras() const {
  std::vector<std::string> names;
  const auto scene = sea_.scene();
  for (const SceneCamera& camera : scene->cameras) names.push_back(camera.name);
  const std::lock_guard lock(mutex_);
  for (const auto& [name, camera] : cameras_) names.push_back(name);
  return names;
}

std::vector<EffectReport> FrameMaker::effects() const {
  const std::lock_guard lock(mutex_);
  return effects_;
}

FrameMaker::Camera FrameMaker::cameraOf(const FrameRequest& request, const Scene& scene) const {
  if (request.own) return {*request.own, 0};
  {
    const std::lock_guard lock(mutex_);
    const auto set = cameras_.find(request.camera);
    if (set != cameras_.end()) return set->second;
  }
  return {findCamera(scene, request.camera), 0};
}

FrameMaker::Picture FrameMaker::drawHere(const FrameRequest& request) {
  ServedMoment moment = sea_.moment(request.t);
  if (!scenery_ || scenery_->scene != moment.scene) {
    scenery_ = nullptr;
    scenery_ = std::make_unique<Scenery>(moment.scene, backend_);
  }
  const Scene& scene = moment.scene->scene;
  const auto [camera, mount] = cameraOf(request, scene);
  const glm::ivec2 size = request.size == glm::ivec2(0) ? scene.run.size : request.size;
  std::vector<PlacedVessel> vessels;
  const auto takeVessels = [&, on = mount] {
    std::stable_partition(moment.hulls.begin(), moment.hulls.end(),
                          [on](const ServedHull& each) { return on != 0 && each.hull == on; });
    vessels.assign(moment.hulls.begin(), moment.hulls.end());
  };
  takeVessels();
  const auto seen = [&] {
    return SceneMoment{request.t, moment.surface.get(), &sea_.geodesy(), vessels};
  };
  const render::Camera placed = placedCamera(scene, camera, seen(), size);
  const WakeListener eye{glm::dvec2(placed.position), cameraReach, 0};
  sea_.attend(request.t, std::span(&eye, 1));
  sea_.awaitWakes(longestWait);
  // Vessels float on what has come meanwhile.
  ServedMoment whole = sea_.moment(request.t);
  if (whole.scene == moment.scene) {
    moment = std::move(whole);
    takeVessels();
  }
  EffectLedger ledger(scene.effects);
  auto frame = std::make_shared<render::Frame>();
  render::View view = scenery_->view.view(seen(), camera, size, ledger);
  view.wantsNormals = request.wantsNormals;
  scenery_->technique->drawInto(view, *frame);
  const std::lock_guard lock(mutex_);
  effects_ = ledger.report();
  return frame;
}

}  // namespace seaway::bridge
