#include "output/checksum.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <boost/crc.hpp>
#include <string>
#include <vector>

namespace riffle::checksum_test {
namespace {

TEST(Checksum, HasTheCheckValueOfCrc64Xz) {
    const std::string text = "123456789";
    EXPECT_EQ(crc64(std::as_bytes(std::span(text))), 0x995DC9BBDF1939FAULL);
}

TEST(Checksum, AgreesWithBoostForAnyBytes) {
    EXPECT_TRUE(rc::check([](const std::vector<std::uint8_t>& bytes) {
        boost::crc_optimal<64, 0x42F0E1EBA9EA3693ULL, ~0ULL, ~0ULL, true, true> reference;
        reference.process_bytes(bytes.data(), bytes.size());
        RC_ASSERT(crc64(std::as_bytes(std::span(bytes))) == reference.checksum());
    }));
}

}  // namespace
}  // namespace riffle::checksum_test
