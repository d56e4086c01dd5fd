#include "core/drawing_files/project/project_node_sizes.hpp"

#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <limits>

namespace forefront {

void writeNodeSizes(const Shape &shape, JsonText &out) {
    if (shape.nodeSizes.empty()) {
        return;
    }
    out << ", \"nodeSizes\": [";
    out.list(shape.nodeSizes, ", ", [&](const auto &entry) {
        out << "{\"node\": " << entry.first << ", \"size\": ";
        out.number(entry.second.size);
        out << ", \"growth\": ";
        out.number(entry.second.growth);
        out << '}';
    });
    out << ']';
}

namespace {

void readNodeSize(const JsonValue &item, Shape &shape, JsonCheck &check) {
    if (!check.expect(item, JsonKind::Object, "a size of a node")) {
        return;
    }
    PartSize part;
    if (const auto value = check.member(item, "size", "the size of a node")) {
        part.size = check.positive(*value, "the size of a node");
    }
    if (const auto value = item.find("growth")) {
        part.growth = check.notNegative(*value, "the growth of a node");
    }
    check.noteUnknown(item, {"node", "size", "growth"});
    const auto index = check.member(item, "node", "the size of a node");
    if (!index) {
        return;
    }
    constexpr std::int64_t kMaxIndex = std::numeric_limits<std::int32_t>::max();
    const auto node = static_cast<std::uint32_t>(check.integer(*index, 0, kMaxIndex, "the index of a node"));
    if (!canHaveSize(shape, node)) {
        check.fault(*index, "bad-index",
                    "invalid node " + std::to_string(node) + "; expected " +
                        (shape.is<SlotForm>()
                             ? std::string("none, since a slot has no sizes at nodes")
                             : (isRound(shape) ? "1 to " : "0 to ") + std::to_string(handleCount(shape) - 1)));
    } else if (!shape.nodeSizes.emplace(node, part).second) {
        check.fault(*index, "bad-index", "node " + std::to_string(node) + " has two sizes; remove one");
    }
}

} // namespace

void readNodeSizes(const JsonValue &item, Shape &shape, JsonCheck &check) {
    const auto list = item.find("nodeSizes");
    if (!list || !check.expect(*list, JsonKind::Array, "\"nodeSizes\"")) {
        return;
    }
    for (const JsonValue entry : *list) {
        if (check.full()) {
            return;
        }
        readNodeSize(entry, shape, check);
    }
}

} // namespace forefront
