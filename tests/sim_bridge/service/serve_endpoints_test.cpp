#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>
#include <httplib.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <thread>

#include "seaway/v1/water.grpc.pb.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "sim_bridge/shm/seaway_shm.hpp"
#include "tests/sim_bridge/service/served_child.h"
#include "tests/sim_bridge/service/served_waters.h"
#include "tests/sim_bridge/test_support.h"

// `seaway serve` with all its doors open and hosts at each of them, as they are when it is told to
// end and when its scene changes.
namespace seaway::bridge {
namespace {

using Clock = std::chrono::steady_clock;
using test::TempFolder;

constexpr int points = 40;
constexpr double time = 2.5;
constexpr auto hangs = std::chrono::seconds(60);

const std::pair<std::string, std::string> wakeless{"run:", "effects: {wake: off}\nrun:"};

std::vector<double> xs() {
  std::vector<double> all;
  for (int i = 0; i < points; ++i) all.push_back(13.0 * i);
  return all;
}
std::vector<double> ys() { return std::vector<double>(points, -7.0); }

/// What the library says of a scene's file.
std::vector<double> truthOf(const std::string& file) {
  const Sea sea = buildSea(loadScene(file));
  std::vector<double> heights;
  for (const double x : xs()) heights.push_back(sea.surface.sample({x, -7.0}, time).height);
  return heights;
}

/// The service and its hosts, each on a thread, who call until they are told to end or the service
/// says that it has gone. Whatever is answered is checked.
class Besieged {
 public:
  using Check = std::function<bool(const std::vector<double>&)>;

  Besieged(const std::string& file, Check isRight) : isRight_(std::move(isRight)) {
    name_ = "seaway-endpoints-" + std::to_string(getpid());
    child_ = std::make_unique<test::ServedChild>(
        file, std::vector<std::string>{"--grpc", "0", "--shm", name_, "--metrics", "0"}, 3);
    const SocketAddress grpc = child_->address("gRPC at "), http = child_->address("http://");
    for (int i = 0; i < 2; ++i) {
      run([this, grpc] { callUnary(grpc); });
      run([this, grpc] { callOnAStream(grpc); });
      run([this] { callThroughMemory(); });
      run([this, http, i] { readPages(http, i == 0 ? "/metrics" : "/status.json"); });
    }
    run([this, http] { readPages(http, "/"); });
    run([this, http] { readPages(http, "/camera/bow.png?t=1&size=32x24"); });
  }
  ~Besieged() { stopHosts(); }

