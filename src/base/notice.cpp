#include "base/notice.hpp"

#include <utility>

namespace riffle::inline base {

namespace {

std::function<void(const std::string&)>& receiver_of_notices() {
    static std::function<void(const std::string&)> receiver;
    return receiver;
}

}  // namespace

void set_notices(std::function<void(const std::string&)> receiver) {
    receiver_of_notices() = std::move(receiver);
}

void notice(const std::string& what) {
    if (receiver_of_notices()) receiver_of_notices()(what);
}

}  // namespace riffle::inline base
