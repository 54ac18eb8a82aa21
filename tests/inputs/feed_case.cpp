#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "base/error.hpp"
#include "base/visible_text.hpp"
#include "boundary/wall.hpp"
#include "case/case.hpp"
#include "case/case_documents.hpp"
#include "column/column.hpp"
#include "feed.hpp"
#include "particles/case_size.hpp"
#include "particles/lattice.hpp"

namespace riffle::inputs {

namespace {

constexpr const char* name = "input.toml";

/// Each line of a message names the file first, but for the count of those that are left out.
void check_message(const std::string& message) {
    for (std::size_t begin = 0; begin < message.size();) {
        const std::size_t end = std::min(message.find('\n', begin), message.size());
        const std::string line = message.substr(begin, end - begin);
        if (!line.starts_with(name) && !line.starts_with("and ")) {
            throw Failure("an error message without its place: " + line);
        }
        begin = end + 1;
    }
    constexpr std::size_t longest = 200000;
    if (message.empty() || message.size() > longest) {
        throw Failure(fmt::format("an error message of {} letters", message.size()));
    }
}

void require_same(const Case& c, const std::string& text, const std::string& what,
                  const std::filesystem::path& path) {
    try {
        const Case again = parse_case(text, what, path);
        if (!again.same_parameters(c)) throw Failure(what + " reads back as another case:\n" + text);
        if (again.text != c.text) {
            throw Failure(what + " reads back with another text:\n" + text + "\n---\n" + again.text);
        }
    } catch (const Error& e) {
        throw Failure(what + " is refused: " + e.what() + "\n" + text);
    }
}

template <int D>
void build(const Case& c) {
    const Particles<D> water = lattice_particles<D>(c);
    const WallParticles<D> walls = wall_particles<D>(c);
    const Domain<D> domain = domain_of<D>(c);
    const FixedPoint<D> fixed(domain);
    for (std::size_t k = 0; k < D; ++k) {
        for (const double x : water.position[k]) {
            if (!std::isfinite(x)) throw Failure("a particle without a place");
        }
        for (const double x : walls.position[k]) {
            if (!std::isfinite(x)) throw Failure("a wall particle without a place");
        }
    }
    for (const double volume : walls.volume) {
        if (!(volume > 0.0)) throw Failure("a wall particle without volume");
    }
}

/// One text in so many, whichever it is.
bool one_in(std::uint64_t many, std::string_view text) {
    std::uint64_t hash = 14695981039346656037U;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    return (hash >> 20U) % many == 0;
}

void follow(const Case& c) {
    for (const std::string& text : {c.title, c.description, c.measured.source}) {
        if (hidden_character(text, 0, "\n\t")) throw Failure("a text with a control character is taken");
    }
    static_cast<void>(case_warnings(c));
    const CaseSize size = estimate_size(c);
    if (!std::isfinite(size.bytes) || !std::isfinite(size.places)) throw Failure("a case without a size");
    try {
        constexpr std::size_t memory = 1000000000;
        check_size(c, false, memory);
    } catch (const InputError&) {
        return;
    }
    constexpr double few = 20000.0;
    if (size.places + size.walls + size.cells < few) c.channel.dimensions == 2 ? build<2>(c) : build<3>(c);
    constexpr std::uint64_t seldom = 16;  // it takes a hundred times as long as the reading
    if (one_in(seldom, c.text)) {
        try {
            const ColumnResult column = solve_column(c);
            if (!std::isfinite(column.depth_mean_velocity)) throw Failure("a column without a velocity");
        } catch (const Error& e) {
            if (std::string(e.what()).empty()) throw Failure("an empty message");
        }
    }
}

}  // namespace

Answer feed_case(std::string_view input, const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / name;
    try {
        const Case c = parse_case(std::string(input), name, path);
        require_same(c, c.text, "the text of the case", path);
        require_same(c, case_template(c), "its template", path);
        follow(c);
        return Answer::taken;
    } catch (const InputError& e) {
        check_message(e.what());
        return Answer::refused;
    } catch (const Error& e) {
        throw Failure(std::string("not an InputError: ") + e.what());
    }
}

}  // namespace riffle::inputs
