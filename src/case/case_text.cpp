#include "case/case_text.hpp"

#include "case/conversion.hpp"
#include "case/key_table.hpp"

namespace riffle::inline case_file {

std::string case_text(const Case& c) {
    std::string text;
    for (const SectionKeys& section : key_table()) {
        for (std::size_t item = 0; item < section.count(c); ++item) {
            if (!section.name.empty()) text += "\n" + section.heading() + "\n";
            for (const Key& key : section.keys) {
                if (key.applies.strictly && !key_applies(key, c, item)) continue;
                text += key.name + " = " + value_text(key, key.get(c, item)) + "\n";
            }
        }
    }
    return text;
}

}  // namespace riffle::inline case_file
