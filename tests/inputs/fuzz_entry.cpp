// The targets of libFuzzer, one for each kind of input (RIFFLE_INPUT_KIND): README.md.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "base/parallel.hpp"
#include "feed.hpp"
#include "mutation.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using riffle::inputs::Kind;
constexpr Kind kind = Kind::RIFFLE_INPUT_KIND;

const std::filesystem::path& folder() {
    static const std::filesystem::path made = [] {
        riffle::set_thread_count(1);
        const auto path = std::filesystem::temp_directory_path() / "riffle-fuzz";
        std::filesystem::create_directories(path);
        std::ofstream(path / "box.stl", std::ios::binary) << riffle::inputs::stl_seeds().front();
        std::ofstream(path / "profile.csv") << "z [mm], u [m/s]\n10, 0.2\n20, 0.3\n30, 0.33\n";
        return path;
    }();
    return made;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string input(reinterpret_cast<const char*>(data), size);
    try {
        switch (kind) {
            case Kind::case_file:
                riffle::inputs::feed_case(input, folder());
                break;
            case Kind::csv:
                riffle::inputs::feed_csv(input);
                break;
            case Kind::stl:
                riffle::inputs::feed_stl(input);
                break;
        }
    } catch (const riffle::inputs::Failure& failure) {
        std::fprintf(stderr, "FAILURE: %s\n", failure.what());
        std::abort();
    }
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
    if (seed % 3 == 0) return LLVMFuzzerMutate(data, size, most);
    std::string text(reinterpret_cast<const char*>(data), size);
    riffle::inputs::Mutator(kind, {text.empty() ? std::string("\n") : text}, seed).change(text, most);
    std::memcpy(data, text.data(), std::min(text.size(), most));
    return std::min(text.size(), most);
}
