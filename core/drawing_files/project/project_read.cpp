#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/domain/domain_sources.hpp"
#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/drawing_files/project/project_constraints.hpp"
#include "core/drawing_files/project/project_cracks.hpp"
#include "core/drawing_files/project/project_curves.hpp"
#include "core/drawing_files/project/project_element_counts.hpp"
#include "core/drawing_files/project/project_layers.hpp"
#include "core/drawing_files/project/project_mapped.hpp"
#include "core/drawing_files/project/project_node_sizes.hpp"
#include "core/drawing_files/project/project_parameters.hpp"
#include "core/drawing_files/project/project_periodic.hpp"
#include "core/drawing_files/project/project_picture.hpp"
#include "core/drawing_files/project/project_region_elements.hpp"
#include "core/drawing_files/project/project_spacing.hpp"
#include "core/drawing_files/project/project_strips.hpp"
#include "core/drawing_files/project/project_words.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/files/json/json_check.hpp"
#include "core/files/json/json_outline.hpp"
#include "core/files/rules/rules_json.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <set>

namespace forefront {

namespace {

constexpr std::int64_t kMaxId = std::numeric_limits<std::uint32_t>::max() - 1;

class ProjectReader {
  public:
    explicit ProjectReader(const SourceText &source) : source_(source), check_(source) {}

    Result<Document> read(const JsonValue &root) {
        if (!header(root)) {
            return check_.faults();
        }
        check_.refuseRepeats(root);
        shapes(root);
        if (const auto markers = root.find("regionMarkers")) {
            regionMarkers(*markers);
        }
        names(root, "boundaryNames", document_.boundaryNames);
        names(root, "regionNames", document_.regionNames);
        if (const auto spec = root.find("spacing"); spec && check_.expect(*spec, JsonKind::Object, "\"spacing\"")) {
            document_.spacing = readSpacing(*spec, check_);
            if (const auto expression = spec->find("expression"); expression && source_.origin != nullptr) {
                source_.origin->spacingExpression = expression->offset();
            }
        }
        if (const auto given = root.find("options"); given && check_.expect(*given, JsonKind::Object, "\"options\"")) {
            options(*given);
        }
        if (const auto given = root.find("limits"); given && check_.expect(*given, JsonKind::Object, "\"limits\"")) {
            limits(*given);
        }
        if (const auto tolerance = root.find("circleTolerance")) {
            document_.circleTolerance = check_.positive(*tolerance, "\"circleTolerance\"");
            if (document_.circleTolerance < 1e-8 || document_.circleTolerance > 0.5) {
                check_.fault(*tolerance, "bad-number", "\"circleTolerance\" must lie between 1e-8 and 0.5");
            }
        }
        if (const auto tolerance = root.find("curveTolerance")) {
            document_.curveTolerance = check_.notNegative(*tolerance, "\"curveTolerance\"");
        }
        if (const auto given = root.find("picture"); given && check_.expect(*given, JsonKind::Object, "\"picture\"")) {
            document_.picture = readPicture(*given, source_.path, check_);
            check_.noteUnknown(*given, {"file", "at", "size", "opacity", "locked", "angle"});
        }
        if (const auto list = root.find("guides"); list && check_.expect(*list, JsonKind::Array, "\"guides\"")) {
            guides(*list);
        }
        if (const auto unit = root.find("unit")) {
            document_.unit = static_cast<LengthUnit>(check_.choice(*unit, wordsOf<LengthUnit>(), "\"unit\""));
        }
        nextId(root);
        readConstraints(root, renumbered_, document_, check_);
        readElementCounts(root, document_, check_);
        readLayers(root, document_, check_);
        readPeriodic(root, document_, check_);
        readCracks(root, document_, check_);
        readMapped(root, document_, check_);
        readStrips(root, document_, check_);
        readRegionElements(root, document_, check_);
        readParameters(root, source_.options.parameters, document_, check_);
        if (!check_.faults().empty()) {
            return check_.faults();
        }
        check_.noteUnknown(root, {"format",          "version",        "shapes",     "regionMarkers",  "boundaryNames",
                                  "regionNames",     "spacing",        "options",    "limits",         "nextId",
                                  "circleTolerance", "curveTolerance", "parameters", "formulas",       "picture",
                                  "elementCounts",   "constraints",    "guides",     "layers",         "periodic",
                                  "cracks",          "mapped",         "strips",     "regionElements", "unit"});
        if (source_.origin != nullptr) {
            recordOrigins();
        }
        return std::move(document_);
    }

