#include "core/io/common/drawing_builder.hpp"
#include "core/io/common/names.hpp"
#include "core/io/common/tag_allocator.hpp"
#include "core/io/geojson/geojson.hpp"
#include "core/io/json/json_check.hpp"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <map>
#include <set>

namespace forefront {

namespace {

struct GeoRing {
    JsonValue from;          ///< its coordinates in the text
    std::vector<Vec2> nodes; ///< the first one not repeated
};

struct GeoPolygon {
    std::vector<GeoRing> rings; ///< outline and holes
    std::int32_t boundaryTag = 1;
    std::int32_t regionTag = 1;
    std::size_t feature = 0; ///< number of the feature or lone geometry
    std::string name;
};

struct GeoLine {
    JsonValue from;
    std::vector<Vec2> nodes;
    std::int32_t tag = 1;
};

struct GeoPoint {
    JsonValue from;
    Vec2 place;
    std::int32_t tag = 1;
};

/// The properties of a feature.
struct GeoLabel {
    std::string name;
    std::optional<std::int32_t> tag;
    std::size_t feature = 0; ///< its number; 0: none
};

class GeoJsonReader {
  public:
    explicit GeoJsonReader(const SourceText &source) : source_(source), check_(source), builder_(source) {}

    /// `texts`: an array of GeoJSON texts, usually one.
    Result<Domain> read(const JsonValue &texts) {
        for (const JsonValue text : texts) {
            reserveTags(text);
        }
        for (const JsonValue text : texts) {
            noteReferenceSystem(text);
            anything(text, {});
        }
        if (!check_.faults().empty()) {
            return check_.faults();
        }
        if (polygons_.empty() && lines_.empty()) {
            check_.fault(*texts.begin(), "empty-domain",
                         "the file holds no polygon and no line that could bound a domain");
            return check_.faults();
        }
        addPolygons();
        for (const GeoLine &line : lines_) {
            buildFromItems(line.from);
            builder_.addChain(line.nodes, line.tag);
        }
        for (const GeoPoint &point : points_) {
            builder_.from({point.from.offset()});
            builder_.addPoint(point.place, point.tag);
        }
        noteUnused();
        Result<Domain> domain = builder_.finish();
        if (domain) {
            domain->boundaryNames = boundaries_.names();
            domain->regionNames = regions_.names();
        }
        return domain;
    }

  private:
    /// RFC 7946 knows only longitude and latitude; older files name other systems. Either way the numbers are used as
    /// they are, as coordinates in the plane.
    void noteReferenceSystem(const JsonValue &root) {
        const auto crs = root.find("crs");
        if (!crs || crs->is(JsonKind::Null)) {
            return;
        }
        const auto properties = crs->find("properties");
        const auto name = properties ? properties->find("name") : std::nullopt;
        source_.note("crs",
                     "the coordinate reference system" + (name ? ' ' + inQuotes(name->string()) : std::string()) +
                         " is ignored: coordinates are used as they are",
                     crs->offset());
    }

    /// Reports the members that are not used, once for the whole file.
    void noteUnused() {
        const auto note = [&](const Unused &unused, const char *code, const std::string &start) {
            if (unused.count == 0) {
                return;
            }
            constexpr std::size_t kShown = 8;
            std::string keys;
            std::size_t shown = 0;
            for (const std::string &key : unused.keys) {
                if (shown++ < kShown) {
                    keys += (shown > 1 ? ", " : "") + inQuotes(key);
                }
            }
            if (shown > kShown) {
                keys += " and " + std::to_string(shown - kShown) + " more";
            }
            source_.note(code, start + keys, unused.first, unused.count);
        };
        if (heights_.count > 0) {
            source_.note("height", "third coordinates are ignored: the domain is planar", heights_.first,
                         heights_.count);
        }
        note(properties_, "properties", "properties other than \"name\" and \"tag\" are ignored: ");
        note(members_, "members", "members that GeoJSON does not define are ignored: ");
    }

    struct Unused {
        std::set<std::string> keys;
        std::size_t first = 0, count = 0;
        void add(const std::string &key, std::size_t offset) {
            keys.insert(key);
            first = count++ == 0 ? offset : first;
        }
    };

