#include <benchmark/benchmark.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim_bridge/scene/sea.h"
#include "sim_bridge/shm/sea_host.h"
#include "sim_bridge/shm/seaway_shm.hpp"
#include "sim_bridge/shm/shm_endpoint.h"
#include "tests/bench/evaluation_echo.h"
#include "tests/bench/physics_host.h"

// What shared memory adds to the evaluation of the water: a server in a process of its own, 1000
// points, 12 octaves. `--table` runs the cases in turn, so that each has the machine as the others
// have it, and prints medians, 99th percentiles and what is above the bare evaluation. `--host
// SECONDS` is a physics engine that asks 1000 points every millisecond, beside one that asks a bare
// process for the same, the floor, and one that asks nobody.
namespace seaway::bridge::shm {
namespace {

constexpr std::uint32_t points = 1000;

Scene sceneOfTwelveOctaves() {
  Scene scene;
  scene.sea.anchor = {28.878, -78.467};
  scene.sea.seed = 7;
  ParametricState state;
  state.significantWaveHeight = 1.12;
  state.peakPeriod = 5.6;
  state.from_deg = 196.0;
  state.octaves = 12;
  scene.sea.state = state;
  return scene;
}

/// The server, until it is destroyed.
class ServerProcess {
 public:
  ServerProcess(const std::string& name, double spin) {
    int ends[2];
    if (pipe(ends) != 0) std::abort();
    child_ = fork();
    if (child_ == 0) serve(name, spin, ends[1]);
    char ready = 0;
    if (read(ends[0], &ready, 1) != 1) std::abort();
    close(ends[0]);
    close(ends[1]);
  }
  ~ServerProcess() {
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
    shm_unlink(("/" + name()).c_str());
  }
  static std::string name() { return "seaway-bench-" + std::to_string(getpid()); }
  pid_t id() const { return child_; }

 private:
  [[noreturn]] static void serve(const std::string& name, double spin, int ready) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const Scene scene = sceneOfTwelveOctaves();
    ServedSea sea(scene, buildSea(scene));
    ShmOptions options;
    options.name = name;
    options.spin = spin;
    options.backing.newHost = [&sea] { return std::make_unique<SeaHost>(sea); };
    ShmEndpoint endpoint(options);
    endpoint.start();
    if (write(ready, "!", 1) != 1) std::abort();
    for (;;) pause();
  }
  pid_t child_;
};

struct Spins {
  double server = ShmOptions{}.spin, client = seaway_shm_default_options().spin;  // s
};

/// How a request finds the thread that answers it: looking for it, as after the last of a burst, or
/// asleep, as at the tick of a physics engine.
enum class ServerIs { awake, asleep, asIs };

/// A host with a server, and the same sea in its own process.
class Setup {
 public:
  explicit Setup(const Spins& spins) : server_(ServerProcess::name(), spins.server) {
    seaway_shm_options options = seaway_shm_default_options();
    options.connect_timeout = 10.0;
    options.spin = spins.client;
    client_ = std::make_unique<seaway::shm::Client>(ServerProcess::name(), options);
    for (std::uint32_t i = 0; i < points; ++i) {
      x_.push_back(6000.0 + 0.1 * i);
      y_.push_back(2400.0 - 0.05 * i);
      longitudes_.push_back(-78.4 + 1e-6 * i);
      latitudes_.push_back(28.9 - 5e-7 * i);
      both_.emplace_back(x_.back(), y_.back());
    }
    samples_.resize(points);
  }

