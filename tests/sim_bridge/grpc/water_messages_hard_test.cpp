#include <grpcpp/generic/generic_stub.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/sim_bridge/grpc/raw_host.h"

namespace seaway::bridge {
namespace {

using namespace v1;
using test::Context;
using test::expectServed;
using test::planeRequest;
using test::preface;
using test::RawHost;
using test::ServedWater;

std::string frame(char type, char flags, char stream, const std::string& payload) {
  const auto size = payload.size();
  std::string bytes{static_cast<char>(size >> 16),
                    static_cast<char>(size >> 8),
                    static_cast<char>(size),
                    type,
                    flags,
                    0,
                    0,
                    0,
                    stream};
  return bytes + payload;
}

TEST(WaterGrpcHard, GarbageOnTheWireHarmsNobodyElse) {
  ServedWater water;
  std::mt19937 random(7);
  for (int i = 0; i < 60; ++i) {
    RawHost host(water.server->address());
    std::string bytes(1 + random() % 3000, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    switch (i % 4) {
      case 0:
        host.send(bytes);
        break;
      case 1:
        host.send(preface + bytes);
        break;
      case 2:
        host.send(preface + frame(4, 0, 0, "") + frame(1, 4, 1, bytes.substr(0, 100)));
        break;
      default:
        host.send("GET / HTTP/1.1\r\nHost: x\r\n\r\n");
    }
  }
  expectServed(water);
}

/// Bytes in place of a message, on any method.
grpc::Status callWithBytes(ServedWater& water, const std::string& method,
                           const std::string& bytes) {
  const auto channel = water.channel();
  Context context;
  const grpc::Slice slice(bytes);
  grpc::ByteBuffer request(&slice, 1), response;
  grpc::CompletionQueue queue;
  grpc::GenericStub stub(channel);
  const auto call = stub.PrepareUnaryCall(&context, method, request, &queue);
  call->StartCall();
  grpc::Status status;
  void* tag = nullptr;
  bool ok = false;
  call->Finish(&response, &status, &tag);
  queue.Next(&tag, &ok);
  return status;
}

TEST(WaterGrpcHard, MessagesThatAreNoneAreRefusedAndCountedOnEveryMethod) {
  ServedWater water;
  const std::string bad = "\x1a\xff\xff\xff\x0f";  // a nested message of 32 MB that is not there
  int expected = 0;
  for (const char* method :
       {"Sample", "SampleStream", "SubmitPoses", "Step", "Render", "Describe", "SetSeaState"}) {
    const grpc::Status status =
        callWithBytes(water, std::string("/seaway.v1.Water/") + method, bad);
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT) << method;
    EXPECT_NE(status.error_message().find("the request is no seaway.v1."), std::string::npos);
    EXPECT_EQ(water.refused(Refusal::malformed), static_cast<std::uint64_t>(++expected));
  }
  EXPECT_EQ(callWithBytes(water, "/seaway.v1.Water/Sink", bad).error_code(),
            grpc::StatusCode::UNIMPLEMENTED);
  expectServed(water);
}

TEST(WaterGrpcHard, RandomBytesAsMessagesNeverCrash) {
  ServedWater water;
  std::mt19937 random(11);
  const std::string sound = planeRequest(1.0, 5).SerializeAsString();
  for (int i = 0; i < 300; ++i) {
    std::string bytes = sound;
    for (int k = 0; k < 1 + i % 5; ++k) {
      bytes[random() % bytes.size()] = static_cast<char>(random());
    }
    if (i % 3 == 0) bytes.resize(random() % bytes.size());
    callWithBytes(water, "/seaway.v1.Water/Sample", bytes);
  }
  expectServed(water);
}

// A stream's memory is used again: each answer is a new server's.
TEST(WaterGrpcHard, ARequestIsReadAsIfThereHadBeenNoneBefore) {
  SampleRequest nowhere, geodetic, tolerant = planeRequest(2.0, 7);
  nowhere.set_time_s(1.0);
  nowhere.mutable_plane();
  geodetic.set_time_s(1.0);
  geodetic.mutable_geodetic()->add_latitude_deg(28.878);
  geodetic.mutable_geodetic()->add_longitude_deg(-78.467);
  tolerant.set_tolerance_m(0.1);
  tolerant.set_id(9);
  tolerant.add_quantities(QUANTITY_SLOPE);
  // No trail either, which comes when it has been asked for.
  const std::string sea = test::sceneText({{"run:", "effects: {wake: off, trail: off}\nrun:"}});
  ServedWater water(sea);
  Context context;
  const auto stream = water.stub()->SampleStream(&context);
  for (const SampleRequest& request :
       {planeRequest(1.0, 3000), tolerant, planeRequest(1.0, 5), nowhere, geodetic,
        planeRequest(3.0, 2), tolerant, nowhere, tolerant}) {
    SampleResponse given, expected;
    ASSERT_TRUE(stream->Write(request) && stream->Read(&given));
    ServedWater anew(sea);
    Context once;
    ASSERT_TRUE(anew.stub()->Sample(&once, request, &expected).ok());
    EXPECT_EQ(given.SerializeAsString(), expected.SerializeAsString());
  }
  SampleRequest without;
  without.set_time_s(1.0);
  SampleResponse none;
  stream->Write(without);
  EXPECT_FALSE(stream->Read(&none)) << "the points of before are not this one's";
  EXPECT_EQ(stream->Finish().error_code(), grpc::StatusCode::INVALID_ARGUMENT);
}

TEST(WaterGrpcHard, AMillionPointsAreRefusedWithTheLimit) {
  ServedWater water;
  const SampleRequest request = planeRequest(1.0, 1'000'000);
  Context context;
  SampleResponse response;
  const grpc::Status status = water.stub()->Sample(&context, request, &response);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(status.error_message(),
            "points: 1000000 are not allowed in one request; at most 250000 (--grpc-most-points): "
            "split the batch");
  EXPECT_EQ(water.refused(Refusal::tooLarge), 1u);
  expectServed(water);
}

TEST(WaterGrpcHard, AMessageBeyondTheTransportsLimitIsRefusedToo) {
  rpc::RpcServerOptions options;
  options.mostMessageBytes = 1 << 16;
  ServedWater water(test::wakelessText(), {}, options);
  Context context;
  SampleResponse response;
  const grpc::Status status = water.stub()->Sample(&context, planeRequest(1.0, 50'000), &response);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  expectServed(water);
}

TEST(WaterGrpcHard, CompressedMessagesAreNotUnpacked) {
  ServedWater water;
  const auto stub = water.stub();
  for (const auto algorithm : {GRPC_COMPRESS_GZIP, GRPC_COMPRESS_DEFLATE}) {
    Context context;
    context.set_compression_algorithm(algorithm);
    SampleResponse response;
    EXPECT_EQ(stub->Sample(&context, planeRequest(0.0, 1000), &response).error_code(),
              grpc::StatusCode::UNIMPLEMENTED);
  }
  expectServed(water);
}

TEST(WaterGrpcHard, AMessageSomewhatTooLongIsRefusedWithTheLimitAndCounted) {
  rpc::RpcServerOptions options;
  options.mostMessageBytes = 1 << 16;
  ServedWater water(test::wakelessText(), {}, options);
  Context context;
  SampleResponse response;
  const SampleRequest request = planeRequest(1.0, 5000);  // 16 bytes a point
  const grpc::Status status = water.stub()->Sample(&context, request, &response);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(status.error_message(), "the message has " + std::to_string(request.ByteSizeLong()) +
                                        " bytes; at most 65536 are allowed");
  EXPECT_EQ(water.refused(Refusal::tooLarge), 1u);
  expectServed(water);
}

}  // namespace
}  // namespace seaway::bridge