    static bool oneOf(std::string_view key, std::initializer_list<std::string_view> known) {
        return std::find(known.begin(), known.end(), key) != known.end();
    }
    void noteMembers(const JsonValue &object, std::initializer_list<std::string_view> known) {
        for (auto member = object.begin(); member != object.end(); ++member) {
            const std::string key = member.key();
            if (!oneOf(key, known) && !oneOf(key, {"type", "bbox", "crs"})) {
                members_.add(key, member.keyValue().offset());
            }
        }
    }

    /// Sets the places of what is built next to the items of this list.
    void buildFromItems(const JsonValue &list) {
        std::vector<std::size_t> offsets;
        for (const JsonValue item : list) {
            offsets.push_back(item.offset());
        }
        builder_.from(std::move(offsets));
    }

    void reserveTags(const JsonValue &text) {
        const auto features = text.find("features");
        if (!features) {
            reserveTag(text);
            return;
        }
        for (const JsonValue feature : *features) {
            reserveTag(feature);
        }
    }

    void reserveTag(const JsonValue &feature) {
        const auto properties = feature.find("properties");
        if (const auto tag = properties ? tagIn(*properties) : std::nullopt) {
            boundaries_.reserve(*tag);
            regions_.reserve(*tag);
        }
    }

    static std::optional<std::int32_t> tagIn(const JsonValue &properties) {
        const auto tag = properties.find("tag");
        const auto number = tag ? tag->integer() : std::nullopt;
        const bool sound = number && *number >= 1 && *number <= std::numeric_limits<std::int32_t>::max();
        return sound ? std::optional(static_cast<std::int32_t>(*number)) : std::nullopt;
    }

    GeoLabel label(const JsonValue &feature) {
        GeoLabel label;
        const auto properties = feature.find("properties");
        if (!properties) {
            return label;
        }
        for (const char *key : {"name", "Name", "NAME"}) {
            const auto name = properties->find(key);
            if (name && name->is(JsonKind::String) && label.name.empty()) {
                label.name = cleanName(name->string());
            }
        }
        label.tag = tagIn(*properties);
        const auto tag = properties->find("tag");
        if (tag && !label.tag) {
            source_.note("bad-tag", "tags that are not integers of at least 1 are ignored", tag->offset());
        }
        for (auto member = properties->begin(); member != properties->end(); ++member) {
            const std::string key = member.key();
            if (!oneOf(key, {"name", "Name", "NAME", "tag"})) {
                properties_.add(key, member.keyValue().offset());
            }
        }
        return label;
    }

    static std::int32_t tagOf(TagAllocator &tags, const GeoLabel &label) {
        if (!label.tag) {
            return tags.of(label.name);
        }
        if (!label.name.empty()) {
            tags.name(*label.tag, label.name);
        }
        return *label.tag;
    }

    /// Reads a collection, a feature or a geometry. The JSON reader limits the nesting.
    void anything(const JsonValue &value, const GeoLabel &label) {
        const auto type = check_.member(value, "type", "the object");
        if (!type || check_.full()) {
            return;
        }
        const std::string word = type->string();
        if (word == "FeatureCollection") {
            noteMembers(value, {"features"});
            each(value, "features", {});
        } else if (word == "GeometryCollection") {
            noteMembers(value, {"geometries"});
            each(value, "geometries", label);
        } else if (word == "Feature") {
            noteMembers(value, {"geometry", "properties"});
            const auto geometry = check_.member(value, "geometry", "the feature");
            if (geometry && geometry->is(JsonKind::Null)) {
                source_.note("no-geometry", "features without a geometry are ignored", value.offset());
            } else if (geometry) {
                GeoLabel own = this->label(value);
                own.feature = ++features_;
                anything(*geometry, own);
            }
        } else {
            noteMembers(value, {"coordinates"});
            geometry(*type, word, value, label);
        }
    }

    void each(const JsonValue &value, std::string_view member, const GeoLabel &label) {
        const auto list = check_.member(value, member, "the collection");
        if (list && check_.expect(*list, JsonKind::Array, member)) {
            for (const JsonValue item : *list) {
                anything(item, label);
            }
        }
    }

