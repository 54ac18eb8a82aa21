#pragma once

#include <string>
#include <vector>

#include "analysis/figure.hpp"

namespace riffle::inline report {

/// A publication that a page refers to by a short name.
struct Reference {
    std::string name;      ///< as the page has it: "thesis", "Ritter 1892"
    std::string citation;  ///< author, year, title, where
};

/// Those that the sources, captions, references and remarks of the analyses name, and the texts given beside.
[[nodiscard]] std::vector<Reference> cited_references(const std::vector<Analysis>& analyses,
                                                      const std::vector<std::string>& texts = {});

}  // namespace riffle::inline report
