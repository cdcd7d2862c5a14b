#include "sim_bridge/grpc/standard_services.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <gtest/gtest.h>

#include "grpc/health/v1/health.grpc.pb.h"
#include "grpc/reflection/v1alpha/reflection.grpc.pb.h"
#include "tests/sim_bridge/grpc/served_water.h"

namespace seaway::bridge {
namespace {

using grpc::health::v1::Health;
using grpc::health::v1::HealthCheckRequest;
using grpc::health::v1::HealthCheckResponse;
using grpc::reflection::v1alpha::ServerReflection;
using grpc::reflection::v1alpha::ServerReflectionRequest;
using grpc::reflection::v1alpha::ServerReflectionResponse;
using test::Context;
using test::ServedWater;

// What hosts without a token meet where one is asked for.
struct Guarded : ServedWater {
  Guarded() : ServedWater(test::wakelessText(), {}, {.token = "secret"}) {}

  grpc::StatusCode check(const std::string& service, HealthCheckResponse& response) const {
    Context context;
    HealthCheckRequest request;
    request.set_service(service);
    return Health::NewStub(channel())->Check(&context, request, &response).error_code();
  }
  std::uint64_t counted() {
    const MeterCounts counts = meter().read();
    std::uint64_t all = counts.requests.total();
    for (const std::uint64_t refusals : counts.refusals) all += refusals;
    return all;
  }
};

TEST(StandardServices, CheckKnowsTheServicesThereAreAndNeedsNoToken) {
  Guarded water;
  HealthCheckResponse response;
  for (const char* service : {"", "seaway.v1.Water", "grpc.health.v1.Health"}) {
    EXPECT_EQ(water.check(service, response), grpc::StatusCode::OK) << service;
    EXPECT_EQ(response.status(), HealthCheckResponse::SERVING) << service;
  }
  EXPECT_EQ(water.check("none", response), grpc::StatusCode::NOT_FOUND);
  EXPECT_EQ(water.counted(), 0u);
}

TEST(StandardServices, WatchTellsAtOnceAndAgainWhenTheServerEnds) {
  Guarded water;
  const auto stub = Health::NewStub(water.channel());
  Context context;
  const auto watch = stub->Watch(&context, HealthCheckRequest());
  HealthCheckResponse response;
  ASSERT_TRUE(watch->Read(&response));
  EXPECT_EQ(response.status(), HealthCheckResponse::SERVING);
  water.server->stop();
  ASSERT_TRUE(watch->Read(&response));
  EXPECT_EQ(response.status(), HealthCheckResponse::NOT_SERVING);
  EXPECT_FALSE(watch->Read(&response));
  EXPECT_EQ(watch->Finish().error_code(), grpc::StatusCode::UNAVAILABLE);
}

TEST(StandardServices, AWatchOfNoServiceStaysUntilItIsCancelled) {
  Guarded water;
  const auto stub = Health::NewStub(water.channel());
  // More of them than slots listen, so that slots are used again.
  for (int i = 0; i < 40; ++i) {
    Context context;
    HealthCheckRequest request;
    request.set_service("none");
    const auto watch = stub->Watch(&context, request);
    HealthCheckResponse response;
    ASSERT_TRUE(watch->Read(&response));
    EXPECT_EQ(response.status(), HealthCheckResponse::SERVICE_UNKNOWN);
    context.TryCancel();
    EXPECT_EQ(watch->Finish().error_code(), grpc::StatusCode::CANCELLED);
  }
  EXPECT_EQ(water.counted(), 0u);
}

ServerReflectionResponse reflect(const ServedWater& water, const ServerReflectionRequest& request) {
  Context context;
  const auto stub = ServerReflection::NewStub(water.channel());
  const auto stream = stub->ServerReflectionInfo(&context);
  ServerReflectionResponse response;
  EXPECT_TRUE(stream->Write(request));
  EXPECT_TRUE(stream->Read(&response));
  EXPECT_TRUE(stream->WritesDone());
  EXPECT_TRUE(stream->Finish().ok());
  return response;
}

TEST(StandardServices, ReflectionListsTheServices) {
  Guarded water;
  ServerReflectionRequest request;
  request.set_list_services("*");
  const ServerReflectionResponse response = reflect(water, request);
  std::vector<std::string> names;
  for (const auto& service : response.list_services_response().service()) {
    names.push_back(service.name());
  }
  EXPECT_EQ(names, (std::vector<std::string>{"seaway.v1.Water", "grpc.health.v1.Health",
                                             "grpc.reflection.v1alpha.ServerReflection"}));
  EXPECT_EQ(water.counted(), 0u);
}

TEST(StandardServices, ReflectionsFilesAreEnoughToBuildWhatIsAskedFor) {
  Guarded water;
  ServerReflectionRequest bySymbol, byName;
  bySymbol.set_file_containing_symbol("grpc.health.v1.Health.Watch");
  byName.set_file_by_filename("seaway/v1/water.proto");
  for (const ServerReflectionRequest& request : {bySymbol, byName}) {
    const ServerReflectionResponse response = reflect(water, request);
    const auto& files = response.file_descriptor_response().file_descriptor_proto();
    ASSERT_FALSE(files.empty());
    google::protobuf::DescriptorPool pool;
    for (int i = files.size() - 1; i >= 0; --i) {  // what is imported comes after
      google::protobuf::FileDescriptorProto file;
      ASSERT_TRUE(file.ParseFromString(files[i]));
      EXPECT_NE(pool.BuildFile(file), nullptr) << file.name();
    }
    const bool isHealth = request.has_file_containing_symbol();
    EXPECT_NE(pool.FindServiceByName(isHealth ? "grpc.health.v1.Health" : "seaway.v1.Water"),
              nullptr);
  }
}

TEST(StandardServices, ReflectionSaysWhatItDoesNotHave) {
  Guarded water;
  ServerReflectionRequest noSymbol, noFile, nothing;
  noSymbol.set_file_containing_symbol("seaway.v1.Fire");
  noFile.set_file_by_filename("fire.proto");
  for (const ServerReflectionRequest& request : {noSymbol, noFile, nothing}) {
    const ServerReflectionResponse response = reflect(water, request);
    EXPECT_EQ(response.error_response().error_code(), grpc::StatusCode::NOT_FOUND);
  }
}

}  // namespace
}  // namespace seaway::bridge
