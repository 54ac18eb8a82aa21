#include "case/toml_nesting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "base/error.hpp"
#include "case/toml_entries.hpp"

namespace riffle::inline case_file {

namespace {

/// Goes through TOML text as far as needed to tell strings and comments from keys and brackets.
class Nesting {
  public:
    Nesting(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    void check() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '"' || c == '\'') {
                skip_string(c);
                continue;
            }
            if (c == '#') {
                at_ = std::min(text_.find('\n', at_), text_.size());
                continue;
            }
            step(c);
            ++at_;
        }
    }

  private:
    void step(char c) {
        if (c == '.') {
            if (++dots_ >= most_key_parts) {
                refuse(fmt::format("a key of more than {} parts: a key is `key`, or `section.key`",
                                   most_key_parts));
            }
            return;
        }
        const bool opens = c == '[' || c == '{';
        const bool closes = c == ']' || c == '}';
        if (opens && ++depth_ > deepest_nesting) {
            refuse(fmt::format("more than {} arrays or tables in each other: a value is at most a list",
                               deepest_nesting));
        }
        depth_ -= closes && depth_ > 0 ? 1 : 0;
        if (opens || closes || c == '=' || c == ',' || c == '\n') dots_ = 0;
    }

    /// A string of one line, or of several in three quotes; what is wrong with it the parser says.
    void skip_string(char quote) {
        const std::string three(3, quote);
        const bool lines = text_.substr(at_, 3) == three;
        for (at_ += lines ? 3 : 1; at_ < text_.size(); ++at_) {
            if (quote == '"' && text_[at_] == '\\') {
                ++at_;
            } else if (lines ? text_.substr(at_, 3) == three : text_[at_] == quote) {
                at_ += lines ? 3 : 1;
                return;
            } else if (!lines && text_[at_] == '\n') {
                return;
            }
        }
    }

    [[noreturn]] void refuse(const std::string& what) const {
        const auto before = text_.substr(0, at_);
        const auto line_begin = before.rfind('\n');
        const Place place{name_, static_cast<unsigned>(std::count(before.begin(), before.end(), '\n') + 1),
                          static_cast<unsigned>(at_ - (line_begin + 1) + 1), false};  // npos + 1 is 0
        throw InputError(fmt::format("{}: {}", place.text(), what));
    }

    std::string_view text_;
    const std::string& name_;
    std::size_t at_ = 0;
    int dots_ = 0;
    int depth_ = 0;
};

}  // namespace

void refuse_deep_nesting(const std::string& text, const std::string& name) { Nesting(text, name).check(); }

}  // namespace riffle::inline case_file
