#include "core/drawing_files/geojson/geojson.hpp"
#include "core/drawing_files/geojson/map_reader.hpp"
#include "core/files/common/names.hpp"
#include "core/files/json/json_outline.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace forefront {

namespace {

class GeoJsonReader {
  public:
    explicit GeoJsonReader(const SourceText &source) : map_(source), check_(map_.check()) {}

    /// `texts`: an array of GeoJSON texts, usually one.
    Result<DomainFile> read(const JsonValue &texts) {
        for (const JsonValue text : texts) {
            survey(text);
        }
        for (const JsonValue text : texts) {
            map_.readReferenceSystem(text);
            anything(text, {});
        }
        return map_.finish(*texts.begin());
    }

  private:
    void survey(const JsonValue &text) {
        const auto features = text.find("features");
        if (!features) {
            map_.survey(text);
            return;
        }
        for (const JsonValue feature : *features) {
            map_.survey(feature);
        }
    }

    /// Reads a collection, a feature or a geometry. The JSON reader limits the nesting.
    void anything(const JsonValue &value, const MapLabel &label) {
        const auto type = check_.member(value, "type", "the object");
        if (!type || check_.full()) {
            return;
        }
        const std::string word = type->string();
        if (word == "FeatureCollection") {
            map_.noteMembers(value, {"features"});
            each(value, "features", {});
        } else if (word == "GeometryCollection") {
            map_.noteMembers(value, {"geometries"});
            each(value, "geometries", label);
        } else if (word == "Feature") {
            map_.noteMembers(value, {"geometry", "properties", map_.idMember()});
            const auto geometry = check_.member(value, "geometry", "the feature");
            if (geometry && geometry->is(JsonKind::Null)) {
                map_.noteWithoutGeometry(value);
            } else if (geometry) {
                MapLabel own = map_.label(value);
                own.feature = map_.nextFeature();
                anything(*geometry, own);
            }
        } else {
            map_.noteMembers(value, {"coordinates"});
            geometry(*type, word, value, label);
        }
    }

    void each(const JsonValue &value, std::string_view member, const MapLabel &label) {
        const auto list = check_.member(value, member, "the collection");
        if (list && check_.expect(*list, JsonKind::Array, member)) {
            for (const JsonValue item : *list) {
                anything(item, label);
            }
        }
    }

    void geometry(const JsonValue &type, const std::string &word, const JsonValue &value, const MapLabel &label) {
        const auto coordinates = value.find("coordinates");
        if (!coordinates || !coordinates->is(JsonKind::Array)) {
            check_.fault(coordinates.value_or(value), "bad-field",
                         "expected a geometry with a list of \"coordinates\"");
            return;
        }
        if (word == "Polygon") {
            polygon(*coordinates, label);
        } else if (word == "LineString") {
            line(*coordinates, label);
        } else if (word == "Point") {
            map_.addPoint(map_.position(*coordinates), coordinates->offset(), label);
        } else if (word == "MultiPolygon" || word == "MultiLineString" || word == "MultiPoint") {
            for (const JsonValue part : *coordinates) {
                if (check_.full()) {
                    return;
                }
                if (word == "MultiPolygon") {
                    polygon(part, label);
                } else if (word == "MultiLineString") {
                    line(part, label);
                } else {
                    map_.addPoint(map_.position(part), part.offset(), label);
                }
            }
        } else {
            check_.fault(type, "unknown-geometry", "a geometry of type " + inQuotes(word) + " cannot be read");
        }
    }

    MapPath positions(const JsonValue &list, std::string_view what) {
        MapPath path;
        path.offset = list.offset();
        if (check_.expect(list, JsonKind::Array, what)) {
            for (const JsonValue item : list) {
                if (check_.full()) {
                    break;
                }
                path.nodes.push_back(map_.position(item));
                path.offsets.push_back(item.offset());
            }
        }
        return path;
    }

    void line(const JsonValue &value, const MapLabel &label) {
        MapPath path = positions(value, "a line");
        if (path.nodes.size() < 2) {
            check_.fault(value, "bad-count", "a line needs at least 2 positions");
        }
        map_.addLine(std::move(path), label);
    }

    void polygon(const JsonValue &value, const MapLabel &label) {
        if (!check_.expect(value, JsonKind::Array, "the rings of a polygon")) {
            return;
        }
        std::vector<MapPath> rings;
        for (const JsonValue ring : value) {
            rings.push_back(positions(ring, "a ring of a polygon"));
        }
        map_.addPolygon(std::move(rings), label);
    }

    MapReader map_;
    JsonCheck &check_;
};

} // namespace

bool looksLikeGeoJson(std::string_view head) {
    const JsonOutline outline = outlineOf(head);
    constexpr std::string_view kTypes[] = {"FeatureCollection", "Feature",      "GeometryCollection",
                                           "Polygon",           "MultiPolygon", "LineString",
                                           "MultiLineString",   "Point",        "MultiPoint"};
    if (std::find(std::begin(kTypes), std::end(kTypes), outline.type) != std::end(kTypes)) {
        return true;
    }
    // Its type may follow long lists.
    return outline.type.empty() && (outline.has("features") || outline.has("geometry") || outline.has("geometries") ||
                                    outline.has("coordinates"));
}

Result<DomainFile> readGeoJsonFile(const SourceText &source) {
    const auto json = JsonDocument::parseSequence(source);
    if (!json) {
        return json.faults();
    }
    return GeoJsonReader(source).read(json->root());
}

Result<Domain> readGeoJson(const SourceText &source) {
    Result<DomainFile> file = readGeoJsonFile(source);
    return file ? Result<Domain>(std::move(file->domain)) : file.faults();
}

} // namespace forefront