  private:
    void guides(const JsonValue &list) {
        for (const JsonValue item : list) {
            if (!check_.expect(item, JsonKind::Object, "a guide")) {
                continue;
            }
            const auto x = item.find("x"), y = item.find("y");
            if (x.has_value() == y.has_value()) {
                check_.fault(item, "bad-guide", "a guide must have either \"x\" or \"y\"");
                continue;
            }
            document_.guides.push_back({x.has_value(), check_.number(x ? *x : *y, "the place of a guide")});
            check_.noteUnknown(item, {"x", "y"});
        }
    }

    /// Records the places of the parts of the document's domain in the text. The parts of rectangles, circles, ellipses
    /// and slots are placed at the list of nodes.
    void recordOrigins() {
        DomainSources sources;
        toDomain(document_, sources);
        const auto record = [&](DomainPartKind kind, const std::vector<ShapeNode> &parts) {
            for (const ShapeNode &part : parts) {
                const std::vector<std::size_t> &offsets = offsets_[part.shape];
                const Shape &shape = *document_.shapes[part.shape];
                const bool listed = isPath(shape) || shape.is<PointForm>();
                const std::size_t k = listed ? part.node + std::size_t{1} : 0;
                source_.origin->of(kind).push_back({k < offsets.size() ? offsets[k] : PartOrigin::kNowhere, {}});
            }
        };
        source_.origin->showsColumns = true;
        record(DomainPartKind::Node, sources.nodes);
        record(DomainPartKind::Segment, sources.segments);
        record(DomainPartKind::ConstraintPoint, sources.points);
        for (const std::size_t offset : markerOffsets_) {
            source_.origin->of(DomainPartKind::RegionMarker).push_back({offset, {}});
        }
    }

    bool header(const JsonValue &root) {
        const auto format = root.find("format");
        if (!format || format->string() != "forefront") {
            check_.fault(format.value_or(root), "not-a-project", "not a Forefront project, GeoJSON or TopoJSON file",
                         "a project begins with {\"format\": \"forefront\", \"version\": 2; a map has a \"type\" such "
                         "as \"FeatureCollection\" or \"Topology\"");
            return false;
        }
        const auto version = check_.member(root, "version", "the project");
        if (!version) {
            return false;
        }
        if (const auto number = version->integer(); number && *number > kProjectVersion) {
            check_.fault(*version, "newer-version",
                         "the project was written by a newer Forefront (project version " + std::to_string(*number) +
                             ", this program reads up to " + std::to_string(kProjectVersion) + ")",
                         "update Forefront");
            return false;
        }
        check_.integer(*version, 1, kProjectVersion, "\"version\"");
        return check_.faults().empty();
    }

    void shapes(const JsonValue &root) {
        const auto list = check_.member(root, "shapes", "the project");
        if (!list || !check_.expect(*list, JsonKind::Array, "\"shapes\"")) {
            return;
        }
        for (const JsonValue item : *list) {
            if (check_.full()) {
                return;
            }
            if (check_.expect(item, JsonKind::Object, "a shape")) {
                document_.shapes.push_back(std::make_shared<const Shape>(shape(item)));
            }
        }
    }

