#include "core/drawing_files/geojson/map_reader.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "core/files/common/names.hpp"

#include <algorithm>
#include <optional>
#include <string>

// The element sizes in the properties of a map's features.

namespace forefront {

/// Returns the size in the property that the options name; none where it is missing or null.
std::optional<double> MapReader::sizeIn(const JsonValue &properties) {
    const std::optional<std::string> &key = source_.options.sizeProperty;
    const auto given = key ? properties.find(*key) : std::nullopt;
    if (!given || given->is(JsonKind::Null)) {
        return {};
    }
    sized_ = true;
    const double size = given->is(JsonKind::Number) ? check_.number(*given, "a size") : 0.0;
    if (!(size > 0.0)) {
        check_.fault(*given, "bad-number", "expected a size above 0 in the property " + inQuotes(*key));
        return {};
    }
    return size;
}

/// Refuses a property for sizes that no feature has.
void MapReader::requireSizes(const JsonValue &whole) {
    if (check_.faults().empty() && source_.options.sizeProperty && !sized_) {
        constexpr std::size_t kShown = 12;
        check_.fault(whole, "unknown-property",
                     "no feature has a property '" + cleanName(*source_.options.sizeProperty) + "' with a size",
                     contents_.properties.empty() ? "the features have no properties to take sizes from"
                                                  : "expected one of " + listed(contents_.properties, kShown));
    }
}

/// Returns the sizes of points, and of faces by the areas that their markers lie in: the smallest where several do.
PlacedSizes MapReader::sizesFor(const Domain &domain) const {
    PlacedSizes sizes;
    for (const Point &point : points_) {
        if (point.size) {
            sizes.nodes.push_back({point.place, *point.size});
        }
    }
    for (const Polygon &polygon : polygons_) {
        if (!polygon.size) {
            continue;
        }
        Box2 box;
        for (const MapPath &ring : polygon.rings) {
            std::for_each(ring.nodes.begin(), ring.nodes.end(), [&](Vec2 p) { box.add(p); });
        }
        for (const RegionMarker &marker : domain.regionMarkers) {
            if (marker.tag != polygon.regionTag || !box.contains(marker.at)) {
                continue;
            }
            const auto around = std::count_if(polygon.rings.begin(), polygon.rings.end(), [&](const MapPath &ring) {
                return locate(ring.nodes, marker.at) == PointPlace::Inside;
            });
            if (around % 2 == 1) {
                sizes.regions.push_back({marker.at, 0.0, *polygon.size});
            }
        }
    }
    return sizes;
}

} // namespace forefront
