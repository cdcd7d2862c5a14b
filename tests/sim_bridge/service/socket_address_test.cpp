#include "sim_bridge/service/socket_address.h"

#include <gtest/gtest.h>

#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

TEST(SocketAddress, IsTheLoopbackUnlessAHostIsNamed) {
  EXPECT_EQ(parseSocketAddress("--cigi", "8004").text(), "127.0.0.1:8004");
  EXPECT_EQ(parseSocketAddress("--cigi", "0.0.0.0:8004").text(), "0.0.0.0:8004");
  EXPECT_EQ(parseSocketAddress("--cigi", "bridge.local:65535").text(), "bridge.local:65535");
  EXPECT_EQ(parseSocketAddress("--cigi", "[::1]:0").text(), "[::1]:0");
  EXPECT_EQ(parseSocketAddress("--cigi", "[::1]:0").host, "::1");
}

TEST(SocketAddress, AnythingElseIsRefusedWithTheOptionAndTheText) {
  for (const char* text : {"", ":", ":8004", "host", "host:", "65536", "-1", "8004 ", "1.5",
                           "::1:8004", "[::1]", "[]:8004", "a:b:8004", "99999999999999999999"}) {
    const std::string fault = test::inputErrorOf([&] { parseSocketAddress("--cigi", text); });
    EXPECT_EQ(fault.rfind("--cigi: '" + std::string(text) + "' is not allowed; ", 0), 0u)
        << text << ": " << fault;
  }
}

}  // namespace
}  // namespace seaway::bridge
