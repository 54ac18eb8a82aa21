#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "case/case.hpp"

namespace riffle::test {

/// The smallest right case file.
inline const std::string smallest =
    "[channel]\nslope = 0.004\ndepth = \"50 mm\"\n[bed]\nroughness_height = \"0.4 D\"\n";

/// `smallest` with one of its lines replaced, and lines added at the end.
inline std::string changed(const std::string& line, const std::string& replacement,
                           const std::string& added = "") {
    std::string text = smallest;
    const auto at = text.find(line);
    if (at == std::string::npos) throw std::logic_error("no such line: " + line);
    return text.replace(at, line.size(), replacement) + added;
}

/// Message of the InputError that a text gives; empty when it is a right case.
inline std::string error_of(const std::string& text, const std::vector<Override>& overrides = {},
                            const std::filesystem::path& path = {}) {
    try {
        const Case c = parse_case(text, "case.toml", path, overrides);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace riffle::test
