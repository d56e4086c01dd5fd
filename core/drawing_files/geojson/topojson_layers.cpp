#include "core/drawing_files/geojson/topojson_layers.hpp"

#include <algorithm>

namespace forefront {

namespace {

bool holdsPolygons(const JsonValue &value) {
    const auto type = value.find("type");
    const std::string word = type ? type->string() : std::string();
    if (word != "GeometryCollection") {
        return word == "Polygon" || word == "MultiPolygon";
    }
    bool found = false;
    if (const auto list = value.find("geometries")) {
        for (const JsonValue item : *list) {
            found = found || holdsPolygons(item);
        }
    }
    return found;
}

} // namespace

std::vector<TopoLayer> topoLayers(const JsonValue &objects) {
    std::vector<TopoLayer> layers;
    for (auto member = objects.begin(); member != objects.end(); ++member) {
        layers.push_back({member.key(), *member});
    }
    return layers;
}

const TopoLayer *chooseLayer(const std::vector<TopoLayer> &layers, const std::optional<std::string> &name) {
    const auto found = std::find_if(layers.begin(), layers.end(), [&name](const TopoLayer &layer) {
        return name ? layer.name == *name : holdsPolygons(layer.content);
    });
    if (found != layers.end()) {
        return &*found;
    }
    return name || layers.empty() ? nullptr : &layers.front();
}

} // namespace forefront