  /// Warm, as the server's own thread has it: the second of two.
  void evaluation(std::uint32_t count) {
    sea_.surface()->sample(std::span(both_).first(count), time(), samples_);
    begin();
    sea_.surface()->sample(std::span(both_).first(count), time(), samples_);
    benchmark::DoNotOptimize(samples_.data());
    end();
  }
  void evaluateOnce() {
    sea_.surface()->sample(both_, time(), samples_);
    benchmark::DoNotOptimize(samples_.data());
  }
  /// Points written in place and heights read in place: what a host pays that has its own arrays
  /// there.
  void inPlace(std::uint32_t count, std::uint32_t flags = 0, ServerIs server = ServerIs::awake) {
    make(server);
    seaway_shm_batch batch;
    require(seaway_shm_begin(&client_->c(), SEAWAY_SHM_SAMPLE, &batch));
    const bool geodetic = (flags & SEAWAY_SHM_GEODETIC) != 0;
    std::copy_n((geodetic ? longitudes_ : x_).data(), count, batch.x);
    std::copy_n((geodetic ? latitudes_ : y_).data(), count, batch.y);
    begin();
    batch.request->time = time();
    batch.request->flags = flags;
    batch.request->count = count;
    require(seaway_shm_call(&client_->c(), &batch));
    end();
    double sum = 0.0;
    for (std::uint32_t i = 0; i < count; ++i) sum += batch.height[i];
    benchmark::DoNotOptimize(sum);
  }
  /// Points copied in, all answers copied out.
  void copied() {
    make(ServerIs::awake);
    begin();
    const auto got = client_->sample(x_, y_, {.time = time()});
    std::size_t at = 0;
    for (const auto& each :
         {got.height, got.slopeEast, got.slopeNorth, got.verticalVelocity, got.error, got.bound}) {
      std::copy(each.begin(), each.end(), copies_.begin() + static_cast<std::ptrdiff_t>(at));
      at += points;
    }
    benchmark::DoNotOptimize(copies_.data());
    end();
  }

  double seconds() const { return std::chrono::duration<double>(ended_ - begun_).count(); }
  pid_t server() const { return server_.id(); }

 private:
  double time() { return 0.01 * ++frame_; }
  void begin() { begun_ = std::chrono::steady_clock::now(); }
  void end() { ended_ = std::chrono::steady_clock::now(); }
  void make(ServerIs server) {
    if (server == ServerIs::asleep) usleep(500);
    seaway_shm_batch nothing;
    require(seaway_shm_begin(&client_->c(), SEAWAY_SHM_SAMPLE, &nothing));
    if (server == ServerIs::awake) require(seaway_shm_call(&client_->c(), &nothing));
  }
  void require(seaway_shm_status status) {
    if (status == SEAWAY_SHM_OK) return;
    std::fprintf(stderr, "%s: %s\n", seaway_shm_status_text(status), client_->c().message);
    std::exit(1);
  }

  ServerProcess server_;  // first: before this process has threads
  Scene scene_ = sceneOfTwelveOctaves();
  ServedSea sea_{scene_, buildSea(scene_)};
  std::unique_ptr<seaway::shm::Client> client_;
  std::vector<double> x_, y_, longitudes_, latitudes_;
  std::vector<glm::dvec2> both_;
  std::vector<SurfaceSample> samples_;
  std::vector<double> copies_ = std::vector<double>(6 * points);
  std::uint32_t frame_ = 0;
  std::chrono::steady_clock::time_point begun_, ended_;
};

struct Case {
  const char* name;
  std::function<void(Setup&)> run;
};

const std::vector<Case> cases{
    {"evaluation/1000", [](Setup& s) { s.evaluation(points); }},
    {"shm/1000", [](Setup& s) { s.inPlace(points); }},
    {"shm/1000/asleep", [](Setup& s) { s.inPlace(points, 0, ServerIs::asleep); }},
    {"shm/1000/height", [](Setup& s) { s.inPlace(points, SEAWAY_SHM_HEIGHT_ONLY); }},
    {"shm/1000/orbital", [](Setup& s) { s.inPlace(points, SEAWAY_SHM_ORBITAL_VELOCITY); }},
    {"shm/1000/geodetic", [](Setup& s) { s.inPlace(points, SEAWAY_SHM_GEODETIC); }},
    {"shm/1000/copied", [](Setup& s) { s.copied(); }},
    {"evaluation/1", [](Setup& s) { s.evaluation(1); }},
    {"shm/1", [](Setup& s) { s.inPlace(1); }},
    {"shm/0", [](Setup& s) { s.inPlace(0); }},
};

void printTable(const Spins& spins) {
  constexpr int rounds = 5000;
  Setup setup(spins);
  std::vector<std::vector<double>> us(cases.size());
  for (int round = -200; round < rounds; ++round) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      cases[i].run(setup);
      if (round >= 0) us[i].push_back(1e6 * setup.seconds());
    }
  }
  std::printf("12 octaves, %d rounds, spins %.0f us (server) and %.0f us (host); us\n", rounds,
              1e6 * spins.server, 1e6 * spins.client);
  std::printf("%-20s %8s %8s %22s\n", "", "median", "p99", "above the evaluation");
  double evaluation = 0.0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    std::sort(us[i].begin(), us[i].end());
    const double median = us[i][rounds / 2];
    if (std::string(cases[i].name).starts_with("evaluation")) evaluation = median;
    std::printf("%-20s %8.1f %8.1f %22.1f\n", cases[i].name, median, us[i][rounds * 99 / 100],
                median - evaluation);
  }
}

