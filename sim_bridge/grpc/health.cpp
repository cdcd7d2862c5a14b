#include <algorithm>

#include "grpc/health/v1/health.grpc.pb.h"
#include "sim_bridge/grpc/feed_method.h"
#include "sim_bridge/grpc/standard_services.h"

namespace seaway::bridge::rpc {
namespace {

using grpc::health::v1::Health;
using grpc::health::v1::HealthCheckRequest;
using grpc::health::v1::HealthCheckResponse;
using RawHealth = Health::WithRawMethod_Check<Health::WithRawMethod_Watch<Health::Service>>;

/// What Check and Watch share.
class HealthAnswerer {
 public:
  using Request = HealthCheckRequest;
  using Response = HealthCheckResponse;
  static constexpr bool isForAnybody = true;
  explicit HealthAnswerer(RpcServer& server) : server_(&server) {}
  Lane lane(const Request&) const { return Lane::here; }

 protected:
  bool isEnding() const { return server_->host().ending; }

  HealthCheckResponse::ServingStatus statusOf(const std::string& service) const {
    const std::vector<std::string>& names = server_->serviceNames();
    if (!service.empty() && std::find(names.begin(), names.end(), service) == names.end()) {
      return HealthCheckResponse::SERVICE_UNKNOWN;
    }
    return isEnding() ? HealthCheckResponse::NOT_SERVING : HealthCheckResponse::SERVING;
  }

 private:
  RpcServer* server_;
};

class CheckAnswerer : public HealthAnswerer {
 public:
  using HealthAnswerer::HealthAnswerer;
  Outcome answer(const Request& request, Response& response, const CallWatch&) {
    response.set_status(statusOf(request.service()));
    if (response.status() != HealthCheckResponse::SERVICE_UNKNOWN) return {};
    throw RpcFault(grpc::StatusCode::NOT_FOUND, Refusal::notFound,
                   "service: there is no '" + request.service() + "'");
  }
  void ended() {}
};

class WatchAnswerer : public HealthAnswerer {
 public:
  using HealthAnswerer::HealthAnswerer;
  Outcome answer(const Request& request, Response& response, const CallWatch&) {
    // Looked at first: a service that ends after this is told of when asked again.
    const bool ending = isEnding();
    response.set_status(statusOf(request.service()));
    if (told_ != response.status()) {
      told_ = response.status();
      return {};
    }
    if (!ending) return {.again = std::chrono::milliseconds(100)};
    throw RpcFault(grpc::StatusCode::UNAVAILABLE, Refusal::failed, "the service is ending");
  }
  void ended() { told_.reset(); }

 private:
  std::optional<HealthCheckResponse::ServingStatus> told_;
};

}  // namespace

void addHealthService(RpcServer& server) {
  auto service = std::make_unique<RawHealth>();
  CallHost& host = server.host();
  server.add(std::make_unique<UnaryMethod<CheckAnswerer>>(
      host,
      [&raw = *service](auto* context, auto* bytes, auto* writer, auto* queue, void* tag) {
        raw.RequestCheck(context, bytes, writer, queue, queue, tag);
      },
      [&server] { return CheckAnswerer(server); }));
  server.add(std::make_unique<FeedMethod<WatchAnswerer>>(
      host,
      [&raw = *service](auto* context, auto* bytes, auto* writer, auto* queue, void* tag) {
        raw.RequestWatch(context, bytes, writer, queue, queue, tag);
      },
      [&server] { return WatchAnswerer(server); }));
  server.add(std::move(service), Health::service_full_name());
}

}  // namespace seaway::bridge::rpc
