#include "cli/help_formatter.hpp"

#include <sstream>
#include <string>
#include <utility>

#include "base/wrapped_text.hpp"

namespace riffle::inline cli {

namespace {

class WrappedHelp final : public CLI::Formatter {
  public:
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
        std::istringstream whole(CLI::Formatter::make_help(app, std::move(name), mode));
        std::string text;
        bool as_it_is = false;
        for (std::string line; std::getline(whole, line);) {
            as_it_is = as_it_is || line.rfind("Examples:", 0) == 0;
            const std::size_t indent = line.rfind(' ', 0) == 0 ? get_column_width() : 2;
            text += (as_it_is ? line : wrapped_text(line, indent)) + "\n";
        }
        return text;
    }
};

}  // namespace

std::shared_ptr<CLI::Formatter> help_formatter() { return std::make_shared<WrappedHelp>(); }

}  // namespace riffle::inline cli
