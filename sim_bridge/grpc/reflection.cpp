#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>

#include <set>

#include "grpc/reflection/v1alpha/reflection.grpc.pb.h"
#include "sim_bridge/grpc/standard_services.h"

namespace seaway::bridge::rpc {
namespace {

namespace v1alpha = grpc::reflection::v1alpha;
using google::protobuf::DescriptorPool;
using google::protobuf::FileDescriptor;
using v1alpha::ServerReflection;
using RawReflection =
    ServerReflection::WithRawMethod_ServerReflectionInfo<ServerReflection::Service>;

/// A file and then those that it imports, each once.
void addFile(const FileDescriptor& file, std::set<const FileDescriptor*>& added,
             v1alpha::FileDescriptorResponse& files) {
  if (!added.insert(&file).second) return;
  google::protobuf::FileDescriptorProto written;
  file.CopyTo(&written);
  written.SerializeToString(files.add_file_descriptor_proto());
  for (int i = 0; i < file.dependency_count(); ++i) addFile(*file.dependency(i), added, files);
}

class ReflectionAnswerer {
 public:
  using Request = v1alpha::ServerReflectionRequest;
  using Response = v1alpha::ServerReflectionResponse;
  static constexpr bool isForAnybody = true;
  explicit ReflectionAnswerer(RpcServer& server) : server_(&server) {}
  Lane lane(const Request&) const { return Lane::here; }

  Outcome answer(const Request& request, Response& response, const CallWatch&) {
    const DescriptorPool& pool = *DescriptorPool::generated_pool();
    response.set_valid_host(request.host());
    *response.mutable_original_request() = request;
    switch (request.message_request_case()) {
      case Request::kListServices:
        list(*response.mutable_list_services_response());
        break;
      case Request::kFileByFilename: {
        const std::string& name = request.file_by_filename();
        give(pool.FindFileByName(name), "file " + name, response);
        break;
      }
      case Request::kFileContainingSymbol: {
        const std::string& name = request.file_containing_symbol();
        give(pool.FindFileContainingSymbol(name), "symbol " + name, response);
        break;
      }
      default:
        give(nullptr, "extension", response);
    }
    return {};
  }
  void ended() {}

 private:
  void list(v1alpha::ListServiceResponse& listed) const {
    for (const std::string& name : server_->serviceNames()) listed.add_service()->set_name(name);
  }

  static void give(const FileDescriptor* file, const std::string& wanted, Response& response) {
    if (file) {
      std::set<const FileDescriptor*> added;
      return addFile(*file, added, *response.mutable_file_descriptor_response());
    }
    v1alpha::ErrorResponse& error = *response.mutable_error_response();
    error.set_error_code(grpc::StatusCode::NOT_FOUND);
    error.set_error_message("there is no " + wanted);
  }

  RpcServer* server_;
};

}  // namespace

void addReflectionService(RpcServer& server) {
  auto service = std::make_unique<RawReflection>();
  CallHost& host = server.host();
  server.add(std::make_unique<StreamMethod<ReflectionAnswerer>>(
      host,
      [&raw = *service](auto* context, auto* stream, auto* queue, void* tag) {
        raw.RequestServerReflectionInfo(context, stream, queue, queue, tag);
      },
      [&server] { return ReflectionAnswerer(server); }));
  server.add(std::move(service), ServerReflection::service_full_name());
}

}  // namespace seaway::bridge::rpc
