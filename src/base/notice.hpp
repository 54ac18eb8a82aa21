#pragma once

#include <functional>
#include <string>

namespace riffle::inline base {

/// Who is told of work that takes long before a run shows progress (the reading of a large file, the making
/// of many particles); nobody at first.
void set_notices(std::function<void(const std::string&)> receiver);

/// Tell that such work begins: "reading 2000000 triangles of stone.stl".
void notice(const std::string& what);

}  // namespace riffle::inline base
