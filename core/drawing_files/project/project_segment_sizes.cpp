#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project_node_sizes.hpp"

#include <limits>
#include <string>

namespace forefront {

namespace {

void writeBias(const ElementBias &bias, JsonText &out) {
    if (bias.any()) {
        out << ", \"bias\": ";
        out.number(bias.ratio);
        out << (bias.bothEnds ? ", \"bothEnds\": true" : "");
    }
}

} // namespace

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
            writeBias(size.bias, out);
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

void readBias(const JsonValue &item, SegmentSize &size, JsonCheck &check) {
    const auto ratio = item.find("bias"), both = item.find("bothEnds");
    if (both) {
        size.bias.bothEnds = check.flag(*both, "\"bothEnds\"");
    }
    if (!ratio) {
        return;
    }
    size.bias.ratio = check.positive(*ratio, "the bias of a segment");
    if (!size.bias.isValid()) {
        check.fault(*ratio, "bad-number", "invalid bias of a segment; expected a ratio from 0.0001 to 10000");
        size.bias = {};
    } else if (size.elements == 0) {
        check.fault(*ratio, "bad-number",
                    "a segment has a bias but no number of elements; add one, or remove the bias");
    }
}

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
    readBias(item, size, check);
    check.noteUnknown(item, {"segment", "size", "elements", "growth", "bias", "bothEnds"});
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
