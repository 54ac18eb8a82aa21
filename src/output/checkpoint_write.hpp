#pragma once

#include "output/checkpoint_file.hpp"
#include "output/file_replace.hpp"

namespace riffle {

/// CheckpointFile::write, telling `observer` each step that is about to change the folder.
void write_checkpoint(const std::filesystem::path& path, const Content& content,
                      const StepObserver& observer);

}  // namespace riffle