    Shape shape(const JsonValue &item) {
        Shape shape;
        offsets_.emplace_back();
        if (const auto id = check_.member(item, "id", "the shape")) {
            shape.id = static_cast<std::uint32_t>(check_.integer(*id, 1, kMaxId, "the id of a shape"));
            if (!ids_.insert(shape.id).second) {
                check_.fault(*id, "duplicate-id", "another shape has the id " + std::to_string(shape.id));
            }
        }
        if (const auto kind = check_.member(item, "kind", "the shape")) {
            shape.form =
                formOf(static_cast<ShapeKind>(check_.choice(*kind, wordsOf<ShapeKind>(), "the kind of a shape")));
        }
        if (const auto use = item.find("use")) {
            shape.use = static_cast<ShapeUse>(check_.choice(*use, wordsOf<ShapeUse>(), "the use of a shape"));
        }
        if (const auto tag = item.find("tag")) {
            shape.tag = check_.tag(*tag);
        }
        if (const auto name = item.find("name")) {
            shape.name = check_.string(*name, "the name of a shape");
        }
        if (const auto nodes = check_.member(item, "nodes", "the shape");
            nodes && check_.expect(*nodes, JsonKind::Array, "the nodes of a shape")) {
            shape.nodes = check_.points(*nodes, "a node of a shape");
            offsets_.back().push_back(nodes->offset());
            for (const JsonValue node : *nodes) {
                if (source_.origin != nullptr) {
                    offsets_.back().push_back(node.offset());
                }
            }
            nodeCount(shape, *nodes);
        }
        readRadius(item, shape);
        readCurves(item, shape, check_);
        readNodeSizes(item, shape, check_);
        readSegmentSizes(item, shape, check_);
        if (const auto hidden = item.find("hidden")) {
            shape.hidden = check_.flag(*hidden, "\"hidden\"");
        }
        if (const auto locked = item.find("locked")) {
            shape.locked = check_.flag(*locked, "\"locked\"");
        }
        if (const auto construction = item.find("construction")) {
            shape.construction = check_.flag(*construction, "\"construction\"");
        }
        if (const auto group = item.find("group")) {
            const auto number = static_cast<std::uint32_t>(check_.integer(*group, 1, kMaxId, "\"group\""));
            shape.group = groups_.try_emplace(number, static_cast<std::uint32_t>(groups_.size() + 1)).first->second;
        }
        if (const auto tags = item.find("segmentTags");
            tags && check_.expect(*tags, JsonKind::Array, "\"segmentTags\"")) {
            for (const JsonValue tag : *tags) {
                shape.segmentTags.push_back(check_.tag(tag));
            }
            segmentTagCount(shape, *tags);
        }
        check_.noteUnknown(item,
                           {"id", "kind", "use", "tag", "name", "nodes", "radius", "curves", "cuts", "segmentTags",
                            "nodeSizes", "segmentSizes", "hidden", "locked", "construction", "group"});
        return shape;
    }

    void readRadius(const JsonValue &item, Shape &shape) {
        const auto radius = item.find("radius");
        if (SlotForm *const slot = std::get_if<SlotForm>(&shape.form)) {
            if (radius) {
                slot->radius = check_.positive(*radius, "the radius of a slot");
            } else {
                check_.fault(item, "bad-number", "a slot has no radius; expected a number above 0",
                             "add \"radius\", half the width of the slot");
            }
        } else if (radius) { // other shapes have none; older versions wrote one that was left from a rectangle
            const double value = check_.notNegative(*radius, "the radius of a shape's corners");
            if (RectangleForm *const rectangle = std::get_if<RectangleForm>(&shape.form)) {
                rectangle->radius = value;
                noteLargeRadius(*radius, shape);
            }
        }
    }

    /// Warns of corners that are drawn with another radius than the file gives.
    void noteLargeRadius(const JsonValue &place, const Shape &rectangle) const {
        const double radius = rectangle.as<RectangleForm>().radius;
        if (rectangle.nodes.size() == 2 && radius > largestRounding(rectangle)) {
            source_.warn("bad-radius",
                         "the radius " + numberText(radius, 6) +
                             " of the corners of a rectangle is more than half of its "
                             "shorter side: drawn with " +
                             numberText(largestRounding(rectangle), 6),
                         place.offset());
        }
    }

    void nodeCount(const Shape &shape, const JsonValue &place) {
        const std::size_t count = shape.nodes.size();
        const std::size_t expected =
            shape.visit([](const PathForm &) { return 0; }, // any
                        [](const RectangleForm &) { return 2; }, [](const CircleForm &) { return 2; },
                        [](const PointForm &) { return 1; }, [](const EllipseForm &) { return 3; },
                        [](const SlotForm &) { return 2; });
        if (count == 0 || (expected != 0 && count != expected)) {
            const std::string nodes = expected == 0   ? "at least 1 node"
                                      : expected == 1 ? "1 node"
                                                      : std::to_string(expected) + " nodes";
            check_.fault(place, "bad-count",
                         (shape.is<EllipseForm>() ? "an " : "a ") + std::string(wordOf(shape.kind())) + " has " +
                             nodes + ", found " + std::to_string(count));
        }
    }

