#pragma once

#include <map>
#include <string>
#include <vector>

#include "case/toml_entries.hpp"

namespace riffle::inline case_file {

/// Everything found wrong in a case, so that one message can name it all.
class Problems {
  public:
    void add(Place place, std::string message);
    [[nodiscard]] bool empty() const { return list_.empty(); }

    /// Throw InputError with one line per problem, in the order of the file, then of the options.
    [[noreturn]] void raise() const;

  private:
    struct Problem {
        Place place;
        std::string message;
    };
    std::vector<Problem> list_;
};

/// Where the values of a case were given: by key ("channel.slope"), and the file for those that were not.
class Places {
  public:
    explicit Places(Place whole) : whole_(std::move(whole)) {}
    void set(const std::string& id, Place place) { given_[id] = std::move(place); }
    [[nodiscard]] bool given(const std::string& id) const { return given_.contains(id); }
    [[nodiscard]] const Place& of(const std::string& id) const {
        const auto found = given_.find(id);
        return found == given_.end() ? whole_ : found->second;
    }
    /// The place of the first of these keys that was given.
    [[nodiscard]] const Place& of_first(const std::vector<std::string>& ids) const;

  private:
    Place whole_;
    std::map<std::string, Place> given_;
};

}  // namespace riffle::inline case_file
