#include "core/drawing_files/project/project_element_counts.hpp"

#include "core/drawing/formulas/element_counts.hpp"

#include <string>

namespace forefront {

void writeElementCounts(const Document &document, JsonText &out) {
    if (document.elementCounts.empty()) {
        return;
    }
    out << ",\n  \"elementCounts\": [";
    out.list(document.elementCounts, ", ", [&](const auto &entry) {
        out << "{\"tag\": " << entry.first << ", \"elements\": " << entry.second.count << ", \"growth\": ";
        out.number(entry.second.growth);
        out << '}';
    });
    out << ']';
}

namespace {

void readElementCount(const JsonValue &item, Document &document, JsonCheck &check) {
    if (!check.expect(item, JsonKind::Object, "a number of elements")) {
        return;
    }
    PartElements elements;
    std::int32_t tag = 1;
    if (const auto value = check.member(item, "tag", "the number of elements")) {
        tag = check.tag(*value);
    }
    if (const auto value = check.member(item, "elements", "the number of elements")) {
        elements.count =
            static_cast<std::uint32_t>(check.integer(*value, 1, kMaxElementCount, "the number of elements"));
    }
    if (const auto value = item.find("growth")) {
        elements.growth = check.notNegative(*value, "the growth of a boundary part");
    }
    check.noteUnknown(item, {"tag", "elements", "growth"});
    document.spacing.partSizes.erase(tag);
    if (!document.elementCounts.emplace(tag, elements).second) {
        check.fault(item, "bad-tag", "tag " + std::to_string(tag) + " already has a number of elements");
    }
}

} // namespace

void readElementCounts(const JsonValue &root, Document &document, JsonCheck &check) {
    const auto list = root.find("elementCounts");
    if (!list || !check.expect(*list, JsonKind::Array, "\"elementCounts\"")) {
        return;
    }
    for (const JsonValue item : *list) {
        if (check.full()) {
            return;
        }
        readElementCount(item, document, check);
    }
}

} // namespace forefront
