#pragma once

#include "case/key_table.hpp"

namespace riffle::inline case_file {

/// The keys of [[solid]] that say how it moves: as prescribed, or freely.
void add_motion_keys(SectionKeys& s);
void add_free_body_keys(SectionKeys& s);

}  // namespace riffle::inline case_file
