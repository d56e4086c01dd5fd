#include "core/drawing_files/project/project_layers.hpp"

#include <cstdint>
#include <set>
#include <string>

namespace forefront {

void writeLayers(const Document &document, JsonText &out) {
    if (document.layers.empty()) {
        return;
    }
    out << ",\n  \"layers\": [";
    out.list(document.layers, ", ", [&](const LayerSpec &layer) {
        out << "{\"tag\": " << layer.tag << ", \"first\": ";
        out.number(layer.first);
        out << ", \"growth\": ";
        out.number(layer.growth);
        if (layer.count) {
            out << ", \"count\": " << *layer.count;
        }
        if (layer.thickness) {
            out << ", \"thickness\": ";
            out.number(*layer.thickness);
        }
        out << ", \"type\": \"" << wordOf(layer.cells) << "\"}";
    });
    out << ']';
}

namespace {

/// `seen`: tags of the layers read so far.
void readLayer(const JsonValue &item, std::set<std::int32_t> &seen, Document &document, JsonCheck &check) {
    if (!check.expect(item, JsonKind::Object, "boundary layers")) {
        return;
    }
    const std::size_t before = check.faults().size();
    LayerSpec layer;
    if (const auto value = check.member(item, "tag", "boundary layers")) {
        layer.tag = check.tag(*value);
    }
    if (const auto value = check.member(item, "first", "boundary layers")) {
        layer.first = check.positive(*value, "the height of the first layer");
    }
    if (const auto value = item.find("growth")) {
        layer.growth = check.positive(*value, "the growth of boundary layers");
    }
    if (const auto value = item.find("count")) {
        layer.count = static_cast<std::uint32_t>(check.integer(*value, 1, kMaxLayers, "the number of boundary layers"));
    }
    if (const auto value = item.find("thickness")) {
        layer.thickness = check.positive(*value, "the thickness of boundary layers");
    }
    if (const auto value = item.find("type")) {
        layer.cells =
            static_cast<LayerCells>(check.choice(*value, wordsOf<LayerCells>(), "the type of boundary layers"));
    }
    check.noteUnknown(item, {"tag", "first", "growth", "count", "thickness", "type"});
    if (check.faults().size() != before) {
        return;
    }
    if (const auto fault = layerFault(layer, "tag " + std::to_string(layer.tag))) {
        check.fault(item, fault->code.c_str(), fault->message);
    } else if (!seen.insert(layer.tag).second) {
        check.fault(item, "bad-tag", "tag " + std::to_string(layer.tag) + " already has boundary layers");
    } else {
        document.layers.push_back(layer);
    }
}

} // namespace

void readLayers(const JsonValue &root, Document &document, JsonCheck &check) {
    const auto list = root.find("layers");
    if (!list || !check.expect(*list, JsonKind::Array, "\"layers\"")) {
        return;
    }
    std::set<std::int32_t> seen;
    for (const JsonValue item : *list) {
        if (check.full()) {
            return;
        }
        readLayer(item, seen, document, check);
    }
}

} // namespace forefront