    void geometry(const JsonValue &type, const std::string &word, const JsonValue &value, const GeoLabel &label) {
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
            points_.push_back({*coordinates, position(*coordinates), tagOf(boundaries_, label)});
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
                    points_.push_back({part, position(part), tagOf(boundaries_, label)});
                }
            }
        } else {
            check_.fault(type, "unknown-geometry", "a geometry of type " + inQuotes(word) + " cannot be read");
        }
    }

    /// Reads longitude and latitude, or x and y.
    Vec2 position(const JsonValue &value) {
        Vec2 place;
        std::size_t count = 0;
        for (const JsonValue number : value) {
            const double coordinate = check_.number(number, "a coordinate");
            (count == 0 ? place.x : place.y) = count < 2 ? coordinate : place.y;
            ++count;
        }
        if (count > 2) {
            heights_.add("z", value.offset());
        }
        if (!value.is(JsonKind::Array) || count < 2) {
            check_.fault(value, "bad-number", "expected a position, [x, y]");
        }
        return place;
    }

    std::vector<Vec2> positions(const JsonValue &list, std::string_view what) {
        std::vector<Vec2> nodes;
        if (check_.expect(list, JsonKind::Array, what)) {
            for (const JsonValue item : list) {
                if (check_.full()) {
                    break;
                }
                nodes.push_back(position(item));
            }
        }
        return nodes;
    }

    void line(const JsonValue &value, const GeoLabel &label) {
        std::vector<Vec2> nodes = positions(value, "a line");
        if (nodes.size() < 2) {
            check_.fault(value, "bad-count", "a line needs at least 2 positions");
        }
        lines_.push_back({value, std::move(nodes), tagOf(boundaries_, label)});
    }

    void polygon(const JsonValue &value, const GeoLabel &label) {
        if (!check_.expect(value, JsonKind::Array, "the rings of a polygon")) {
            return;
        }
        GeoPolygon polygon;
        bool flat = false; // the outline
        std::size_t count = 0;
        for (const JsonValue ring : value) {
            std::vector<Vec2> nodes = positions(ring, "a ring of a polygon");
            if (nodes.size() > 1 && nodes.front() == nodes.back()) {
                nodes.pop_back();
            } else if (nodes.size() >= 3) {
                source_.note("open-ring", "rings that do not end where they begin are closed", ring.offset());
            }
            if (nodes.size() >= 3) {
                polygon.rings.push_back({ring, std::move(nodes)});
            } else {
                source_.note("flat-ring", "rings with fewer than 3 different positions are ignored", ring.offset());
                flat = flat || count == 0;
            }
            ++count;
        }
        if (flat || polygon.rings.empty() || !check_.faults().empty()) {
            return;
        }
        polygon.boundaryTag = tagOf(boundaries_, label);
        polygon.regionTag = tagOf(regions_, label);
        polygon.feature = label.feature > 0 ? label.feature : ++features_;
        polygon.name = label.name;
        polygons_.push_back(std::move(polygon));
    }

    /// The polygons of a feature cover it together; a hole is cut only out of its own polygon.
    void addPolygons() {
        std::map<std::size_t, std::uint32_t> features;
        for (const GeoPolygon &polygon : polygons_) {
            const auto [feature, added] = features.try_emplace(polygon.feature, 0U);
            if (added) {
                feature->second = builder_.addFeature(polygon.regionTag, polygon.name);
            }
            const std::uint32_t shape = builder_.addShape(feature->second);
            for (const GeoRing &ring : polygon.rings) {
                buildFromItems(ring.from);
                const bool hole = &ring != &polygon.rings.front();
                builder_.addRing(builder_.addContour(shape, FillRule::NonZero, hole), ring.nodes, polygon.boundaryTag);
            }
        }
        if (polygons_.size() > 1 || !regions_.names().empty() ||
            (!polygons_.empty() && polygons_.front().regionTag != 1)) {
            builder_.markRegions();
        }
    }

    const SourceText &source_;
    JsonCheck check_;
    TagAllocator boundaries_, regions_;
    std::vector<GeoPolygon> polygons_;
    std::vector<GeoLine> lines_;
    std::vector<GeoPoint> points_;
    Unused properties_, members_, heights_;
    std::size_t features_ = 0; ///< numbered so far
    DrawingBuilder builder_;
};

} // namespace

bool looksLikeGeoJson(std::string_view head) {
    const std::size_t start = head.find_first_not_of(" \t\r\n\x1e");
    return start != std::string_view::npos && head[start] == '{' &&
           (head.find("\"FeatureCollection\"") != std::string_view::npos ||
            head.find("\"Feature\"") != std::string_view::npos ||
            head.find("\"coordinates\"") != std::string_view::npos);
}

Result<Domain> readGeoJson(const SourceText &source) {
    const auto json = JsonDocument::parseSequence(source);
    if (!json) {
        return json.faults();
    }
    return GeoJsonReader(source).read(json->root());
}

} // namespace forefront