    void segmentTagCount(const Shape &shape, const JsonValue &place) {
        const std::size_t nodes = shape.nodes.size();
        const std::size_t count = shape.segmentTags.size();
        const std::size_t expected = shape.isPolygon() ? nodes : taggedSegments(shape); // also for two nodes
        // Before the arcs of rounded corners had tags of their own, each had the tag of the side before it.
        const bool sides = shape.is<RectangleForm>() && count == 4;
        if (count != 0 && count != expected && !sides) {
            check_.fault(place, "bad-count",
                         "expected a tag for each of the " + std::to_string(expected) + " segments, found " +
                             std::to_string(count));
        }
    }

    void regionMarkers(const JsonValue &list) {
        if (!check_.expect(list, JsonKind::Array, "\"regionMarkers\"")) {
            return;
        }
        for (const JsonValue item : list) {
            MarkedRegion marker;
            if (const auto at = check_.member(item, "at", "the region marker")) {
                marker.at = check_.point(*at, "a region marker");
            }
            if (const auto tag = check_.member(item, "tag", "the region marker")) {
                marker.tag = check_.tag(*tag);
            }
            if (const auto area = item.find("maxArea")) {
                marker.maxArea = check_.notNegative(*area, "the maximum area of a region marker");
            }
            if (const auto size = item.find("size")) {
                marker.size = check_.positive(*size, "the size of a region marker");
            }
            if (const auto growth = item.find("growth")) {
                marker.growth = check_.notNegative(*growth, "the growth of a region marker");
            }
            check_.noteUnknown(item, {"at", "tag", "maxArea", "size", "growth"});
            document_.regionMarkers.push_back(marker);
            markerOffsets_.push_back(item.offset());
        }
    }

    void names(const JsonValue &root, std::string_view member, std::map<std::int32_t, std::string> &names) {
        const auto object = root.find(member);
        if (!object || !check_.expect(*object, JsonKind::Object, member)) {
            return;
        }
        for (auto entry = object->begin(); entry != object->end(); ++entry) {
            const std::string key = entry.key();
            std::int32_t tag = 0;
            const auto [end, problem] = std::from_chars(key.data(), key.data() + key.size(), tag);
            if (problem != std::errc{} || end != key.data() + key.size() || tag < 1) {
                check_.fault(entry.keyValue(), "bad-tag", "expected a tag, an integer of at least 1, as key of a name");
            }
            names.emplace(tag, check_.string(*entry, "a name"));
        }
    }

    void options(const JsonValue &object) {
        MeshingOptions &options = document_.options;
        if (const auto method = object.find("method")) {
            options.method = static_cast<Method>(check_.choice(*method, wordsOf<Method>(), "the method"));
        }
        if (const auto grid = object.find("grid")) {
            options.grid = static_cast<GridKind>(check_.choice(*grid, wordsOf<GridKind>(), "the background grid"));
        }
        if (const auto columns = object.find("gridColumns")) {
            options.gridColumns = static_cast<int>(check_.integer(*columns, 0, kMaxCells, "\"gridColumns\""));
        }
        if (const auto rows = object.find("gridRows")) {
            options.gridRows = static_cast<int>(check_.integer(*rows, 0, kMaxCells, "\"gridRows\""));
        }
        if (const auto flag = object.find("keepBoundary")) {
            options.keepBoundary = check_.flag(*flag, "\"keepBoundary\"");
        }
        if (const auto level = object.find("improve")) {
            options.improve = improveLevel(*level);
        }
        if (const auto threads = object.find("threads")) {
            options.threads = static_cast<unsigned>(check_.integer(*threads, 0, kMaxThreads, "\"threads\""));
        }
        if (const auto most = object.find("maxElements")) {
            options.maxElements = static_cast<std::uint64_t>(check_.integer(*most, 1, kMaxElements, "\"maxElements\""));
        }
        if (const auto rules = object.find("rules")) {
            options.rules = readRules(*rules, check_);
        }
        elements(object);
        check_.noteUnknown(object, {"method", "grid", "gridColumns", "gridRows", "keepBoundary", "improve", "threads",
                                    "maxElements", "elements", "order", "quadNodes", "leastAngle", "rules"});
    }

