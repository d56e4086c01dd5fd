#include "core/drawing_files/project/project_strips.hpp"

#include <cstdint>
#include <optional>
#include <set>
#include <string>

namespace forefront {

void writeStrips(const Document &document, JsonText &out) {
    if (document.strips.empty()) {
        return;
    }
    out << ",\n  \"strips\": [";
    out.list(document.strips, ",", [&](const StripSpec &spec) {
        out << "\n    {\"tag\": " << spec.tag << ", \"width\": ";
        out.number(spec.width);
        out << ", \"rows\": " << spec.rows;
        if (spec.cells != LayerCells::Quads) {
            out << ", \"type\": \"" << wordOf(spec.cells) << '"';
        }
        if (spec.region != 0) {
            out << ", \"region\": " << spec.region;
        }
        out << '}';
    });
    out << "\n  ]";
}

void readStrips(const JsonValue &root, Document &document, JsonCheck &check) {
    const auto list = root.find("strips");
    if (!list || !check.expect(*list, JsonKind::Array, "\"strips\"")) {
        return;
    }
    std::set<std::int32_t> seen;
    for (const JsonValue item : *list) {
        if (check.full()) {
            return;
        }
        if (!check.expect(item, JsonKind::Object, "a strip")) {
            continue;
        }
        const std::size_t before = check.faults().size();
        StripSpec spec;
        if (const auto value = check.member(item, "tag", "a strip")) {
            spec.tag = check.tag(*value);
        }
        if (const auto value = check.member(item, "width", "a strip")) {
            spec.width = check.positive(*value, "the width of a strip");
        }
        if (const auto value = check.member(item, "rows", "a strip")) {
            spec.rows = static_cast<std::uint32_t>(check.integer(*value, 1, kMaxStripRows, "the rows of a strip"));
        }
        if (const auto value = item.find("type")) {
            spec.cells = static_cast<LayerCells>(check.choice(*value, wordsOf<LayerCells>(), "the type of a strip"));
        }
        if (const auto value = item.find("region")) {
            spec.region = check.tag(*value);
        }
        check.noteUnknown(item, {"tag", "width", "rows", "type", "region"});
        if (check.faults().size() != before) {
            continue;
        }
        if (!seen.insert(spec.tag).second) {
            check.fault(item, "bad-tag", "tag " + std::to_string(spec.tag) + " has two strips; expected each tag once");
            return;
        }
        document.strips.push_back(spec);
    }
}

} // namespace forefront
