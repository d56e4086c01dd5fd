#include "core/drawing_files/project/project_cracks.hpp"

#include <cstdint>
#include <set>
#include <string>

namespace forefront {

void writeCracks(const Document &document, JsonText &out) {
    if (document.cracks.empty()) {
        return;
    }
    out << ",\n  \"cracks\": [";
    out.list(document.cracks, ", ", [&](std::int32_t tag) { out << tag; });
    out << ']';
}

void readCracks(const JsonValue &root, Document &document, JsonCheck &check) {
    const auto list = root.find("cracks");
    if (!list || !check.expect(*list, JsonKind::Array, "\"cracks\"")) {
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
            check.fault(item, "bad-tag", "tag " + std::to_string(tag) + " is a crack twice; expected each tag once");
            return;
        }
        document.cracks.push_back(tag);
    }
}

} // namespace forefront
