#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace riffle::inputs {

/// What an input must never do; the message says what it did.
class Failure : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Whether an input was taken or refused with a message.
enum class Answer { taken, refused };

/// Give the reader of a kind of file an input, and what follows from it. Throws Failure where an error
/// message does not begin with the place, where another exception than riffle::Error comes, or where what was
/// taken does not hold: a case whose text does not read back as the same case, a particle that is not in the
/// domain, a closed surface without inside. A crash is the sanitizers' to tell.
/// `folder`: where files stand that a case may name.
Answer feed_case(std::string_view input, const std::filesystem::path& folder);
Answer feed_csv(std::string_view input);
Answer feed_stl(std::string_view input);

}  // namespace riffle::inputs
