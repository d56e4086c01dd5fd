#include "core/drawing_files/project/project_water.hpp"

#include "core/files/json/json.hpp"

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>

namespace forefront {

void writeWater(const Document &document, JsonText &out) {
    if (!document.openBoundaries.empty()) {
        out << ",\n  \"openBoundaries\": [";
        out.list(document.openBoundaries, ", ", [&](std::int32_t tag) { out << tag; });
        out << ']';
    }
    if (!document.elevation.empty()) {
        out << ",\n  \"elevation\": " << jsonString(document.elevation);
    }
}

void readWater(const JsonValue &root, Document &document, JsonCheck &check) {
    if (const auto elevation = root.find("elevation")) {
        document.elevation = check.string(*elevation, "\"elevation\"");
    }
    const auto list = root.find("openBoundaries");
    if (!list || !check.expect(*list, JsonKind::Array, "\"openBoundaries\"")) {
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
            check.fault(item, "bad-tag", "tag " + std::to_string(tag) + " is open twice; expected each tag once");
            return;
        }
        document.openBoundaries.push_back(tag);
    }
}

} // namespace forefront
