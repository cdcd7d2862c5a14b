#include <grpcpp/grpcpp.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "seaway/v1/water.grpc.pb.h"
#include "sim_bridge/grpc/rpc_server.h"
#include "sim_bridge/grpc/water_service.h"
#include "sim_bridge/scene/sea.h"

// What gRPC adds to the evaluation of 1000 points on 12 octaves.
//   grpc_bench [ROUNDS] [--clients N] [--seconds S] [--server-cores N]
// First a host by itself: cases in turn, so that each has the machine as the others have it; medians,
// 10th and 99th percentiles, and what is above the bare evaluation. Then N hosts at once, from a process of
// their own: calls a second beside the same evaluation without gRPC on as many cores, and what of the
// processors the server takes for a call. With --server-cores the server has the first N cores, its
// hosts the others.
namespace {

using namespace seaway;
using namespace seaway::bridge;
using Clock = std::chrono::steady_clock;

constexpr std::size_t points = 1000;
// Of both processes; the folder of the machine's own that is always there.
const std::string path = "unix:/tmp/seaway_grpc_bench." + std::to_string(getpid());

struct Options {
  int rounds = 5000;
  int clients = 64;
  double seconds = 3.0;
  int serverCores = 0;  // 0: all, as the hosts have
};

double secondsSince(Clock::time_point begun) {
  return std::chrono::duration<double>(Clock::now() - begun).count();
}

double processorSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

void stayOn(int from, int to) {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  for (int core = from; core < to; ++core) CPU_SET(core, &cores);
  if (sched_setaffinity(0, sizeof cores, &cores) != 0) std::perror("sched_setaffinity");
}

Scene sceneOfTwelveOctaves() {
  Scene scene;
  scene.sea.anchor = {28.878, -78.467};
  scene.sea.seed = 7;
  scene.effects[static_cast<std::size_t>(Effect::wake)] = EffectSetting::off;
  ParametricState state;
  state.significantWaveHeight = 1.12;
  state.peakPeriod = 5.6;
  state.from_deg = 196.0;
  state.octaves = 12;
  scene.sea.state = state;
  return scene;
}

v1::SampleRequest request(bool all) {
  v1::SampleRequest made;
  for (std::size_t i = 0; i < points; ++i) {
    made.mutable_plane()->add_x_m(6000.0 + 0.5 * static_cast<double>(i));
    made.mutable_plane()->add_y_m(2400.0);
  }
  made.set_time_s(0.0);
  made.add_quantities(v1::QUANTITY_HEIGHT);
  if (!all) return made;
  made.add_quantities(v1::QUANTITY_SLOPE);
  made.add_quantities(v1::QUANTITY_VERTICAL_VELOCITY);
  return made;
}

/// A sea behind a socket and a port.
struct Server {
  Server() {
    for (auto* server : {&local, &network}) {
      rpc::addWaterService(*server, host);
      server->bind();
      server->start();
    }
  }
  ~Server() {
    local.stop();
    network.stop();
  }
  static rpc::RpcServerOptions at(const std::string& address) {
    return {.option = "grpc_bench",
            .address = address,
            .credentials = grpc::InsecureServerCredentials(),
            .token = ""};
  }
  Scene scene = sceneOfTwelveOctaves();
  ServedSea sea{scene, buildSea(scene)};
  FrameMaker frames{sea};
  rpc::WaterHost host{sea, ServeClock::parse("--clock", "host"), frames};
  rpc::RpcServer local{at(path), sea.meters().of("local")};
  rpc::RpcServer network{at("127.0.0.1:0"), sea.meters().of("network")};
};

std::unique_ptr<v1::Water::Stub> stubOf(const std::string& address) {
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  return v1::Water::NewStub(
      grpc::CreateCustomChannel(address, grpc::InsecureChannelCredentials(), arguments));
}

[[noreturn]] void fail(const char* what) {
  std::fprintf(stderr, "%s\n", what);
  std::_Exit(1);
}

/// One host that asks by itself or on a stream.
class Host {
 public:
  Host(const std::string& address, bool streaming) : stub_(stubOf(address)) {
    if (streaming) stream_ = stub_->SampleStream(&context_);
  }
  ~Host() {
    if (!stream_) return;
    context_.TryCancel();
    stream_->Finish();
  }
  void ask(const v1::SampleRequest& asked) {
    if (stream_) {
      if (!stream_->Write(asked) || !stream_->Read(&response_)) fail("the stream has ended");
      return;
    }
    grpc::ClientContext context;
    if (!stub_->Sample(&context, asked, &response_).ok()) fail("refused");
  }

 private:
  std::unique_ptr<v1::Water::Stub> stub_;
  grpc::ClientContext context_;
  std::unique_ptr<grpc::ClientReaderWriter<v1::SampleRequest, v1::SampleResponse>> stream_;
  v1::SampleResponse response_;
};

class Evaluation {
 public:
  Evaluation(ServedSea& sea, bool all) : sea_(sea), samples_(points) {
    options_.derivatives = all;
    const v1::SampleRequest asked = request(all);
    for (int i = 0; i < asked.plane().x_m_size(); ++i) {
      places_.emplace_back(asked.plane().x_m(i), asked.plane().y_m(i));
    }
  }
  void run(double t) { sea_.surface()->sample(places_, t, samples_, options_); }

