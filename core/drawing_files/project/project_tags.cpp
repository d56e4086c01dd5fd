#include "core/drawing_files/project/project_tags.hpp"

#include <cstddef>
#include <set>
#include <string>

namespace forefront {

void writeTags(std::string_view member, const std::vector<std::int32_t> &tags, JsonText &out) {
    if (tags.empty()) {
        return;
    }
    out << ",\n  \"" << member << "\": [";
    out.list(tags, ", ", [&](std::int32_t tag) { out << tag; });
    out << ']';
}

void readTags(const JsonValue &root, std::string_view member, std::string_view twice, std::vector<std::int32_t> &tags,
              JsonCheck &check) {
    const auto list = root.find(member);
    if (!list || !check.expect(*list, JsonKind::Array, '"' + std::string(member) + '"')) {
        return;
    }
    std::set<std::int32_t> seen;
    for (const JsonValue item : *list) {
        if (check.full()) {
            return;
        }
        const std::size_t before = check.faults().size();
        const std::int32_t tag = check.tag(item);
        if (check.faults().size() != before) {
            continue;
        }
        if (!seen.insert(tag).second) {
            check.fault(item, "bad-tag",
                        "tag " + std::to_string(tag) + ' ' + std::string(twice) + "; expected each tag once");
            return;
        }
        tags.push_back(tag);
    }
}

} // namespace forefront
