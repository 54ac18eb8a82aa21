#include "watch/http_request.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace riffle::http_request_test {
namespace {

TEST(HttpRequest, IsCompleteWithItsEmptyLine) {
    const std::string text =
        "GET /data.json?x=1 HTTP/1.1\r\nHost:  localhost:8437 \r\nif-none-match: \"a\"\r\nX: y\r\n\r\nbody";
    const RequestReading whole = read_request(text);
    ASSERT_TRUE(whole.complete);
    EXPECT_EQ(whole.fault, 0);
    EXPECT_EQ(whole.request.method, "GET");
    EXPECT_EQ(whole.request.path, "/data.json");
    EXPECT_EQ(whole.request.host, "localhost:8437");
    EXPECT_EQ(whole.request.known_revision, "\"a\"");
    for (std::size_t size = 0; size < text.size() - 4; ++size) {
        EXPECT_FALSE(read_request(text.substr(0, size)).complete) << size;
    }
    EXPECT_TRUE(read_request("GET / HTTP/1.0\n\n").complete);
}

TEST(HttpRequest, OfTwoHostsCountsNone) {
    EXPECT_EQ(read_request("GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n").request.host, "");
    EXPECT_EQ(read_request("GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\nHost: c\r\n\r\n").request.host, "");
}

TEST(HttpRequest, IsRefusedAsSoonAsItIsTooLong) {
    EXPECT_FALSE(read_request(std::string(largest_request, 'x')).complete);
    EXPECT_EQ(read_request("GET /" + std::string(largest_request, 'x')).fault, 414);
    const std::string line = "GET / HTTP/1.1\r\n";
    EXPECT_EQ(read_request(line + "X: " + std::string(largest_request, 'x')).fault, 431);
    std::string many = line;
    while (many.size() <= largest_request) many += "A: b\r\n";
    EXPECT_EQ(read_request(many).fault, 431);
    EXPECT_EQ(read_request(many + "\r\n").fault, 431);
}

TEST(HttpRequest, RefusesWhatIsNone) {
    for (const char* line :
         {"", "GET", "GET /", "GET / HTTP/1.1 x", "GET  / HTTP/1.1", "GET x HTTP/1.1", "G(T / HTTP/1.1",
          "GET http://a/ HTTP/1.1", "GET /\x01 HTTP/1.1", "\x16\x03\x01 / HTTP/1.1", "GET / FTP/1.1"}) {
        EXPECT_EQ(read_request(std::string(line) + "\r\n\r\n").fault, 400) << line;
    }
    EXPECT_EQ(read_request("GET / HTTP/2.0\r\n\r\n").fault, 505);
    for (const char* header : {"no colon", ": no name", "a name: x", " folded: x", "a: \x02"}) {
        EXPECT_EQ(read_request(std::string("GET / HTTP/1.1\r\n") + header + "\r\n\r\n").fault, 400) << header;
    }
}

TEST(HttpRequest, AnyBytesGiveAnAnswer) {
    std::mt19937_64 random(1);
    const std::string whole = "GET /data.json HTTP/1.1\r\nHost: localhost\r\nIf-None-Match: x\r\n\r\n";
    for (int trial = 0; trial < 20000; ++trial) {
        std::string text = whole;
        for (int n = 0; n < 3; ++n) text[random() % text.size()] = static_cast<char>(random() % 256);
        const RequestReading reading = read_request(text);
        EXPECT_TRUE(reading.fault == 0 || reading.fault == 400 || reading.fault == 505) << text;
    }
}

TEST(HttpAnswer, HasItsLengthAndTheHeadersOfEveryPage) {
    const std::string head = head_of(fault_answer(414));
    EXPECT_NE(head.find("HTTP/1.1 414 URI Too Long\r\n"), std::string::npos);
    EXPECT_NE(head.find("Content-Length: 14\r\n"), std::string::npos);
    EXPECT_NE(head.find("Content-Security-Policy: "), std::string::npos);
    EXPECT_EQ(head.substr(head.size() - 4), "\r\n\r\n");
}

}  // namespace
}  // namespace riffle::http_request_test
