#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "case/case.hpp"
#include "case/problems.hpp"

namespace riffle {

/// Read the surfaces of the solids of a case in three dimensions into Case::meshes, if each of them is right.
/// What is wrong with one is added at its `file`.
void read_meshes(Case& c, const Places& places, Problems& problems);

/// Check one solid of a case in three dimensions; say(key, message) takes what is wrong with it.
void validate_mesh(const Case& c, std::size_t item,
                   const std::function<void(const char* key, const std::string& message)>& say);

}  // namespace riffle
