#include "core/drawing_files/geojson/map_reader.hpp"
#include "core/drawing_files/geojson/topojson.hpp"
#include "core/drawing_files/geojson/topojson_layers.hpp"
#include "core/files/common/names.hpp"
#include "core/files/json/json_outline.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

class TopoJsonReader {
  public:
    explicit TopoJsonReader(const SourceText &source) : source_(source), map_(source), check_(map_.check()) {}

    Result<DomainFile> read(const JsonValue &topology) {
        const auto type = check_.member(topology, "type", "the topology");
        if (type && type->string() != "Topology") {
            check_.fault(*type, "bad-field", "expected the type \"Topology\"");
        }
        map_.noteMembers(topology, {"transform", "arcs", "objects"});
        map_.readReferenceSystem(topology);
        if (const auto transform = topology.find("transform")) {
            readTransform(*transform);
        }
        if (const auto arcs = check_.member(topology, "arcs", "the topology")) {
            readArcs(*arcs);
        }
        const auto objects = check_.member(topology, "objects", "the topology");
        if (objects && check_.expect(*objects, JsonKind::Object, "\"objects\"")) {
            if (const auto layer = findLayer(*objects)) {
                survey(*layer);
                geometry(*layer, {});
            }
        }
        return map_.finish(topology);
    }

  private:
    /// How integers become coordinates. Where there is one, the positions of an arc are relative to one another.
    struct Transform {
        Vec2 scale{1.0, 1.0}, translate;
        Vec2 operator()(Vec2 p) const { return {p.x * scale.x + translate.x, p.y * scale.y + translate.y}; }
    };

    void readTransform(const JsonValue &value) {
        const auto scale = check_.member(value, "scale", "the transform");
        const auto translate = check_.member(value, "translate", "the transform");
        if (scale && translate) {
            transform_ = {check_.point(*scale, "the scale"), check_.point(*translate, "the translation")};
        }
    }

    Vec2 transformed(Vec2 p) const { return transform_ ? (*transform_)(p) : p; }

    void readArcs(const JsonValue &list) {
        if (!check_.expect(list, JsonKind::Array, "\"arcs\"")) {
            return;
        }
        for (const JsonValue arc : list) {
            MapPath path;
            path.offset = arc.offset();
            Vec2 sum;
            for (const JsonValue item : arc) {
                if (check_.full()) {
                    return;
                }
                const Vec2 p = map_.position(item);
                sum = transform_ ? sum + p : p;
                path.nodes.push_back(transformed(sum));
                path.offsets.push_back(item.offset());
            }
            if (path.nodes.empty()) {
                check_.fault(arc, "bad-field", "an arc must be a list of positions");
            }
            arcs_.push_back(std::move(path));
        }
    }

    /// Finds the layer to read; reports the others if nobody chose it.
    std::optional<JsonValue> findLayer(const JsonValue &objects) {
        constexpr std::size_t kShown = 12;
        const std::optional<std::string> &wanted = source_.options.layer;
        const std::vector<TopoLayer> layers = topoLayers(objects);
        const TopoLayer *const chosen = chooseLayer(layers, wanted);
        std::vector<std::string> names, others;
        for (const TopoLayer &layer : layers) {
            names.push_back(layer.name);
            if (&layer != chosen) {
                others.push_back(layer.name);
            }
        }
        if (chosen == nullptr) {
            if (wanted) {
                check_.fault(objects, "unknown-layer", "unknown layer '" + cleanName(*wanted) + '\'',
                             names.empty() ? "the file has no layers" : "expected one of " + listed(names, kShown));
            }
            return std::nullopt;
        }
        if (!others.empty() && !wanted) {
            source_.note("layers",
                         "of several layers, only " + listed({chosen->name}, 1) + " is read, not " +
                             listed(others, kShown) + "; --layer selects another",
                         objects.offset());
        }
        map_.setLayers(std::move(names), chosen->name);
        return chosen->content;
    }

    void survey(const JsonValue &value) {
        map_.survey(value);
        if (const auto list = value.find("geometries")) {
            for (const JsonValue item : *list) {
                survey(item);
            }
        }
    }

    /// Reads a geometry, which has properties and an id like a feature. The JSON reader limits the nesting.
    void geometry(const JsonValue &value, const MapLabel &around) {
        const auto type = check_.member(value, "type", "the geometry");
        if (!type || check_.full()) {
            return;
        }
        if (type->is(JsonKind::Null)) {
            map_.noteWithoutGeometry(value);
            return;
        }
        const std::string word = type->string();
        const bool collection = word == "GeometryCollection";
        MapLabel label = around;
        if (value.find("properties") || (!collection && around.feature == 0)) {
            label = map_.label(value);
            label.feature = map_.nextFeature();
        }
        map_.noteMembers(value, {"properties", "arcs", "coordinates", "geometries", map_.idMember()});
        if (collection) {
            const auto list = check_.member(value, "geometries", "the collection");
            if (list && check_.expect(*list, JsonKind::Array, "\"geometries\"")) {
                for (const JsonValue item : *list) {
                    geometry(item, label);
                }
            }
        } else if (word == "Point" || word == "MultiPoint") {
            points(value, word == "MultiPoint", label);
        } else {
            alongArcs(value, *type, label);
        }
    }

