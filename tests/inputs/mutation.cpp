#include "mutation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "case/key_table.hpp"
#include "case/units.hpp"

namespace riffle::inputs {

namespace {

const std::vector<std::string>& odd_numbers() {
    static const std::vector<std::string> list{"0",
                                               "-0",
                                               "1",
                                               "-1",
                                               "0.5",
                                               "2",
                                               "3",
                                               "1e-300",
                                               "1e300",
                                               "-1e9",
                                               "1e9",
                                               "1e-9",
                                               "1e5",
                                               "1e4",
                                               "2147483647",
                                               "-2147483648",
                                               "4294967296",
                                               "nan",
                                               "inf",
                                               "-inf",
                                               "1e400",
                                               "1e-400",
                                               "9223372036854775807",
                                               "9223372036854775808",
                                               "0x7f",
                                               "1_000",
                                               "0.1",
                                               "1e-3",
                                               "50",
                                               "0.05",
                                               "1000",
                                               "0.002",
                                               "7e-5",
                                               "+1",
                                               ".5",
                                               "5.",
                                               "1e",
                                               "--1",
                                               "1.0.0",
                                               "0.05600000000000001",
                                               "1,5",
                                               "12 mm"};
    return list;
}

const std::vector<std::string>& odd_texts() {
    static const std::vector<std::string> list{"\"\"",
                                               "\"a\"",
                                               "\"\\u0000\"",
                                               "\"\\u001b[2J\"",
                                               "\"\\u202e\"",
                                               "\"50 mm\"",
                                               "\"5 mn\"",
                                               "\"0.4 D\"",
                                               "\"auto\"",
                                               "\"never\"",
                                               "\"converged\"",
                                               "\"1 s\"",
                                               "\"1e9 km\"",
                                               "\"-3 mm\"",
                                               "\"nan m\"",
                                               "true",
                                               "false",
                                               "[]",
                                               "[1]",
                                               "[1, 2]",
                                               "[0, 0.01, 0.02]",
                                               "[\"1 mm\", \"2 mm\"]",
                                               "{}",
                                               "{a = 1}",
                                               "1979-05-27",
                                               "07:32:00",
                                               "\"\"\"\n\"\"\"",
                                               "'",
                                               "\"",
                                               "[[",
                                               "\"box.stl\"",
                                               "\"profile.csv\"",
                                               "\"../box.stl\"",
                                               "\"/dev/zero\"",
                                               "\"\xff\"",
                                               "\"\xc3\xa9\""};
    return list;
}

std::vector<std::size_t> line_starts(const std::string& text) {
    std::vector<std::size_t> starts{0};
    for (std::size_t at = text.find('\n'); at != std::string::npos && at + 1 < text.size();
         at = text.find('\n', at + 1)) {
        starts.push_back(at + 1);
    }
    return starts;
}

using Corner = std::array<float, 3>;
using Facet = std::array<Corner, 3>;

std::vector<Facet> box_facets(const Corner& a, const Corner& b, bool inward) {
    const auto corner = [&](unsigned bits) {
        return Corner{(bits & 1U) != 0 ? b[0] : a[0], (bits & 2U) != 0 ? b[1] : a[1],
                      (bits & 4U) != 0 ? b[2] : a[2]};
    };
    const unsigned faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    std::vector<Facet> facets;
    for (const auto& f : faces) {
        facets.push_back({corner(f[0]), corner(f[1]), corner(f[2])});
        facets.push_back({corner(f[0]), corner(f[2]), corner(f[3])});
    }
    for (Facet& facet : facets) {
        if (inward) std::swap(facet[1], facet[2]);
    }
    return facets;
}

std::string binary_of(const std::vector<Facet>& facets) {
    std::string content(80, ' ');
    const auto count = static_cast<std::uint32_t>(facets.size());
    content.append(reinterpret_cast<const char*>(&count), sizeof count);
    for (const Facet& facet : facets) {
        content.append(12, '\0');
        content.append(reinterpret_cast<const char*>(facet.data()), sizeof facet);
        content.append(2, '\0');
    }
    return content;
}

std::string text_of(const std::vector<Facet>& facets) {
    std::string text = "solid box\n";
    for (const Facet& facet : facets) {
        text += " facet normal 0 0 0\n  outer loop\n";
        for (const Corner& c : facet) {
            text += fmt::format("   vertex {} {} {}\n", c[0], c[1], c[2]);
        }
        text += "  endloop\n endfacet\n";
    }
    return text + "endsolid box\n";
}

}  // namespace

std::vector<std::string> stl_seeds() {
    const auto a = box_facets({0, 0, 0}, {2, 1, 0.5}, false);
    auto both = a;
    for (const Facet& facet : box_facets({1, 0.25F, 0.25F}, {3, 0.75F, 2}, false)) {
        both.push_back(facet);
    }
    auto hollow = a;
    for (const Facet& facet : box_facets({0.5, 0.25F, 0.125F}, {1.5, 0.75F, 0.375F}, true)) {
        hollow.push_back(facet);
    }
    return {text_of(a),
            binary_of(a),
            text_of(both),
            binary_of(both),
            text_of(hollow),
            binary_of(hollow),
            text_of(a) + text_of(box_facets({5, 5, 5}, {6, 6, 6}, true))};
}

Mutator::Mutator(Kind kind, std::vector<std::string> seeds, std::uint64_t seed)
    : kind_(kind), seeds_(std::move(seeds)), generator_(seed) {}

std::string Mutator::next() {
    constexpr std::size_t longest = 400000;
    std::string text = one_of(seeds_);
    const std::size_t changes = 1 + below(below(4) == 0 ? 12 : 3);
    for (std::size_t i = 0; i < changes; ++i) change(text, longest);
    return text;
}

void Mutator::change(std::string& text, std::size_t longest) {
    constexpr std::size_t seldom = 500;
    if (below(seldom) == 0) {
        repeat_something(text);
    } else if (kind_ == Kind::stl && text.find('\0') != std::string::npos && below(4) != 0) {
        change_triangles(text);
    } else {
        switch (below(kind_ == Kind::case_file ? 8 : 5)) {
            case 0:
                change_bytes(text);
                break;
            case 1:
            case 2:
                change_lines(text);
                break;
            case 3:
            case 4:
                change_number(text);
                break;
            default:
                change_key(text);
        }
    }
    text.resize(std::min(text.size(), longest));
}

void Mutator::change_bytes(std::string& text) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = std::min(below(below(2) == 0 ? 4 : 200), text.size() - at);
    switch (below(6)) {
        case 0:
            if (at < text.size()) {
                text[at] = static_cast<char>(static_cast<unsigned char>(text[at]) ^ (1U << below(8)));
            }
            break;
        case 1:
            text.insert(at, 1, static_cast<char>(below(256)));
            break;
        case 2:
            text.erase(at, length);
            break;
        case 3:
            text.insert(at, text.substr(at, length));
            break;
        case 4:
            text.insert(below(text.size() + 1), one_of(seeds_).substr(0, length));
            break;
        default:
            text.resize(at);
    }
}

