#include "core/drawing_files/project/project_mapped.hpp"

#include <cstdint>
#include <set>
#include <string>
#include <utility>

namespace forefront {

void writeMapped(const Document &document, JsonText &out) {
    if (document.mapped.empty()) {
        return;
    }
    out << ",\n  \"mapped\": [";
    out.list(document.mapped, ", ", [&](const MappedSpec &spec) {
        out << "{\"region\": " << spec.region;
        if (!spec.corners.empty()) {
            out << ", \"corners\": [";
            out.list(spec.corners, ", ", [&](Vec2 p) {
                out << '[';
                out.number(p.x);
                out << ", ";
                out.number(p.y);
                out << ']';
            });
            out << ']';
        }
        out << '}';
    });
    out << ']';
}

void readMapped(const JsonValue &root, Document &document, JsonCheck &check) {
    const auto list = root.find("mapped");
    if (!list || !check.expect(*list, JsonKind::Array, "\"mapped\"")) {
        return;
    }
    std::set<std::int32_t> seen;
    for (const JsonValue item : *list) {
        if (check.full()) {
            return;
        }
        if (!check.expect(item, JsonKind::Object, "a mapped region")) {
            continue;
        }
        const std::size_t before = check.faults().size();
        MappedSpec spec;
        if (const auto value = check.member(item, "region", "a mapped region")) {
            spec.region = check.tag(*value);
        }
        if (const auto value = item.find("corners")) {
            spec.corners = check.points(*value, "the corners of a mapped region");
        }
        check.noteUnknown(item, {"region", "corners"});
        if (check.faults().size() != before) {
            continue;
        }
        if (!seen.insert(spec.region).second) {
            check.fault(item, "bad-tag",
                        "region " + std::to_string(spec.region) + " is mapped twice; expected each region once");
            return;
        }
        document.mapped.push_back(std::move(spec));
    }
}

} // namespace forefront
