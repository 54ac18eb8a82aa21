#pragma once

#include "output/checkpoint_file.hpp"
#include "temporary_folder.hpp"

namespace riffle::test {

/// A content as it comes back from the file of a checkpoint.
class WrittenCheckpoint {
  public:
    explicit WrittenCheckpoint(const Content& content) {
        CheckpointFile::write(folder_ / "checkpoint.h5", content);
    }
    [[nodiscard]] CheckpointReader reader() const { return CheckpointReader(folder_ / "checkpoint.h5"); }

  private:
    TemporaryFolder folder_;
};

}  // namespace riffle::test
