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
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "seaway/v1/water.grpc.pb.h"
#include "sim_bridge/grpc/rpc_server.h"
#include "sim_bridge/grpc/water_service.h"
#include "sim_bridge/scene/sea.h"
#include "tests/bench/grpc_echo.h"

// What gRPC adds to the evaluation of 1000 points on 12 octaves.
//   grpc_bench [ROUNDS] [--clients N] [--seconds S] [--server-cores N]
// Beside it, what the bare library takes to answer as many bytes and to answer none: the floor.
// On a unix socket and on the loopback, from hosts in a process of their own. First one host: kinds
// of call in turn with the bare evaluation, so that each has the machine as the others have it.
// Then N hosts at once: calls a second beside the same evaluation without gRPC on as many cores,
// and what of the processors the server takes for a call. With --server-cores the server has the
// first N cores, its hosts the others.
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

[[noreturn]] void fail(const char* what) {
  std::fprintf(stderr, "%s\n", what);
  std::_Exit(1);
}

double secondsSince(Clock::time_point begun) {
  return std::chrono::duration<double>(Clock::now() - begun).count();
}

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

v1::SampleRequest request(bool all, std::size_t count = points) {
  v1::SampleRequest made;
  for (std::size_t i = 0; i < count; ++i) {
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

/// A sea behind an address.
struct Server {
  explicit Server(const std::string& address)
      : rpc({.option = "grpc_bench",
             .address = address,
             .credentials = grpc::InsecureServerCredentials(),
             .token = ""},
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

std::unique_ptr<v1::Water::Stub> stubOf(const std::string& address) {
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  return v1::Water::NewStub(
      grpc::CreateCustomChannel(address, grpc::InsecureChannelCredentials(), arguments));
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
      if (!stream_->Write(asked) || !stream_->Read(&response_)) {
        fail(stream_->Finish().error_message().c_str());
      }
      return;
    }
    // One queue for all calls: the blocking call makes one each time.
    grpc::ClientContext context;
    const auto call = stub_->AsyncSample(&context, asked, &queue_);
    grpc::Status status;
    call->Finish(&response_, &status, this);
    void* tag = nullptr;
    bool ok = false;
    if (!queue_.Next(&tag, &ok) || !status.ok()) fail(status.error_message().c_str());
  }

 private:
  std::unique_ptr<v1::Water::Stub> stub_;
  grpc::CompletionQueue queue_;
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

/// Runs `work` on so many threads for a while; times that it was done, a second.
double rateOf(int threads, double seconds,
              const std::function<void(std::atomic<bool>&, std::atomic<long>&)>& work) {
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

/// What the hosts' process is asked to do.
struct Order {
  char address[128] = {};
  int clients = 1;
  int calls = 0;  // of one host, each timed; 0: as many as go in `seconds`
  double seconds = 0.0;
  bool streaming = false, all = false;
  std::size_t count = points;
};

template <class Values>
void sendAll(int to, const Values* values, std::size_t count) {
  const char* bytes = reinterpret_cast<const char*>(values);
  for (std::size_t left = sizeof(Values) * count; left > 0;) {
    const ssize_t sent = write(to, bytes, left);
    if (sent <= 0) std::_Exit(1);
    bytes += sent;
    left -= static_cast<std::size_t>(sent);
  }
}

template <class Values>
bool receiveAll(int from, Values* values, std::size_t count) {
  char* bytes = reinterpret_cast<char*>(values);
  for (std::size_t left = sizeof(Values) * count; left > 0;) {
    const ssize_t got = read(from, bytes, left);
    if (got <= 0) return false;
    bytes += got;
    left -= static_cast<std::size_t>(got);
  }
  return true;
}

/// The hosts' process: obeys until the pipe is closed; answers with times in us, or a rate.
void serveAsHosts(int in, int out) {
  std::map<std::string, std::unique_ptr<Host>> hosts;  // those whose calls are timed
  for (Order order; receiveAll(in, &order, 1);) {
    v1::SampleRequest asked = request(order.all, order.count);
    if (order.calls > 0) {
      std::unique_ptr<Host>& host = hosts[order.address + std::to_string(order.streaming)];
      if (!host) host = std::make_unique<Host>(order.address, order.streaming);
      std::vector<double> us;
      for (int i = 0; i < order.calls; ++i) {
        asked.set_time_s(0.01 * i);
        const auto begun = Clock::now();
        host->ask(asked);
        us.push_back(1e6 * secondsSince(begun));
      }
      sendAll(out, us.data(), us.size());
      continue;
    }
    hosts.clear();
    const double rate = rateOf(order.clients, order.seconds, [&](auto& ending, auto& done) {
      Host host(order.address, order.streaming);
      while (!ending) {
        host.ask(asked);
        ++done;
      }
    });
    sendAll(out, &rate, 1);
  }
}

/// The other end of it.
struct Hosts {
  int in, out;

  std::vector<double> timed(const std::string& address, bool streaming, bool all, std::size_t count,
                            int calls) {
    Order order{.calls = calls, .streaming = streaming, .all = all, .count = count};
    std::snprintf(order.address, sizeof order.address, "%s", address.c_str());
    sendAll(out, &order, 1);
    std::vector<double> us(static_cast<std::size_t>(calls));
    if (!receiveAll(in, us.data(), us.size())) fail("no hosts");
    return us;
  }
  double rate(const std::string& address, bool streaming, const Options& options) {
    Order order{.clients = options.clients, .seconds = options.seconds, .streaming = streaming};
    std::snprintf(order.address, sizeof order.address, "%s", address.c_str());
    sendAll(out, &order, 1);
    double rate = 0.0;
    if (!receiveAll(in, &rate, 1)) fail("no hosts");
    return rate;
  }
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

void printManyHosts(Server& server, Hosts hosts, const Options& options) {
  const int cores = rpc::coreCount();
  const double bare = rateOf(cores, options.seconds, [&](auto& ending, auto& done) {
    Evaluation evaluation(server.sea, false);
    while (!ending) {
      evaluation.run(1.0);
      ++done;
    }
  });
  std::printf("%d hosts at once, server on %d cores, hosts on %s\n", options.clients, cores,
              options.serverCores > 0 ? "others" : "the same");
  std::printf("%-22s %10.0f calls/s %31.1f us of a core\n", "evaluation", bare, 1e6 * cores / bare);
  for (const bool streaming : {true, false}) {
    const double before = processorSeconds();
    const auto begun = Clock::now();
    const double rate = hosts.rate(server.rpc.address(), streaming, options);
    const double each = (processorSeconds() - before) / (rate * secondsSince(begun));
    std::printf("%-22s %10.0f calls/s, %3.0f %% of evaluation; %8.1f us of a core\n",
                streaming ? "streams" : "unary", rate, 100.0 * rate / bare, 1e6 * each);
  }
}

Options optionsOf(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const char* value = i + 1 < argc ? argv[i + 1] : "0";
    if (word == "--clients")
      options.clients = std::atoi(value), ++i;
    else if (word == "--seconds")
      options.seconds = std::atof(value), ++i;
    else if (word == "--server-cores")
      options.serverCores = std::atoi(value), ++i;
    else
      options.rounds = std::max(1, std::atoi(word.c_str()));
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = optionsOf(argc, argv);
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
    Server server(address);
    printOneHost(server, hosts, options.rounds, false);
    printOneHost(server, hosts, options.rounds, true);
    printManyHosts(server, hosts, options);
  }
  close(toHosts[1]);
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}
