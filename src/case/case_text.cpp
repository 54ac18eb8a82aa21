#include "case/case_text.hpp"

#include "case/conversion.hpp"
#include "case/key_table.hpp"

namespace riffle {

std::string case_text(const Case& c) {
    std::string text;
    for (const SectionKeys& section : key_table()) {
        if (!section.name.empty()) {
            text += "\n[" + section.name + "]\n";
        }
        for (const Key& key : section.keys) {
            if (key.applies.strictly && !key_applies(key, c)) {
                continue;
            }
            text += key.name + " = " + value_text(key, key.get(c)) + "\n";
        }
    }
    return text;
}

}  // namespace riffle