void Mutator::change_lines(std::string& text) {
    const auto starts = line_starts(text);
    const std::size_t line = below(starts.size());
    const std::size_t begin = starts[line];
    const std::size_t end = line + 1 < starts.size() ? starts[line + 1] : text.size();
    const std::string moved = text.substr(begin, end - begin);
    const std::size_t target = one_of(starts);
    switch (below(4)) {
        case 0:
            text.erase(begin, end - begin);
            break;
        case 1:
            text.insert(target, moved);
            break;
        case 2:
            text.erase(begin, end - begin);
            text.insert(std::min(target, text.size()), moved);
            break;
        default: {
            const std::string& other = one_of(seeds_);
            const auto others = line_starts(other);
            const std::size_t from = one_of(others);
            text.insert(target, other.substr(from, other.find('\n', from) + 1 - from));
        }
    }
}

void Mutator::change_number(std::string& text) {
    std::vector<std::pair<std::size_t, std::size_t>> numbers;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] < '0' || text[i] > '9') continue;
        std::size_t end = i;
        while (end < text.size() && std::strchr("0123456789.eE+-", text[end]) != nullptr &&
               text[end] != '\0') {
            ++end;
        }
        numbers.emplace_back(i, end - i);
        i = end;
    }
    if (numbers.empty()) {
        change_bytes(text);
        return;
    }
    const auto [at, length] = one_of(numbers);
    text.replace(at, length, one_of(odd_numbers()));
}

std::string Mutator::value_of_any_kind() {
    return below(2) == 0 ? one_of(odd_numbers()) : one_of(odd_texts());
}

