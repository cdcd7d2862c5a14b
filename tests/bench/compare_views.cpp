#include <tbb/parallel_for_each.h>
#include <tbb/task_arena.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <mutex>

#include "render/technique_choice.h"
#include "tests/bench/view_figures.h"

/// The projected grid against a ray-cast of the same sea, from cameras anywhere (random_views.h):
///
///   compare_views                            1000 cameras, 640x400 pixels, 512x1024 vertices
///   compare_views --from 500 --count 100 --sea group --minutes 9
///   compare_views --backend egl:0 --variant marched --count 100
///
/// Running worst figures go to standard error, a JSON summary to standard output: of every figure
/// the worst, the 99th percentile and the median over views, and the parameters of the worst views.
/// All cores share the work; figures do not depend on how many there are.
namespace {

using namespace seaway;
using namespace seaway::render;
using seaway::render::test::SeaKind;
using Clock = std::chrono::steady_clock;

struct Options {
  std::uint64_t from = 0, count = 1000;
  std::string seas = "both";
  glm::ivec2 size{640, 400};
  TechniqueChoice choice{.variant = "software", .grid = {512, 1024}};
  double minutes = 1e6;
};

struct Job {
  std::uint64_t number;
  SeaKind sea;
};

std::vector<Job> jobsOf(const Options& options) {
  std::vector<Job> jobs;
  for (std::uint64_t i = options.from; i < options.from + options.count; ++i) {
    if (options.seas != "perlin") jobs.push_back({i, SeaKind::group});
    if (options.seas != "group") jobs.push_back({i, SeaKind::perlin});
  }
  return jobs;
}

bench::ViewFigures compared(const Job& job, const Options& options, RenderTechnique& technique) {
  const test::RandomView random = test::randomView(job.number, options.size, job.sea);
  EffectLedger effects;
  View view;
  view.water = &random.water;
  view.time = random.time;
  view.camera = random.camera;
  view.effects = &effects;
  view.wantsNormals = true;
  const Frame drawn = technique.draw(view);
  const Frame reference = makeReference({.grid = options.choice.grid})->draw(view);
  return bench::figuresOf(job.number, job.sea, random, drawn, reference);
}

/// What has been compared so far; tells of it now and then.
class Log {
 public:
  explicit Log(std::size_t planned) : planned_(planned) {}
  double minutes() const {
    return std::chrono::duration<double>(Clock::now() - start_).count() / 60.0;
  }
  void add(const bench::ViewFigures& view) {
    const std::lock_guard lock(mutex_);
    views_.push_back(view);
    const bool tells = minutes() > nextTold_ || views_.size() == planned_;
    if (!tells) return;
    nextTold_ = minutes() + 0.1;
    std::fprintf(stderr, "%zu of %zu views in %.1f min, worst %s\n", views_.size(), planned_,
                 minutes(), bench::worstSoFar(views_).c_str());
  }
  const std::vector<bench::ViewFigures>& views() const { return views_; }

 private:
  std::size_t planned_;
  Clock::time_point start_ = Clock::now();
  double nextTold_ = 0.0;
  std::mutex mutex_;
  std::vector<bench::ViewFigures> views_;
};

/// Views in order, as long as there is time. Each has a technique of its own where it needs no
/// context; one context draws one view after another.
void compareAll(const std::vector<Job>& jobs, const Options& options, Log& log) {
  if (options.choice.variant != "software") {
    const auto technique = makeTechnique(options.choice);
    for (const Job& job : jobs) {
      if (log.minutes() < options.minutes) log.add(compared(job, options, *technique));
    }
    return;
  }
  std::atomic<std::size_t> next{0};
  const std::vector<int> workers(static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()));
  tbb::parallel_for_each(workers, [&](int) {
    for (std::size_t i = next++; i < jobs.size() && log.minutes() < options.minutes; i = next++) {
      // A thread that waits for a part of its own view must not begin another.
      tbb::this_task_arena::isolate(
          [&] { log.add(compared(jobs[i], options, *makeTechnique(options.choice))); });
    }
  });
}

Options parsed(int argc, char** argv) {
  Options options;
  CLI::App app("The projected grid against a ray-cast, from random cameras");
  app.add_option("--from", options.from, "number of the first camera");
  app.add_option("--count", options.count, "cameras");
  app.add_option("--sea", options.seas, "group, perlin or both: the sea of each camera")
      ->check(CLI::IsMember({"group", "perlin", "both"}));
  app.add_option("--width", options.size.x)->check(CLI::PositiveNumber);
  app.add_option("--height", options.size.y)->check(CLI::PositiveNumber);
  app.add_option("--columns", options.choice.grid.x);
  app.add_option("--rows", options.choice.grid.y);
  app.add_option("--variant", options.choice.variant, "of the projected grid (software)");
  app.add_option("--backend", options.choice.backend, "of variants that draw through OpenGL");
  app.add_option("--minutes", options.minutes, "begin no view after as many");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = parsed(argc, argv);
  try {
    const std::vector<Job> jobs = jobsOf(options);
    Log log(jobs.size());
    compareAll(jobs, options, log);
    nlohmann::ordered_json summary{{"from", options.from},
                                   {"count", options.count},
                                   {"sea", options.seas},
                                   {"size", {options.size.x, options.size.y}},
                                   {"grid", {options.choice.grid.x, options.choice.grid.y}},
                                   {"variant", options.choice.variant},
                                   {"minutes", log.minutes()}};
    summary.update(bench::summaryOf(log.views()));
    std::cout << summary.dump(2) << '\n';
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
