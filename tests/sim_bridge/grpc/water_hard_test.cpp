#include <gtest/gtest.h>

#include <asio.hpp>
#include <thread>

#include "sim_bridge/grpc/address_fault.h"
#include "sim_bridge/grpc/point_sampler.h"
#include "surface/input_error.h"
#include "tests/sim_bridge/grpc/raw_host.h"

namespace seaway::bridge {
namespace {

using namespace v1;
using asio::ip::tcp;
using test::Context;
using test::eventually;
using test::expectServed;
using test::planeRequest;
using test::preface;
using test::RawHost;
using test::ServedWater;

TEST(WaterGrpcHard, ADeadlineEndsALargeBatchBetweenItsPieces) {
  rpc::WaterLimits limits;
  limits.points = 2'000'000;
  ServedWater water(test::wakelessText(), limits);
  // A quarter of a second of work and more, of which 2 ms are allowed once it has begun.
  const SampleRequest request = planeRequest(1.0, 2'000'000);
  rpc::PointSampler sampler(water.host);
  rpc::CallWatch watch;
  watch.renew();
  watch.setDeadline(std::chrono::system_clock::now() + std::chrono::milliseconds(2));
  SampleResponse response;
  EXPECT_THROW(sampler.sample(request, response, watch), rpc::RpcFault);
  // And over the wire, where it may pass before all of the request has come.
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + std::chrono::milliseconds(40));
  const grpc::Status status = water.stub()->Sample(&context, request, &response);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::DEADLINE_EXCEEDED);
  expectServed(water);
}

