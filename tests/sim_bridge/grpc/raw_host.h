#pragma once

#include <array>
#include <asio.hpp>
#include <string>

#include "sim_bridge/service/socket_address.h"
#include "tests/sim_bridge/grpc/served_water.h"

namespace seaway::bridge::test {

/// A connection of bytes to a server.
class RawHost {
 public:
  explicit RawHost(const std::string& address) {
    const SocketAddress to = parseSocketAddress("address", address);
    socket_.connect(asio::ip::tcp::endpoint(asio::ip::make_address(to.host), to.port));
  }
  void send(const std::string& bytes) {
    asio::error_code ignored;
    asio::write(socket_, asio::buffer(bytes), ignored);
  }
  /// What comes until the server closes, or a first piece.
  std::size_t receive() {
    std::array<char, 4096> bytes;
    asio::error_code ignored;
    return socket_.read_some(asio::buffer(bytes), ignored);
  }

 private:
  asio::io_context io_;
  asio::ip::tcp::socket socket_{io_};
};

/// Whether a well-behaved host gets its answer.
inline void expectServed(ServedWater& water, double t = 1.0) {
  Context context;
  v1::SampleResponse response;
  const grpc::Status status = water.stub()->Sample(&context, planeRequest(t, 10), &response);
  ASSERT_TRUE(status.ok()) << status.error_message();
  EXPECT_EQ(response.height_m_size(), 10);
}

/// How a connection of HTTP/2 begins.
inline const std::string preface = "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n";

}  // namespace seaway::bridge::test
