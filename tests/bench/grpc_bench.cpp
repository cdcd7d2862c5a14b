#include <grpcpp/grpcpp.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "seaway/v1/water.grpc.pb.h"
#include "sim_bridge/grpc/rpc_server.h"
#include "sim_bridge/grpc/water_service.h"
#include "sim_bridge/scene/sea.h"
#include "tests/bench/grpc_echo.h"
#include "tests/bench/grpc_hosts.h"

// What gRPC adds to the evaluation of 1000 points on 12 octaves.
//   grpc_bench [ROUNDS] [--clients N] [--ahead N] [--seconds S] [--server-cores N] [--listen N]
// Beside it, what the bare library takes to answer as many bytes and to answer none: the floor.
// On a unix socket and on the loopback, from hosts in a process of their own. First one host: kinds
// of call in turn with the bare evaluation, so that each has the machine as the others have it.
// Then N hosts at once: calls a second beside the same evaluation without gRPC on as many cores,
// what of the processors the server takes for a call, and what the bare library takes: evaluation
// and that together are the least for any service, hence the highest share that is attainable. With
// --server-cores the server has the first N cores, its hosts the others; --listen:
// RpcServerOptions::callsListenedFor.
namespace {

using namespace seaway;
using namespace seaway::bridge;
using namespace seaway::bench;
// Of both processes; the folder of the machine's own that is always there.
const std::string path = "unix:/tmp/seaway_grpc_bench." + std::to_string(getpid());

struct Options {
  int rounds = 5000;
  int clients = 64;
  int ahead = 0;  // requests that each has under way beside the one it waits for, on streams
  double seconds = 3.0;
  int serverCores = 0;  // 0: all, as the hosts have
  int listen = rpc::RpcServerOptions().callsListenedFor;
};

double processorSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Of the cores that this process has, those from one on to before another.
void stayOn(int from, int to) {
  cpu_set_t had, cores;
  CPU_ZERO(&cores);
  if (sched_getaffinity(0, sizeof had, &had) != 0) fail("sched_getaffinity");
  for (int core = 0, place = 0; core < CPU_SETSIZE; ++core) {
    if (!CPU_ISSET(core, &had)) continue;
    if (place >= from && place < to) CPU_SET(core, &cores);
    ++place;
  }
  if (sched_setaffinity(0, sizeof cores, &cores) != 0) fail("sched_setaffinity");
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

/// A sea behind an address.
struct Server {
  Server(const std::string& address, int callsListenedFor)
      : rpc({.option = "grpc_bench",
             .address = address,
             .credentials = grpc::InsecureServerCredentials(),
             .token = "",
             .callsListenedFor = callsListenedFor},
            sea.meters().of("grpc")) {
    rpc::addWaterService(rpc, host);
    rpc.bind();
    rpc.start();
  }
  ~Server() { rpc.stop(); }

  Scene scene = sceneOfTwelveOctaves();
  ServedSea sea{scene, buildSea(scene)};
  FrameMaker frames{sea};
  rpc::WaterHost host{sea, ServeClock::parse("--clock", "host"), frames};
  rpc::RpcServer rpc;
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

void print(const char* name, std::vector<double>& us, double evaluation) {
  std::sort(us.begin(), us.end());
  const double median = us[us.size() / 2];
  std::printf("%-22s %8.1f %8.1f %8.1f", name, us[us.size() / 10], median,
              us[us.size() * 99 / 100]);
  if (evaluation > 0.0) std::printf(" %20.1f", median - evaluation);
  std::printf("\n");
}

/// The bytes of an answer.
std::string anAnswer(bool all) {
  v1::SampleResponse made;
  for (std::size_t i = 0; i < points; ++i) {
    made.add_height_m(1.0);
    if (!all) continue;
    made.add_slope_east(0.1f);
    made.add_slope_north(0.1f);
    made.add_vertical_velocity_m_s(0.1f);
  }
  return made.SerializeAsString();
}

/// The bare library, answering as many bytes as an answer has, and none.
struct Echoes {
  const bool large;
  EchoServer full, empty;
  std::string fullAddress, emptyAddress;

  Echoes(const std::string& address, bool all)
      : large(all),
        full(echoAddress(address, 0), anAnswer(all)),
        empty(echoAddress(address, 1), "") {
    const bool local = address.starts_with("unix:");
    const auto at = [&](int which, int port) {
      return local ? echoAddress(address, which) : "127.0.0.1:" + std::to_string(port);
    };
    fullAddress = at(0, full.port());
    emptyAddress = at(1, empty.port());
  }
  std::string echoAddress(const std::string& address, int which) const {
    if (!address.starts_with("unix:")) return "127.0.0.1:0";
    // Hosts keep what they have opened, by address.
    return address + (large ? ".large" : ".small") + std::to_string(which);
  }
};

void printOneHost(Server& server, Hosts hosts, int rounds, bool all) {
  constexpr int block = 50;
  Evaluation evaluation(server.sea, all);
  const std::string address = server.rpc.address();
  const Echoes echoes(address, all);
  struct Row {
    const char* name;
    std::string address;
    bool streaming, evaluates;
    std::size_t count;
    std::vector<double> us = {};
  };
  Row rows[] = {{"stream", address, true, true, points},
                {"unary", address, false, true, points},
                {"bare gRPC, stream", echoes.fullAddress, true, false, points},
                {"bare gRPC, unary", echoes.fullAddress, false, false, points},
                {"empty bare stream", echoes.emptyAddress, true, false, 0},
                {"empty bare unary", echoes.emptyAddress, false, false, 0}};
  std::vector<double> bare;
  for (int round = -4 * block; round < rounds; round += block) {
    for (int i = 0; i < block; ++i) {
      const auto begun = Clock::now();
      evaluation.run(0.01 * i);
      if (round >= 0) bare.push_back(1e6 * secondsSince(begun));
    }
    for (Row& row : rows) {
      const auto us = hosts.timed(row.address, row.streaming, all, row.count, block);
      if (round >= 0) row.us.insert(row.us.end(), us.begin(), us.end());
    }
  }
  std::printf("%zu points, 12 octaves, %s, %s; us\n%-22s %8s %8s %8s %20s\n", points,
              all ? "heights, slopes and rates" : "heights", address.c_str(), "", "p10", "median",
              "p99", "above evaluation");
  print("evaluation", bare, 0.0);
  const double median = bare[bare.size() / 2];
  for (Row& row : rows) print(row.name, row.us, row.evaluates ? median : 0.0);
}

/// What so many hosts at once do with a server.
struct Load {
  double rate;  // calls a second
  double us;    // of the processors, that this process takes for a call
};

Load loadOf(Hosts hosts, const std::string& address, bool streaming, const Options& options) {
  const double before = processorSeconds();
  const auto begun = Clock::now();
  const double rate =
      hosts.rate(address, streaming, options.clients, options.ahead, options.seconds);
  return {rate, 1e6 * (processorSeconds() - before) / (rate * secondsSince(begun))};
}

void printManyHosts(Server& server, Hosts hosts, const Options& options) {
  const int cores = rpc::coreCount();
  const double before = processorSeconds();
  const auto begun = Clock::now();
  const double bare = rateOf(cores, options.seconds, [&](auto& ending, auto& done) {
    Evaluation evaluation(server.sea, false);
    while (!ending) {
      evaluation.run(1.0);
      ++done;
    }
  });
  const double evaluation = 1e6 * (processorSeconds() - before) / (bare * secondsSince(begun));
  std::printf("%d hosts at once, server on %d cores, hosts on %s\n", options.clients, cores,
              options.serverCores > 0 ? "others" : "the same");
  std::printf("%-22s %10.0f calls/s %31.1f us of a core\n", "evaluation", bare, evaluation);
  const bool local = server.rpc.address().starts_with("unix:");
  const std::string address = local ? path + ".many" : "127.0.0.1:0";
  EchoServer echo(address, anAnswer(false), cores);
  const std::string echoing = local ? address : "127.0.0.1:" + std::to_string(echo.port());
  for (const bool streaming : {true, false}) {
    const char* kind = streaming ? "streams" : "unary";
    const Load floor = loadOf(hosts, echoing, streaming, options);
    std::printf("bare gRPC, %-11s %10.0f calls/s %31.1f us of a core\n", kind, floor.rate,
                floor.us);
    const Load served = loadOf(hosts, server.rpc.address(), streaming, options);
    std::printf("%-22s %10.0f calls/s, %3.0f %% of evaluation; %8.1f us of a core\n", kind,
                served.rate, 100.0 * served.rate / bare, served.us);
    // A service that added nothing would take the two together for a call.
    std::printf("%-22s %17.0f %% of evaluation, of which this is %.0f %%\n", "  at most attainable",
                100.0 * evaluation / (evaluation + floor.us),
                100.0 * (evaluation + floor.us) / served.us);
  }
}

Options optionsOf(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const char* value = i + 1 < argc ? argv[i + 1] : "0";
    if (word == "--clients")
      options.clients = std::atoi(value), ++i;
    else if (word == "--ahead")
      options.ahead = std::atoi(value), ++i;
    else if (word == "--seconds")
      options.seconds = std::atof(value), ++i;
    else if (word == "--server-cores")
      options.serverCores = std::atoi(value), ++i;
    else if (word == "--listen")
      options.listen = std::max(1, std::atoi(value)), ++i;
    else
      options.rounds = std::max(1, std::atoi(word.c_str()));
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = optionsOf(argc, argv);
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  int toHosts[2], fromHosts[2];
  if (pipe(toHosts) != 0 || pipe(fromHosts) != 0) return 1;
  if (options.serverCores < 0 || options.serverCores >= rpc::coreCount()) {
    std::fprintf(stderr, "--server-cores: must leave the hosts some of %d\n", rpc::coreCount());
    return 2;
  }
  rpc::prepareRpcProcess();
  // Before gRPC has threads.
  const pid_t child = fork();
  if (child == 0) {
    close(toHosts[1]);
    close(fromHosts[0]);
    if (options.serverCores > 0) stayOn(options.serverCores, rpc::coreCount());
    serveAsHosts(toHosts[0], fromHosts[1]);
    std::_Exit(0);
  }
  close(toHosts[0]);
  close(fromHosts[1]);
  const Hosts hosts{fromHosts[0], toHosts[1]};
  if (options.serverCores > 0) stayOn(0, options.serverCores);
  for (const std::string& address : {path, std::string("127.0.0.1:0")}) {
    Server server(address, options.listen);
    printOneHost(server, hosts, options.rounds, false);
    printOneHost(server, hosts, options.rounds, true);
    printManyHosts(server, hosts, options);
  }
  close(toHosts[1]);
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}