/// Gives some key of the table a value: one of its words, a number around its range, or anything.
void Mutator::change_key(std::string& text) {
    const SectionKeys& section = one_of(key_table());
    const Key& key = one_of(section.keys);
    std::string value = value_of_any_kind();
    if (!key.words.empty() && below(4) != 0) {
        value = fmt::format("\"{}\"", key.words[below(key.words.size())].name);
    } else if (!key.unset_word.empty() && below(4) == 0) {
        value = fmt::format("\"{}\"", key.unset_word);
    } else if (key.type == ValueType::number && below(2) == 0) {
        const auto units = units_of(key.dimension);
        const std::string number = below(3) == 0 ? one_of(odd_numbers()) : fmt::format("{}", 1 + below(300));
        value = units.empty() ? number : fmt::format("\"{} {}\"", number, units[below(units.size())].symbol);
    } else if (key.type == ValueType::integer && below(2) == 0) {
        value = fmt::format("{}", below(12));
    }
    const std::string line = key.name + " = " + value + "\n";
    const std::string heading = section.heading();
    const std::size_t place = heading.empty() ? 0 : text.find(heading + "\n");
    if (place == std::string::npos) {
        text += (text.ends_with('\n') ? "" : "\n") + heading + "\n" + line;
        return;
    }
    const std::size_t begin = heading.empty() ? 0 : place + heading.size() + 1;
    // In place of the value that is there, or as a new line.
    const std::size_t end = std::min(text.find("\n[", begin), text.size());
    const std::size_t there = text.find(key.name + " =", begin);
    if (there < end && below(8) != 0) {
        text.replace(there, text.find('\n', there) + 1 - there, line);
    } else {
        text.insert(begin, line);
    }
}

void Mutator::change_triangles(std::string& text) {
    constexpr std::size_t header = 84;
    constexpr std::size_t record = 50;
    static const std::vector<float> odd{0.0F,   1.0F,   -1.0F, 0.5F,  1e-7F, 1e30F, 3e38F,
                                        -3e38F, 1e-40F, 2.0F,  0.25F, 1e20F, 0.1F,  1.0000001F};
    if (text.size() < header + record) {
        change_bytes(text);
        return;
    }
    const std::size_t triangles = (text.size() - header) / record;
    const std::size_t at = header + record * below(triangles);
    const std::size_t other = header + record * below(triangles);
    const std::size_t slot = at + 12 + 4 * below(9);
    const float value = one_of(odd);
    switch (below(7)) {
        case 0:
            std::memcpy(text.data() + slot, &value, sizeof value);
            break;
        case 1: {  // a corner of another triangle
            const std::string corner = text.substr(other + 12 + 12 * below(3), 12);
            text.replace(at + 12 + 12 * below(3), 12, corner);
            break;
        }
        case 2: {  // turned over
            const std::string first = text.substr(at + 12, 12);
            text.replace(at + 12, 12, text.substr(at + 24, 12));
            text.replace(at + 24, 12, first);
            break;
        }
        case 3:
            text.erase(at, record);
            break;
        case 4:
            text.insert(at, text.substr(other, record));
            break;
        case 5: {  // one coordinate moved a little
            float x = 0.0F;
            std::memcpy(&x, text.data() + slot, sizeof x);
            x += static_cast<float>(below(3)) * 1e-7F + (below(4) == 0 ? value : 0.0F);
            std::memcpy(text.data() + slot, &x, sizeof x);
            break;
        }
        default: {
            const auto count = static_cast<std::uint32_t>(below(2) == 0 ? triangles : generator_());
            std::memcpy(text.data() + 80, &count, sizeof count);
            return;
        }
    }
    if (below(8) != 0) {  // mostly with the right count
        const auto count = static_cast<std::uint32_t>((text.size() - header) / record);
        std::memcpy(text.data() + 80, &count, sizeof count);
    }
}

/// Some part of it, some ten thousand times.
void Mutator::repeat_something(std::string& text) {
    static const std::vector<std::string> parts{
        "a.", "[", "{a=",     "[[probe]]\n", "[[solid]]\n",    "\"", "1, ", "\n",
        ",",  ";", "x = 1\n", "facet ",      "vertex 0 0 0\n", "\0", "-",   "\"a\".",
        "#",  "9", "e"};
    const std::string part =
        below(3) == 0 && !text.empty() ? text.substr(below(text.size()), 1 + below(20)) : one_of(parts);
    const std::size_t times = std::min<std::size_t>(below(60000), 300000 / (part.size() + 1));
    std::string many;
    for (std::size_t i = 0; i < times; ++i) many += part;
    text.insert(below(text.size() + 1), many);
}

}  // namespace riffle::inputs