    void elements(const JsonValue &object) {
        MeshingOptions &options = document_.options;
        if (const auto angle = object.find("leastAngle")) {
            options.leastAngle = check_.number(*angle, "\"leastAngle\"");
        }
        if (const auto shapes = object.find("elements")) {
            options.elements = static_cast<Elements>(check_.choice(*shapes, wordsOf<Elements>(), "the elements"));
        }
        if (const auto order = object.find("order")) {
            options.order = check_.integer(*order, 1, 2, "\"order\"") == 2 ? ElementOrder::Second : ElementOrder::First;
        }
        if (const auto nodes = object.find("quadNodes")) {
            options.quadNodes = check_.integer(*nodes, 8, 9, "\"quadNodes\"") == 9 ? QuadNodes::Nine : QuadNodes::Eight;
        }
    }

    void limits(const JsonValue &object) {
        for (const MeshLimit limit : valuesOf<MeshLimit>()) {
            const std::string member = limitInfo(limit).member;
            if (const auto given = object.find(member)) {
                const std::size_t before = check_.faults().size();
                const double value = check_.number(*given, inQuotes(member));
                document_.limits[limit] = value;
                const std::string fault = limitFault(limit, value);
                if (!fault.empty() && check_.faults().size() == before) {
                    check_.fault(*given, "bad-number", inQuotes(member) + ": " + fault);
                }
            }
        }
        std::vector<std::string_view> known;
        for (const MeshLimit limit : valuesOf<MeshLimit>()) {
            known.emplace_back(limitInfo(limit).member);
        }
        check_.noteUnknown(object, known);
    }

    /// Reads a word, or true (default) and false (none) as in older projects.
    ImproveLevel improveLevel(const JsonValue &value) {
        if (value.is(JsonKind::True) || value.is(JsonKind::False)) {
            return value.is(JsonKind::True) ? ImproveLevel::Default : ImproveLevel::None;
        }
        return static_cast<ImproveLevel>(check_.choice(value, wordsOf<ImproveLevel>(), "\"improve\""));
    }

    void nextId(const JsonValue &root) {
        document_.nextId = ids_.empty() ? 1 : *ids_.rbegin() + 1;
        if (const auto value = root.find("nextId")) {
            const std::int64_t next = check_.integer(*value, 1, kMaxId + 1, "\"nextId\"");
            document_.nextId = std::max(document_.nextId, static_cast<std::uint32_t>(next));
        }
        if (document_.nextId > kMaxId / 2) { // leave room for new shapes
            document_.nextId = 1;
            for (std::shared_ptr<const Shape> &shape : document_.shapes) {
                Shape renumbered = *shape;
                renumbered.id = document_.nextId++;
                renumbered_.emplace(shape->id, renumbered.id);
                shape = std::make_shared<const Shape>(std::move(renumbered));
            }
        }
    }

    static constexpr std::int64_t kMaxCells = 1 << 20;
    static constexpr std::int64_t kMaxThreads = 4096;

    const SourceText &source_;
    JsonCheck check_;
    Document document_;
    std::vector<std::vector<std::size_t>> offsets_; ///< per shape: its list of nodes, then each node
    std::vector<std::size_t> markerOffsets_;
    std::set<std::uint32_t> ids_;
    std::map<std::uint32_t, std::uint32_t> renumbered_; ///< ids of shapes that got others, and these
    std::map<std::uint32_t, std::uint32_t> groups_;     ///< groups of the file and their numbers, from 1
};

} // namespace

Result<Document> readProjectText(const SourceText &source) {
    const auto json = JsonDocument::parse(source);
    if (!json) {
        return json.faults();
    }
    return ProjectReader(source).read(json->root());
}

Result<Document> parseProject(std::string_view text, const std::string &fileName) {
    return readProjectText({text, fileName, {}, {}});
}

bool looksLikeProject(std::string_view head) {
    return outlineOf(head).has("format") && head.find("\"forefront\"") != std::string_view::npos;
}

Result<SpacingSpec> readProjectSpacing(const SourceText &source) {
    auto document = readProjectText(source);
    if (!document) {
        return document.faults();
    }
    return rulesOf(*document); // the others belong to its domain
}

} // namespace forefront
