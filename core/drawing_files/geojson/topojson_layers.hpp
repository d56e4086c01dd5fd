#pragma once

#include "core/files/json/json.hpp"

#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// A layer of a TopoJSON file: a member of its "objects".
struct TopoLayer {
    std::string name;
    JsonValue content;
};

/// Returns the layers in the order of the file.
std::vector<TopoLayer> topoLayers(const JsonValue &objects);

/// Returns the layer of that name, or without one the first layer with polygons, or else the first; null if there is
/// none.
const TopoLayer *chooseLayer(const std::vector<TopoLayer> &layers, const std::optional<std::string> &name);

} // namespace forefront