 private:
  ServedSea& sea_;
  SampleOptions options_;
  std::vector<glm::dvec2> places_;
  std::vector<SurfaceSample> samples_;
};

struct Case {
  std::string name;
  std::function<void(double t)> run;
  std::vector<double> us{};
};

std::vector<Case> casesOf(Server& server, bool all) {
  auto evaluation = std::make_shared<Evaluation>(server.sea, all);
  std::vector<Case> cases{{"evaluation", [=](double t) { evaluation->run(t); }}};
  const auto add = [&](const std::string& name, const std::string& address, bool streaming) {
    auto host = std::make_shared<Host>(address, streaming);
    auto asked = std::make_shared<v1::SampleRequest>(request(all));
    cases.push_back({name, [=](double t) {
                       asked->set_time_s(t);
                       host->ask(*asked);
                     }});
  };
  add("stream, unix socket", server.local.address(), true);
  add("stream, loopback", server.network.address(), true);
  add("unary, unix socket", server.local.address(), false);
  add("unary, loopback", server.network.address(), false);
  return cases;
}

void printOneHost(Server& server, int rounds, bool all) {
  std::vector<Case> cases = casesOf(server, all);
  const int warmUp = std::min(200, rounds);
  for (int round = -warmUp; round < rounds; ++round) {
    for (Case& one : cases) {
      const auto begun = Clock::now();
      one.run(0.01 * round);
      if (round >= 0) one.us.push_back(1e6 * secondsSince(begun));
    }
  }
  std::printf("%zu points, 12 octaves, %s; %d rounds; us\n%-22s %8s %8s %8s %20s\n", points,
              all ? "heights, slopes and rates" : "heights", rounds, "", "p10", "median", "p99",
              "above evaluation");
  double evaluation = 0.0;
  for (Case& one : cases) {
    std::sort(one.us.begin(), one.us.end());
    const double median = one.us[one.us.size() / 2];
    if (&one == cases.data()) evaluation = median;
    std::printf("%-22s %8.1f %8.1f %8.1f %20.1f\n", one.name.c_str(), one.us[one.us.size() / 10],
                median, one.us[one.us.size() * 99 / 100], median - evaluation);
  }
}

/// Runs `work` on so many threads for a while; times that it was done, a second.
double rateOf(int threads, double seconds, const std::function<void(std::atomic<bool>&,
                                                                    std::atomic<long>&)>& work) {
  std::atomic<bool> ending{false};
  std::atomic<long> done{0};
  std::vector<std::thread> all;
  for (int i = 0; i < threads; ++i) all.emplace_back([&] { work(ending, done); });
  std::this_thread::sleep_for(std::chrono::duration<double>(0.2 * seconds));
  const long before = done;
  const auto begun = Clock::now();
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  const double rate = static_cast<double>(done - before) / secondsSince(begun);
  ending = true;
  for (std::thread& thread : all) thread.join();
  return rate;
}

/// The hosts' process: told by a byte what to do, answers with a rate.
void serveAsHosts(int in, int out, const Options& options) {
  char kind = 0;
  while (read(in, &kind, 1) == 1) {
    const double rate = rateOf(options.clients, options.seconds, [&](auto& ending, auto& done) {
      Host host(path, kind == 's');
      const v1::SampleRequest asked = request(false);
      while (!ending) {
        host.ask(asked);
        ++done;
      }
    });
    if (write(out, &rate, sizeof rate) != sizeof rate) return;
  }
}

void printManyHosts(Server& server, const Options& options, int in, int out) {
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  const double bare = rateOf(cores, options.seconds, [&](auto& ending, auto& done) {
    Evaluation evaluation(server.sea, false);
    while (!ending) {
      evaluation.run(1.0);
      ++done;
    }
  });
  std::printf("%d hosts at once, server on %d cores, hosts on %s\n", options.clients, cores,
              options.serverCores > 0 ? "others" : "the same");
  std::printf("%-22s %10.0f calls/s %26.1f us of a core\n", "evaluation", bare, 1e6 * cores / bare);
  for (const char kind : {'s', 'u'}) {
    const double before = processorSeconds();
    const auto begun = Clock::now();
    double rate = 0.0;
    if (write(out, &kind, 1) != 1 || read(in, &rate, sizeof rate) != sizeof rate) fail("no hosts");
    const double each = (processorSeconds() - before) / (rate * secondsSince(begun));
    std::printf("%-22s %10.0f calls/s, %3.0f %% of evaluation; %5.1f us of a core\n",
                kind == 's' ? "streams, unix socket" : "unary, unix socket", rate,
                100.0 * rate / bare, 1e6 * each);
  }
}

Options optionsOf(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const char* value = i + 1 < argc ? argv[i + 1] : "0";
    if (word == "--clients") options.clients = std::atoi(value), ++i;
    else if (word == "--seconds") options.seconds = std::atof(value), ++i;
    else if (word == "--server-cores") options.serverCores = std::atoi(value), ++i;
    else options.rounds = std::max(1, std::atoi(word.c_str()));
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = optionsOf(argc, argv);
  int toHosts[2], fromHosts[2];
  if (pipe(toHosts) != 0 || pipe(fromHosts) != 0) return 1;
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  // Before gRPC has threads.
  const pid_t child = fork();
  if (child == 0) {
    close(toHosts[1]);
    if (options.serverCores > 0) stayOn(options.serverCores, cores);
    serveAsHosts(toHosts[0], fromHosts[1], options);
    std::_Exit(0);
  }
  {
    std::unique_ptr<Server> alone = std::make_unique<Server>();
    printOneHost(*alone, options.rounds, false);
    printOneHost(*alone, options.rounds, true);
  }
  if (options.serverCores > 0) stayOn(0, options.serverCores);
  {
    Server server;
    printManyHosts(server, options, fromHosts[0], toHosts[1]);
    close(toHosts[1]);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}
