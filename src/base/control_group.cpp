#include "base/control_group.hpp"

#include <fstream>

namespace riffle::inline base {

namespace {

void add_with_those_above(const std::string& top, std::string group, int version,
                          std::vector<ControlGroupFolder>& folders) {
    folders.push_back({top, version});
    while (group.starts_with('/') && group.size() > 1) {
        folders.push_back({top + group, version});
        group.resize(group.rfind('/'));
    }
}

}  // namespace

std::string first_line(const std::string& file) {
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    return line;
}

std::vector<ControlGroupFolder> control_group_folders(const SystemFiles& files, std::string_view controller) {
    std::ifstream groups(files.root + "/proc/self/cgroup");
    const std::string mounted = files.root + "/sys/fs/cgroup";
    const std::string wanted = "," + std::string(controller) + ",";
    std::vector<ControlGroupFolder> folders;
    for (std::string line; std::getline(groups, line);) {
        // hierarchy:controllers:path; the second version is hierarchy 0 without controllers.
        const std::size_t first = line.find(':');
        const std::size_t second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        const std::string group = line.substr(second + 1);
        if (controllers.empty()) {
            add_with_those_above(mounted, group, 2, folders);
        } else if (("," + controllers + ",").find(wanted) != std::string::npos) {
            // Under its name, or under those of all controllers that it is mounted with.
            add_with_those_above(mounted + "/" + std::string(controller), group, 1, folders);
            add_with_those_above(mounted + "/" + controllers, group, 1, folders);
        }
    }
    return folders;
}

}  // namespace riffle::inline base
