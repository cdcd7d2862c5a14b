#include "sim_bridge/grpc/credentials.h"

#include <fstream>
#include <iterator>

#include "sim_bridge/grpc/address_fault.h"
#include "surface/input_error.h"

namespace seaway::bridge::rpc {
namespace {

std::string readFile(const std::string& option, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file || text.empty()) {
    throw InputError(option + ": '" + path + "' cannot be read, or is empty");
  }
  return text;
}

std::string readPem(const std::string& option, const std::string& path, const char* what) {
  std::string text = readFile(option, path);
  const std::string wanted = "-----BEGIN ";
  const std::size_t at = text.find(wanted);
  const std::size_t end = at == std::string::npos ? at : text.find('\n', at);
  if (end == std::string::npos || text.substr(at, end - at).find(what) == std::string::npos) {
    throw InputError(option + ": '" + path + "' is no PEM file with a " + what);
  }
  return text;
}

std::string readToken(const std::string& path) {
  const std::string text = readFile("--grpc-token-file", path);
  const char* space = " \t\r\n";
  const std::size_t from = text.find_first_not_of(space);
  const std::size_t to = text.find_last_not_of(space);
  constexpr std::size_t shortest = 16;
  const std::string token = from == std::string::npos ? "" : text.substr(from, to - from + 1);
  if (token.size() < shortest || token.find_first_of(space) != std::string::npos) {
    throw InputError("--grpc-token-file: '" + path +
                     "' must hold one word of at least 16 characters, and holds " +
                     std::to_string(token.size()));
  }
  return token;
}

std::shared_ptr<grpc::ServerCredentials> tls(const RpcSecurity& security) {
  grpc::SslServerCredentialsOptions options;
  options.pem_key_cert_pairs.push_back(
      {readPem("--grpc-tls-key", security.keyFile, "PRIVATE KEY"),
       readPem("--grpc-tls-cert", security.certificateFile, "CERTIFICATE")});
  return grpc::SslServerCredentials(options);
}

}  // namespace

RpcCredentials makeCredentials(const std::string& option, const std::string& address,
                               const RpcSecurity& security) {
  if (security.certificateFile.empty() != security.keyFile.empty()) {
    throw InputError("--grpc-tls-cert, --grpc-tls-key: one is given without the other");
  }
  const bool encrypted = !security.certificateFile.empty();
  RpcCredentials made;
  if (!security.tokenFile.empty()) made.token = readToken(security.tokenFile);
  if (!isLocal(address) && !security.insecure && (!encrypted || made.token.empty())) {
    throw InputError(option + ": '" + address +
                     "' is reached from other machines; needs --grpc-tls-cert, --grpc-tls-key and "
                     "--grpc-token-file, or --grpc-insecure to let anybody in");
  }
  made.server = encrypted ? tls(security) : grpc::InsecureServerCredentials();
  return made;
}

RpcCredentials makeOpenCredentials(const std::string& option, const std::string& address,
                                   const RpcSecurity& security) {
  if (!isLocal(address) && !security.insecure) {
    throw InputError(option + ": '" + address +
                     "' is reached from other machines, and xdyn knows neither TLS nor tokens; "
                     "needs --grpc-insecure to let anybody in");
  }
  return {grpc::InsecureServerCredentials(), ""};
}

}  // namespace seaway::bridge::rpc
