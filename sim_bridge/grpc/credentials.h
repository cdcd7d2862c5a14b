#pragma once

#include <grpcpp/security/server_credentials.h>

#include <memory>
#include <string>

namespace seaway::bridge::rpc {

/// How a service over gRPC is kept from strangers.
struct RpcSecurity {
  std::string certificateFile;  ///< PEM, chain included; empty: no TLS
  std::string keyFile;          ///< PEM
  std::string tokenFile;        ///< whose text calls must carry; empty: none
  bool insecure = false;        ///< serve beyond this machine without them
};

/// What a server is given for them.
struct RpcCredentials {
  std::shared_ptr<grpc::ServerCredentials> server;
  std::string token;
};

/// Reads the files. Throws InputError where one cannot be read or is not what it should be, and
/// where `address` (as rpcAddress gives it) is reached from beyond this machine without TLS and a
/// token, unless that is asked for.
RpcCredentials makeCredentials(const std::string& option, const std::string& address,
                               const RpcSecurity& security);

/// The same for a protocol whose hosts know neither TLS nor tokens.
RpcCredentials makeOpenCredentials(const std::string& option, const std::string& address,
                                   const RpcSecurity& security);

}  // namespace seaway::bridge::rpc
