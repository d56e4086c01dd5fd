#include "core/drawing_files/geojson/kml_models.hpp"

#include <pugixml.hpp>

#include <sstream>
#include <string_view>
#include <vector>

namespace forefront {

namespace {

/// Returns the name of an element without its prefix.
std::string_view localName(const pugi::xml_node &node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

/// Returns the models below collections of geometries. Walks without recursion, since files may nest deeply.
std::vector<pugi::xml_node> modelsIn(const pugi::xml_document &document) {
    struct Place {
        pugi::xml_node node;
        bool collected; ///< within a collection
    };
    std::vector<pugi::xml_node> models;
    std::vector<Place> open{{document.document_element(), false}};
    while (!open.empty()) {
        const Place place = open.back();
        open.pop_back();
        const std::string_view name = localName(place.node);
        if (place.collected && name == "Model") {
            models.push_back(place.node);
            continue;
        }
        for (const pugi::xml_node child : place.node.children()) {
            open.push_back({child, place.collected || name == "MultiGeometry"});
        }
    }
    return models;
}

} // namespace

KmlWithoutModels withoutModels(std::string_view kml) {
    constexpr auto none = std::string_view::npos;
    pugi::xml_document document;
    if (kml.find("Model") == none || kml.find("MultiGeometry") == none ||
        !document.load_buffer(kml.data(), kml.size(), pugi::parse_full)) {
        return {};
    }
    const std::vector<pugi::xml_node> models = modelsIn(document);
    if (models.empty()) {
        return {};
    }
    for (pugi::xml_node model : models) {
        model.parent().remove_child(model);
    }
    std::ostringstream text;
    document.save(text, "", pugi::format_raw);
    return {text.str(), models.size()};
}

} // namespace forefront
