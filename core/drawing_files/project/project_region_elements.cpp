#include "core/drawing_files/project/project_region_elements.hpp"

#include <cstdint>
#include <set>
#include <string>

namespace forefront {

void writeRegionElements(const Document &document, JsonText &out) {
    if (document.regionElements.empty()) {
        return;
    }
    out << ",\n  \"regionElements\": [";
    out.list(document.regionElements, ", ", [&](const RegionElements &own) {
        out << "{\"region\": " << own.region << ", \"elements\": \"" << wordOf(own.elements) << "\"}";
    });
    out << ']';
}

void readRegionElements(const JsonValue &root, Document &document, JsonCheck &check) {
    const auto list = root.find("regionElements");
    if (!list || !check.expect(*list, JsonKind::Array, "\"regionElements\"")) {
        return;
    }
    std::set<std::int32_t> seen;
    for (const JsonValue item : *list) {
        if (check.full()) {
            return;
        }
        if (!check.expect(item, JsonKind::Object, "the elements of a region")) {
            continue;
        }
        const std::size_t before = check.faults().size();
        RegionElements own;
        if (const auto value = check.member(item, "region", "the elements of a region")) {
            own.region = check.tag(*value);
        }
        if (const auto value = check.member(item, "elements", "the elements of a region")) {
            own.elements = static_cast<Elements>(check.choice(*value, wordsOf<Elements>(), "the elements of a region"));
        }
        check.noteUnknown(item, {"region", "elements"});
        if (check.faults().size() != before) {
            continue;
        }
        if (!seen.insert(own.region).second) {
            check.fault(item, "bad-tag",
                        "region " + std::to_string(own.region) + " has elements twice; expected each region once");
            return;
        }
        document.regionElements.push_back(own);
    }
}

} // namespace forefront
