#include "watch/host_check.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <string>

namespace riffle::host_check_test {
namespace {

TEST(HostCheck, KnowsLoopbackAddresses) {
    for (const char* address : {"127.0.0.1", "127.1.2.3", "::1", "localhost", "LocalHost"}) {
        EXPECT_TRUE(is_loopback(address)) << address;
    }
    for (const char* address :
         {"0.0.0.0", "::", "10.0.0.1", "128.0.0.1", "127.0.0.1.example", "127.1", "", "::2"}) {
        EXPECT_FALSE(is_loopback(address)) << address;
    }
}

TEST(HostCheck, OnLoopbackOnlyLoopbackNamesMayAsk) {
    const AllowedHosts hosts("127.0.0.1");
    for (const char* host :
         {"127.0.0.1", "127.0.0.1:8437", "localhost", "LOCALHOST:1", "[::1]", "[::1]:65535"}) {
        EXPECT_TRUE(hosts.allow(host)) << host;
    }
    for (const char* host : {"",
                             ":",
                             ":8437",
                             "example.org",
                             "example.org:8437",
                             "localhost.example.org",
                             "127.0.0.1.example.org",
                             "192.0.2.1",
                             "[::2]",
                             "::1",
                             "[::1",
                             "[::1]8437",
                             "[localhost]",
                             "localhost:",
                             "localhost:x",
                             "localhost:123456",
                             "localhost:1:2",
                             " localhost",
                             "localhost ",
                             "a@localhost",
                             "localhost\tx"}) {
        EXPECT_FALSE(hosts.allow(host)) << host;
    }
}

TEST(HostCheck, OnOtherAddressesNumbersAndOwnNamesMayAsk) {
    const AllowedHosts hosts("0.0.0.0");
    std::array<char, 256> name{};
    ASSERT_EQ(gethostname(name.data(), name.size() - 1), 0);
    for (const std::string host : {"192.0.2.1:8437", "[2001:db8::1]:8437", "localhost", "127.0.0.1",
                                   static_cast<const char*>(name.data())}) {
        EXPECT_TRUE(hosts.allow(host)) << host;
    }
    // A name of somebody else's may have been bound to this machine's address.
    for (const char* host : {"example.org", "192.0.2.1.example.org", "192.0.2", "0x7f.1"}) {
        EXPECT_FALSE(hosts.allow(host)) << host;
    }
    EXPECT_TRUE(AllowedHosts("flume.example.org").allow("Flume.Example.org:80"));
}

}  // namespace
}  // namespace riffle::host_check_test
