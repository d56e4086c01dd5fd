#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project_node_sizes.hpp"

#include <limits>
#include <string>

namespace forefront {

void writeSegmentSizes(const Shape &shape, JsonText &out) {
    if (shape.segmentSizes.empty()) {
        return;
    }
    out << ", \"segmentSizes\": [";
    out.list(shape.segmentSizes, ", ", [&](const auto &entry) {
        const auto &[segment, size] = entry;
        out << "{\"segment\": " << segment;
        if (size.elements > 0) {
            out << ", \"elements\": " << size.elements;
        } else {
            out << ", \"size\": ";
            out.number(size.size);
        }
        out << ", \"growth\": ";
        out.number(size.growth);
        out << '}';
    });
    out << ']';
}

namespace {

void readSegmentSize(const JsonValue &item, Shape &shape, JsonCheck &check) {
    if (!check.expect(item, JsonKind::Object, "a size of a segment")) {
        return;
    }
    SegmentSize size;
    const auto elements = item.find("elements");
    if (elements) {
        size.elements =
            static_cast<std::uint32_t>(check.integer(*elements, 1, kMaxElementCount, "the number of elements"));
    }
    if (const auto value = elements ? item.find("size") : check.member(item, "size", "the size of a segment")) {
        size.size = elements ? 0.0 : check.positive(*value, "the size of a segment");
        if (elements) {
            check.fault(*value, "bad-number", "a segment has both a size and a number of elements; remove one");
        }
    }
    if (const auto value = item.find("growth")) {
        size.growth = check.notNegative(*value, "the growth of a segment");
    }
    check.noteUnknown(item, {"segment", "size", "elements", "growth"});
    const auto index = check.member(item, "segment", "the size of a segment");
    if (!index) {
        return;
    }
    constexpr std::int64_t kMaxIndex = std::numeric_limits<std::int32_t>::max();
    const auto segment = static_cast<std::uint32_t>(check.integer(*index, 0, kMaxIndex, "the index of a segment"));
    const std::size_t count = taggedSegments(shape);
    if (segment >= count) {
        check.fault(*index, "bad-index",
                    "invalid segment " + std::to_string(segment) + "; expected " +
                        (count == 0 ? std::string("none, since the shape has no segments")
                                    : "0 to " + std::to_string(count - 1)));
    } else if (!shape.segmentSizes.emplace(segment, size).second) {
        check.fault(*index, "bad-index", "segment " + std::to_string(segment) + " has two sizes; remove one");
    }
}

} // namespace

void readSegmentSizes(const JsonValue &item, Shape &shape, JsonCheck &check) {
    const auto list = item.find("segmentSizes");
    if (!list || !check.expect(*list, JsonKind::Array, "\"segmentSizes\"")) {
        return;
    }
    for (const JsonValue entry : *list) {
        if (check.full()) {
            return;
        }
        readSegmentSize(entry, shape, check);
    }
}

} // namespace forefront