    void points(const JsonValue &value, bool many, const MapLabel &label) {
        const auto list = check_.member(value, "coordinates", "the geometry");
        const auto add = [&](const JsonValue &item) {
            map_.addPoint(transformed(map_.position(item)), item.offset(), label);
        };
        if (list && !many) {
            add(*list);
        } else if (list && check_.expect(*list, JsonKind::Array, "\"coordinates\"")) {
            for (const JsonValue item : *list) {
                add(item);
            }
        }
    }

    void alongArcs(const JsonValue &value, const JsonValue &type, const MapLabel &label) {
        const std::string word = type.string();
        const auto list = value.find("arcs");
        if (!list || !list->is(JsonKind::Array)) {
            check_.fault(list.value_or(value), "bad-field", "expected a geometry with a list of \"arcs\"");
        } else if (word == "Polygon") {
            polygon(*list, label);
        } else if (word == "LineString") {
            line(*list, label);
        } else if (word == "MultiPolygon" || word == "MultiLineString") {
            for (const JsonValue part : *list) {
                word == "MultiPolygon" ? polygon(part, label) : line(part, label);
            }
        } else {
            check_.fault(type, "unknown-geometry", "a geometry of type " + inQuotes(word) + " cannot be read");
        }
    }

    void line(const JsonValue &indices, const MapLabel &label) {
        MapPath path = join(indices);
        if (path.nodes.size() >= 2) {
            map_.addLine(std::move(path), label);
        } else if (check_.faults().empty()) {
            check_.fault(indices, "bad-count", "a line needs at least 2 positions");
        }
    }

    void polygon(const JsonValue &value, const MapLabel &label) {
        if (!check_.expect(value, JsonKind::Array, "the rings of a polygon")) {
            return;
        }
        std::vector<MapPath> rings;
        for (const JsonValue ring : value) {
            rings.push_back(join(ring));
        }
        map_.addPolygon(std::move(rings), label);
    }

    /// Joins arcs end to end; ~i stands for arc i from its end to its start.
    MapPath join(const JsonValue &indices) {
        MapPath path;
        path.offset = indices.offset();
        if (!check_.expect(indices, JsonKind::Array, "a list of arcs")) {
            return path;
        }
        const auto count = static_cast<std::int64_t>(arcs_.size());
        for (const JsonValue item : indices) {
            if (check_.full()) {
                break;
            }
            const auto index = item.integer();
            if (!index || *index < -count || *index >= count) {
                check_.fault(item, "bad-arc",
                             "expected the number of one of the " + std::to_string(count) + " arcs, or its complement");
                continue;
            }
            append(path, *index);
        }
        if (repeatsTooOften() && check_.faults().empty()) {
            check_.fault(indices, "too-large", "the geometries repeat arcs too often");
        }
        return path;
    }

    void append(MapPath &path, std::int64_t index) {
        if (repeatsTooOften()) {
            return;
        }
        const bool backwards = index < 0;
        const MapPath &arc = arcs_[static_cast<std::size_t>(backwards ? ~index : index)];
        const std::size_t size = arc.nodes.size();
        joined_ += size;
        for (std::size_t k = 0; k < size; ++k) {
            const std::size_t from = backwards ? size - 1 - k : k;
            if (k > 0 || path.nodes.empty() || path.nodes.back() != arc.nodes[from]) {
                path.nodes.push_back(arc.nodes[from]);
                path.offsets.push_back(arc.offsets[from]);
            }
        }
    }

    /// A small file can repeat a long arc many times; sound ones use each arc once or twice.
    bool repeatsTooOften() const {
        constexpr std::size_t kSpareNodes = 1'000'000, kNodesPerByte = 4;
        return joined_ > kSpareNodes + kNodesPerByte * source_.text.size();
    }

    const SourceText &source_;
    MapReader map_;
    JsonCheck &check_;
    std::optional<Transform> transform_;
    std::vector<MapPath> arcs_;
    std::size_t joined_ = 0; ///< nodes of all paths so far
};

} // namespace

bool looksLikeTopoJson(std::string_view head) {
    const JsonOutline outline = outlineOf(head);
    if (!outline.type.empty()) {
        return outline.type == "Topology";
    }
    // Its type may follow long lists.
    return !outline.ends && !outline.has("features") &&
           (outline.has("arcs") || (outline.has("objects") && head.find("\"arcs\"") != std::string_view::npos));
}

Result<DomainFile> readTopoJsonFile(const SourceText &source) {
    const auto json = JsonDocument::parse(source);
    if (!json) {
        return json.faults();
    }
    return TopoJsonReader(source).read(json->root());
}

Result<Domain> readTopoJson(const SourceText &source) {
    Result<DomainFile> file = readTopoJsonFile(source);
    return file ? Result<Domain>(std::move(file->domain)) : file.faults();
}

} // namespace forefront