  test::ServedChild& child() { return *child_; }
  void stopHosts() {
    ending_ = true;
    for (std::thread& host : hosts_) host.join();
    hosts_.clear();
  }
  /// Until each host has been answered so often more.
  bool awaitAnswers(int more) {
    std::vector<long> from;
    for (const auto& each : answered_) from.push_back(*each);
    const auto end = Clock::now() + hangs;
    for (std::size_t i = 0; i < from.size(); ++i) {
      while (*answered_[i] < from[i] + more) {
        if (Clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
      }
    }
    return true;
  }
  std::atomic<int> wrong{0}, refusedOddly{0};

 private:
  void run(std::function<void()> calls) {
    answered_.push_back(std::make_unique<std::atomic<long>>(0));
    std::atomic<long>* mine = answered_.back().get();
    hosts_.emplace_back([calls = std::move(calls), mine] {
      counter_ = mine;
      calls();
    });
  }
  void check(std::vector<double> heights) {
    if (heights.size() != points || !isRight_(heights)) ++wrong;
    ++*counter_;
  }
  static v1::SampleRequest request() {
    v1::SampleRequest made;
    made.set_time_s(time);
    const auto x = xs(), y = ys();
    made.mutable_plane()->mutable_x_m()->Add(x.begin(), x.end());
    made.mutable_plane()->mutable_y_m()->Add(y.begin(), y.end());
    return made;
  }
  static std::unique_ptr<v1::Water::Stub> stubAt(const SocketAddress& address) {
    grpc::ChannelArguments arguments;
    arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
    return v1::Water::NewStub(
        grpc::CreateCustomChannel(address.text(), grpc::InsecureChannelCredentials(), arguments));
  }
  void expectGone(const grpc::Status& status) {
    const bool gone = status.error_code() == grpc::StatusCode::UNAVAILABLE ||
                      status.error_code() == grpc::StatusCode::CANCELLED;
    if (!gone) ++refusedOddly;
  }
  void callUnary(const SocketAddress& address) {
    const auto stub = stubAt(address);
    while (!ending_) {
      grpc::ClientContext context;
      context.set_deadline(std::chrono::system_clock::now() + hangs);
      v1::SampleResponse response;
      const grpc::Status status = stub->Sample(&context, request(), &response);
      if (!status.ok()) return expectGone(status);
      check({response.height_m().begin(), response.height_m().end()});
    }
  }
  void callOnAStream(const SocketAddress& address) {
    const auto stub = stubAt(address);
    grpc::ClientContext context;
    const auto stream = stub->SampleStream(&context);
    v1::SampleResponse response;
    while (!ending_) {
      if (!stream->Write(request()) || !stream->Read(&response)) {
        return expectGone(stream->Finish());
      }
      check({response.height_m().begin(), response.height_m().end()});
    }
    context.TryCancel();
    stream->Finish();
  }
  void callThroughMemory() {
    seaway_shm_options options = seaway_shm_default_options();
    options.connect_timeout = options.call_timeout = 60.0;
    const auto x = xs(), y = ys();
    try {
      seaway::shm::Client host(name_, options);
      while (!ending_) {
        const auto heights = host.sample(x, y, {.time = time}).height;
        check({heights.begin(), heights.end()});
      }
    } catch (const seaway::shm::Error& error) {
      if (error.status() != SEAWAY_SHM_SERVER_GONE) ++refusedOddly;
    }
  }
  void readPages(const SocketAddress& address, const std::string& page) {
    while (!ending_) {
      httplib::Client client(address.host, address.port);
      client.set_read_timeout(60);
      const auto answer = client.Get(page);
      if (!answer) return;  // gone
      // A page in the middle of which the service ended would lack bytes: then there is no answer.
      if (answer->status != 200 || answer->body.empty()) {
        if (answer->status != 500) ++refusedOddly;  // 500: a picture that is not drawn any more
        continue;
      }
      ++*counter_;
    }
  }

  Check isRight_;
  std::string name_;
  std::unique_ptr<test::ServedChild> child_;
  std::atomic<bool> ending_{false};
  std::vector<std::unique_ptr<std::atomic<long>>> answered_;
  std::vector<std::thread> hosts_;
  static thread_local std::atomic<long>* counter_;
};
thread_local std::atomic<long>* Besieged::counter_ = nullptr;

TEST(ServeEndpointsHard, TerminatedUnderLoadOfAllItEndsWithZeroAndAnswersWholeOrNotAtAll) {
  const TempFolder folder;
  const std::string file = test::writeScene(folder, {wakeless}).string();
  const auto truth = truthOf(file);
  Besieged besieged(file, [&](const auto& heights) { return heights == truth; });
  EXPECT_TRUE(besieged.awaitAnswers(20)) << besieged.child().text();
  const auto begun = Clock::now();
  EXPECT_EQ(besieged.child().end(SIGTERM), 0) << besieged.child().text();
  // Half a second for calls under way and a picture: so much longer that something hangs.
  EXPECT_LT(Clock::now() - begun, std::chrono::seconds(20));
  besieged.stopHosts();
  EXPECT_EQ(besieged.wrong, 0);
  EXPECT_EQ(besieged.refusedOddly, 0);
}

// Nobody asks for anything but the status.
TEST(ServeEndpoints, FreeVesselsSailAlongWithAClockOfTheServicesOwn) {
  const TempFolder folder;
  folder.write("launch.yaml", test::vesselText());
  folder.write("driven.yaml", test::drivenVessel);
  const std::string file = folder.write("scene.yaml", test::freeScene()).string();
  test::ServedChild child(file, {"--metrics", "0", "--clock", "x8"});
  const SocketAddress http = child.address("http://");
  const auto north = [&] {
    httplib::Client client(http.host, http.port);
    const auto answer = client.Get("/status.json");
    return answer ? nlohmann::json::parse(answer->body)["vessels"][0]["latitude_deg"].get<double>()
                  : 0.0;
  };
  // At 4 m/s 20 m take less than a second of ours; 0.0001 degrees are 11 m.
  const auto end = Clock::now() + hangs;
  while (north() < 0.00018 && Clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_GE(north(), 0.00018);
  EXPECT_EQ(child.end(SIGTERM), 0) << child.text();
}

int logErrors(test::ServedChild& child) {
  const SocketAddress http = child.address("http://");
  httplib::Client client(http.host, http.port);
  const auto text = client.Get("/metrics");
  const std::string word = "\nseaway_log_messages_total{level=\"error\"} ";
  const std::size_t at = text ? text->body.find(word) : std::string::npos;
  return at == std::string::npos ? -1 : std::stoi(text->body.substr(at + word.size()));
}

TEST(ServeEndpointsHard, AReloadUnderLoadGivesEachHostTheOldSeaOrTheNewOneWhole) {
  const TempFolder folder;
  const std::string file = test::writeScene(folder, {wakeless}).string();
  const auto low = truthOf(file);
  const std::pair<std::string, std::string> higher{"hm0_m: 1.12", "hm0_m: 2.24"};
  folder.write("scene.yaml", test::sceneText({wakeless, higher}));
  const auto high = truthOf(file);
  ASSERT_NE(low, high);
  folder.write("scene.yaml", test::sceneText({wakeless}));
  // Which seas may be met now: bit 0 the low one, bit 1 the high one.
  std::atomic<int> served{1};
  Besieged besieged(file, [&](const auto& heights) {
    const int now = served;
    return ((now & 1) != 0 && heights == low) || ((now & 2) != 0 && heights == high);
  });
  test::ServedChild& child = besieged.child();
  EXPECT_TRUE(besieged.awaitAnswers(5));

  const int errors = logErrors(child);
  EXPECT_GE(errors, 0);
  folder.write("scene.yaml", test::sceneText({wakeless, {"hm0_m: 1.12", "hm0_m: -1"}}));
  child.send(SIGHUP);
  child.awaitText("the scene stays as it was");
  EXPECT_TRUE(besieged.awaitAnswers(5));
  EXPECT_EQ(logErrors(child), errors + 1);
  EXPECT_EQ(besieged.wrong, 0) << "a bad scene changes nothing";

  for (int round = 0; round < 4; ++round) {
    const bool isHigh = round % 2 == 0;
    folder.write("scene.yaml",
                 isHigh ? test::sceneText({wakeless, higher}) : test::sceneText({wakeless}));
    served = 3;
    child.send(SIGHUP);
    child.awaitText("is loaded anew");
    // Answers that were under way then are checked before the other sea is ruled out.
    EXPECT_TRUE(besieged.awaitAnswers(3));
    served = isHigh ? 2 : 1;
    EXPECT_TRUE(besieged.awaitAnswers(5));
  }
  EXPECT_EQ(besieged.wrong, 0);
  EXPECT_EQ(besieged.refusedOddly, 0);
  besieged.stopHosts();
  EXPECT_EQ(child.end(SIGTERM), 0);
}

}  // namespace
}  // namespace seaway::bridge