/// The same points of the same sea, without a service.
std::function<void()> bareEvaluation() {
  struct Water {
    Sea sea = buildSea(sceneOfTwelveOctaves());
    std::vector<glm::dvec2> places;
    std::vector<SurfaceSample> samples = std::vector<SurfaceSample>(points);
    double time = 0.0;
  };
  const auto water = std::make_shared<Water>();
  for (std::uint32_t i = 0; i < points; ++i) {
    water->places.emplace_back(6000.0 + 0.1 * i, 2400.0 - 0.05 * i);
  }
  return [water] {
    water->sea.surface.sample(water->places, water->time += 0.01, water->samples);
    benchmark::DoNotOptimize(water->samples.data());
  };
}

/// Beside it, in turn, the same evaluation in another process that is woken by bare events, and in
/// the host's own: what Seaway does not share with the first is Seaway's.
void runHost(const seaway::bench::PhysicsHostOptions& options, const Spins& spins) {
  seaway::bench::EvaluationEcho echo(bareEvaluation);
  Setup setup(spins);
  std::printf("a host that asks 1000 points, 12 octaves, each ms for %.0f s\n", options.seconds);
  seaway::bench::runPhysicsHost(
      options,
      {{"asking Seaway", [&] { setup.inPlace(points, 0, ServerIs::asIs); }, setup.server()},
       {"asking an echo", [&] { echo.ask(); }, echo.id()},
       {"asking nobody", [&] { setup.evaluateOnce(); }}});
}

}  // namespace
}  // namespace seaway::bridge::shm

int main(int argc, char** argv) {
  using namespace seaway::bridge::shm;
  CLI::App app("What shared memory costs; other options are Google Benchmark's");
  app.allow_extras();
  bool table = false;
  seaway::bench::PhysicsHostOptions host{.seconds = 0.0};
  Spins spins;
  app.add_flag("--table", table, "medians and 99th percentiles, above the evaluation");
  app.add_option("--host", host.seconds, "s of a 1 kHz physics host");
  app.add_option("--fifo", host.fifo, "its and the server's priority of SCHED_FIFO, 1 to 99");
  app.add_option("--server-spin", spins.server, "s");
  app.add_option("--client-spin", spins.client, "s");
  CLI11_PARSE(app, argc, argv);
  if (table) printTable(spins);
  if (host.seconds > 0.0) runHost(host, spins);
  if (table || host.seconds > 0.0) return 0;
  benchmark::Initialize(&argc, argv);
  Setup setup(spins);
  for (const Case& one : cases) {
    benchmark::RegisterBenchmark(one.name, [&](benchmark::State& state) {
      for (auto _ : state) {
        one.run(setup);
        state.SetIterationTime(setup.seconds());
      }
    })->UseManualTime();
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
