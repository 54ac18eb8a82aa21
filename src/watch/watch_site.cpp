#include "watch/watch_site.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "report/page_assets.hpp"
#include "watch/watch_assets.hpp"

namespace riffle::inline watch {

namespace {

constexpr std::string_view json_type = "application/json; charset=utf-8";
constexpr std::string_view plain_type = "text/plain; charset=utf-8";

/// A file of the page, part of the program.
struct FixedFile {
    std::string_view path, content_type, body;
};

std::array<FixedFile, 7> fixed_files() {
    constexpr std::string_view script = "text/javascript; charset=utf-8", style = "text/css; charset=utf-8";
    static const PageAssets report = page_assets();  // the files refer to its texts
    const WatchAssets watch = watch_assets();
    return {{{"/", "text/html; charset=utf-8", watch.html},
             {"/report.css", style, report.style},
             {"/watch.css", style, watch.style},
             {"/plotly.js", script, report.plotly},
             {"/shared.js", script, report.shared_script},
             {"/field.js", script, report.field_script},
             {"/watch.js", script, watch.script}}};
}

PageAnswer make_answer(int status, std::string_view type, std::shared_ptr<const std::string> text) {
    PageAnswer answer;
    answer.status = status;
    answer.content_type = type;
    answer.text = std::move(text);
    answer.body = *answer.text;
    return answer;
}

PageAnswer refusal(int status, const char* message) {
    return make_answer(status, plain_type, std::make_shared<const std::string>(message));
}

/// Whether an If-None-Match header (a list, perhaps of weak tags) names this tag.
bool names_tag(std::string_view header, const std::string& tag) {
    return header.find(tag) != std::string_view::npos;
}

/// Give the answer its revision; without its body where the browser has it.
PageAnswer revised(PageAnswer answer, const std::string& revision, std::string_view known) {
    answer.revision = "\"" + revision + "\"";
    if (names_tag(known, answer.revision)) {
        answer.status = 304;
        answer.body = {};
    }
    return answer;
}

}  // namespace

WatchSite::WatchSite(std::filesystem::path results, std::string_view address)
    : watcher_(std::move(results)), hosts_(address) {}

PageAnswer WatchSite::answer(const PageRequest& request) {
    if (!hosts_.allow(request.host)) {
        return refusal(
            403,
            "riffle watch does not answer to this host name, so that pages of other sites cannot read it "
            "through a name of theirs. Use the address that it printed.\n");
    }
    if (request.method != "GET") return refusal(405, "riffle watch answers GET only.\n");
    if (request.path == "/status.json") {
        return make_answer(200, json_type, std::make_shared<const std::string>(watcher_.status_json()));
    }
    if (request.path == "/data.json") {
        const WatchData data = watcher_.data();
        return revised(make_answer(200, json_type, data.json), data.revision, request.known_revision);
    }
    const auto files = fixed_files();
    const auto found = std::find_if(files.begin(), files.end(),
                                    [&](const FixedFile& file) { return file.path == request.path; });
    if (found == files.end()) return refusal(404, "riffle watch has no such page. Its page is /.\n");
    PageAnswer answer;
    answer.content_type = found->content_type;
    answer.body = found->body;
    const std::string content = fmt::format("{:x}", std::hash<std::string_view>{}(answer.body));
    return revised(std::move(answer), content, request.known_revision);
}

}  // namespace riffle::inline watch