TEST(WaterGrpcHard, ACancelledCallFreesItsWorkAndAHostThatIsKilledLosesItsHulls) {
  ServedWater water;
  const std::string vessel = water.waters.scene.vessels[0].name;
  for (int i = 0; i < 20; ++i) {
    const auto stub = water.stub();
    Context poses, samples;
    const auto placed = stub->SubmitPoses(&poses);
    PosesRequest request;
    request.set_time_s(1.0);
    request.add_hulls()->set_name("mine");
    request.mutable_hulls(0)->set_vessel(vessel);
    PosesResponse response;
    const GeodeticPosition anchor = water.waters.sea.geodesy().anchor();
    request.mutable_hulls(0)->set_latitude_deg(anchor.latitude_deg);
    request.mutable_hulls(0)->set_longitude_deg(anchor.longitude_deg);
    ASSERT_TRUE(placed->Write(request) && placed->Read(&response));
    const auto stream = stub->SampleStream(&samples);
    stream->Write(planeRequest(1.0, 200'000));
    poses.TryCancel();
    samples.TryCancel();
    placed->Finish();
    stream->Finish();
  }
  EXPECT_TRUE(eventually([&] { return water.host.hulls.size() == 0; }));
  expectServed(water);
}

TEST(WaterGrpcHard, AThousandHostsComeAndGo) {
  ServedWater water;
  for (int i = 0; i < 1000; ++i) {
    if (i % 2) {
      RawHost host(water.server->address());
      host.send(preface);
    } else {
      expectServed(water, 0.01 * i);
    }
  }
  expectServed(water);
}

/// Passes bytes between a host and a server until it is told to swallow them: then both keep an
/// open connection on which nothing comes any more.
class Relay {
 public:
  explicit Relay(const std::string& server) {
    thread_ = std::thread([this, to = parseSocketAddress("address", server)] {
      tcp::socket host = acceptor_.accept();
      tcp::socket there(io_);
      there.connect(tcp::endpoint(asio::ip::make_address(to.host), to.port));
      host.non_blocking(true);
      there.non_blocking(true);
      std::thread back([&] { pass(there, host); });
      pass(host, there);
      back.join();
    });
  }
  ~Relay() {
    ending_ = true;
    thread_.join();
  }
  std::string address() const {
    return "127.0.0.1:" + std::to_string(acceptor_.local_endpoint().port());
  }
  void swallow() { swallowing_ = true; }

 private:
  void pass(tcp::socket& from, tcp::socket& to) {
    std::array<char, 16384> bytes;
    while (!ending_) {
      asio::error_code fault;
      const std::size_t size = from.read_some(asio::buffer(bytes), fault);
      if (fault == asio::error::would_block || swallowing_) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        continue;
      }
      if (fault) return;
      for (std::size_t sent = 0; sent < size && !ending_;) {
        sent += to.write_some(asio::buffer(bytes.data() + sent, size - sent), fault);
        if (fault == asio::error::would_block) {
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        } else if (fault) {
          return;
        }
      }
    }
  }
  asio::io_context io_;
  tcp::acceptor acceptor_{io_, tcp::endpoint(asio::ip::address_v4::loopback(), 0)};
  std::atomic<bool> swallowing_{false}, ending_{false};
  std::thread thread_;
};

TEST(WaterGrpcHard, HostsBehindHalfOpenConnectionsAreGoneAfterAWhile) {
  rpc::RpcServerOptions options;
  options.patience = 0.3;
  ServedWater water(test::wakelessText(), {}, options);
  RawHost silent(water.server->address());  // connects and says nothing
  Relay relay(water.server->address());
  const auto stub =
      Water::NewStub(grpc::CreateChannel(relay.address(), grpc::InsecureChannelCredentials()));
  Context context;
  const auto stream = stub->SubmitPoses(&context);
  PosesRequest request;
  PosesResponse response;
  request.set_time_s(1.0);
  request.add_hulls()->set_name("mine");
  request.mutable_hulls(0)->set_vessel(water.waters.scene.vessels[0].name);
  ASSERT_TRUE(stream->Write(request) && stream->Read(&response));
  EXPECT_EQ(water.host.hulls.size(), 1u);
  relay.swallow();
  EXPECT_TRUE(eventually([&] { return water.host.hulls.size() == 0; }));
  expectServed(water);
  context.TryCancel();
  stream->Finish();
}

// Nobody reads the answers of some: their streams fill up, and the others do not notice.
TEST(WaterGrpcHard, SlowHostsBlockNobody) {
  ServedWater water;
  constexpr int slow = 32;
  std::vector<std::unique_ptr<Water::Stub>> stubs;
  std::vector<std::unique_ptr<Context>> contexts;
  std::vector<std::unique_ptr<grpc::ClientReaderWriter<SampleRequest, SampleResponse>>> streams;
  const SampleRequest large = planeRequest(1.0, 4000);
  for (int i = 0; i < slow; ++i) {
    stubs.push_back(water.stub());
    contexts.push_back(std::make_unique<Context>());
    streams.push_back(stubs.back()->SampleStream(contexts.back().get()));
    for (int k = 0; k < 3; ++k) streams.back()->Write(large);
  }
  for (int i = 0; i < 50; ++i) expectServed(water, 0.1 * i);
  for (auto& context : contexts) context->TryCancel();
  for (auto& stream : streams) stream->Finish();
}

TEST(WaterGrpcHard, HostsWithClocksApartGetTheSeaOfTheirOwnTime) {
  ServedWater water;
  const auto surface = water.waters.sea.surface();
  std::atomic<int> wrong{0};
  const auto host = [&](double start, double rate) {
    const auto stub = water.stub();
    Context context;
    const auto stream = stub->SampleStream(&context);
    for (int i = 0; i < 200; ++i) {
      const SampleRequest request = planeRequest(start + rate * i, 20);
      SampleResponse response;
      if (!stream->Write(request) || !stream->Read(&response)) ++wrong;
      const auto places = test::placesOf(request);
      for (std::size_t p = 0; p < places.size(); ++p) {
        const double truth = surface->sample(places[p], request.time_s()).height;
        if (response.height_m(static_cast<int>(p)) != truth) ++wrong;
      }
    }
    stream->WritesDone();
    stream->Finish();
  };
  std::thread one(host, 0.0, 0.01), two(host, 1e7, -3.0);
  one.join();
  two.join();
  EXPECT_EQ(wrong, 0);
}

TEST(WaterGrpcHard, StopsUnderLoadAfterAnsweringWhatHadCome) {
  for (int round = 0; round < 5; ++round) {
    ServedWater water;
    std::atomic<bool> ending{false};
    std::atomic<int> answered{0}, other{0};
    std::vector<std::thread> hosts;
    for (int i = 0; i < 8; ++i) {
      hosts.emplace_back([&, i] {
        const auto stub = water.stub();
        const SampleRequest request = planeRequest(1.0, i % 2 ? 500 : 20'000);
        while (!ending) {
          Context context;
          SampleResponse response;
          if (i % 4 < 2) {
            const grpc::Status status = stub->Sample(&context, request, &response);
            status.ok() ? ++answered : ++other;
            if (!status.ok()) {
              EXPECT_TRUE(status.error_code() == grpc::StatusCode::UNAVAILABLE ||
                          status.error_code() == grpc::StatusCode::CANCELLED)
                  << status.error_code() << status.error_message();
            }
          } else {
            const auto stream = stub->SampleStream(&context);
            while (!ending && stream->Write(request) && stream->Read(&response)) ++answered;
            context.TryCancel();
            stream->Finish();
          }
        }
      });
    }
    EXPECT_TRUE(eventually([&] { return answered > 20; }));
    water.server->stop();
    ending = true;
    for (std::thread& host : hosts) host.join();
  }
}

TEST(WaterGrpcHard, ATakenPortOrPathIsToldAndAStaleSocketIsNot) {
  ServedWater water;
  const auto bindMessage = [&](const std::string& address) {
    return test::inputErrorOf([&] {
      ServedWater other(test::wakelessText(), {},
                        {.option = "", .address = address, .credentials = {}, .token = ""});
    });
  };
  const std::string taken = water.server->address();
  EXPECT_EQ(bindMessage(taken), "--grpc: cannot serve at '" + taken + "': Address already in use");
  const test::TempFolder folder;
  const std::string path = "unix:" + (folder / "sea").string();
  {
    ServedWater first(test::wakelessText(), {},
                      {.option = "", .address = path, .credentials = {}, .token = ""});
    expectServed(first);
    EXPECT_NE(bindMessage(path).find("another process serves there"), std::string::npos);
    expectServed(first);
  }
  EXPECT_EQ(bindMessage(path), "");
  const std::string file = folder.write("file", "text").string();
  EXPECT_NE(bindMessage("unix:" + file).find("is no socket"), std::string::npos);
  EXPECT_EQ(test::readFile(file), "text");
}

}  // namespace
}  // namespace seaway::bridge
