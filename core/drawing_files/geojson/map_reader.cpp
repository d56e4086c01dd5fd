#include "core/drawing_files/geojson/map_reader.hpp"

#include "core/drawing_files/geojson/local_projection.hpp"
#include "core/drawing_files/geojson/map_degrees.hpp"
#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "core/engine/geometry/predicates.hpp"
#include "core/files/common/names.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numbers>
#include <span>
#include <utility>

namespace forefront {

namespace {

std::optional<std::int32_t> tagIn(const JsonValue &properties) {
    const auto tag = properties.find("tag");
    const auto number = tag ? tag->integer() : std::nullopt;
    const bool sound = number && *number >= 1 && *number <= std::numeric_limits<std::int32_t>::max();
    return sound ? std::optional(static_cast<std::int32_t>(*number)) : std::nullopt;
}

std::int32_t tagOf(TagAllocator &tags, const MapLabel &label) {
    if (!label.tag) {
        return tags.of(label.name);
    }
    if (!label.name.empty()) {
        tags.name(*label.tag, label.name);
    }
    return *label.tag;
}

/// Finds out whether other rings lie inside an outline, by the even-odd rule.
class OutlineIndex {
  public:
    explicit OutlineIndex(std::span<const Vec2> outline) : outline_(outline), tree_(boxesOf(outline)) {
        constexpr double kRounding = 1e-13; // relative to coordinates
        for (const Vec2 p : outline) {
            box_.add(p);
            slack_ = std::max({slack_, kRounding * std::fabs(p.x), kRounding * std::fabs(p.y)});
        }
    }

    /// Returns true if of some nodes of a ring and the middles of some sides, none lies inside the outline and at least
    /// one lies outside.
    bool isOutside(std::span<const Vec2> ring) const {
        constexpr std::size_t kTried = 8;
        const std::size_t step = (ring.size() + kTried - 1) / kTried;
        bool outside = false;
        for (std::size_t k = 0; k < ring.size(); k += step) {
            for (const Vec2 p : {ring[k], midpoint(ring[k], ring[(k + 1) % ring.size()])}) {
                const PointPlace found = place(p);
                if (found == PointPlace::Inside) {
                    return false;
                }
                outside = outside || found == PointPlace::Outside;
            }
        }
        return outside;
    }

  private:
    static std::vector<Box2> boxesOf(std::span<const Vec2> outline) {
        std::vector<Box2> boxes;
        boxes.reserve(outline.size());
        for (std::size_t k = 0; k < outline.size(); ++k) {
            boxes.push_back(boxOf(outline[k], outline[(k + 1) % outline.size()]));
        }
        return boxes;
    }

    /// Returns where a point lies; a point that is off the outline by rounding alone counts as on it.
    PointPlace place(Vec2 p) const {
        if (!box_.grown(slack_).contains(p)) {
            return PointPlace::Outside;
        }
        bool odd = false, on = false;
        tree_.query(Box2{p, {std::max(p.x, box_.max.x), p.y}}.grown(slack_), [&](std::uint32_t k) {
            const Vec2 a = outline_[k], b = outline_[(k + 1) % outline_.size()];
            on = on || distanceToSegment(a, b, p) <= slack_;
            odd ^= (a.y > p.y) != (b.y > p.y) && (b.y > a.y ? orientation(a, b, p) > 0 : orientation(a, b, p) < 0);
        });
        return on ? PointPlace::OnBoundary : odd ? PointPlace::Inside : PointPlace::Outside;
    }

    std::span<const Vec2> outline_;
    BoxTree tree_;
    Box2 box_;
    double slack_ = 0.0; ///< distance that rounding may make
};

} // namespace

MapReader::MapReader(const SourceText &source)
    : source_(source), check_(source), names_(source.options.nameProperty), partNames_(source.options.partNames),
      builder_(source) {}

void MapReader::setLayers(std::vector<std::string> names, std::string read) {
    contents_.layers = std::move(names);
    contents_.layer = std::move(read);
}

void MapReader::readReferenceSystem(const JsonValue &root) {
    const auto crs = root.find("crs");
    if (!crs || crs->is(JsonKind::Null)) {
        return;
    }
    const auto properties = crs->find("properties");
    const auto name = properties ? properties->find("name") : std::nullopt;
    if (name && isGeographic(name->string())) {
        contents_.system.geographic = true;
        return; // as if it were not named
    }
    planar_ = true;
    contents_.system.code = name ? systemCode(name->string()) : std::string();
    source_.note("crs",
                 "coordinates in the reference system" + (name ? ' ' + inQuotes(name->string()) : std::string()) +
                     " are used as they are",
                 crs->offset());
}

void MapReader::survey(const JsonValue &feature) {
    names_.survey(feature);
    const auto properties = feature.find("properties");
    if (const auto tag = properties ? tagIn(*properties) : std::nullopt) {
        boundaries_.reserve(*tag);
        regions_.reserve(*tag);
    }
}

MapLabel MapReader::label(const JsonValue &feature) {
    MapLabel label;
    label.name = names_.nameOf(feature);
    named_ = named_ || !label.name.empty();
    const auto properties = feature.find("properties");
    if (!properties) {
        return label;
    }
    label.tag = tagIn(*properties);
    const auto tag = properties->find("tag");
    if (tag && !label.tag) {
        source_.note("bad-tag", "tags that are not integers of at least 1 are ignored", tag->offset());
    }
    label.size = sizeIn(*properties);
    for (auto member = properties->begin(); member != properties->end(); ++member) {
        const std::string key = member.key();
        if (!isKnown(key)) {
            properties_.add(key, member.keyValue().offset());
        }
    }
    return label;
}

bool MapReader::isKnown(std::string_view property) const {
    return property == "tag" || names_.uses(property) || source_.options.sizeProperty == property;
}

Vec2 MapReader::position(const JsonValue &value) {
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

void MapReader::addPolygon(std::vector<MapPath> rings, const MapLabel &label) {
    Polygon polygon;
    bool flat = false; // the outline
    for (std::size_t k = 0; k < rings.size(); ++k) {
        MapPath &ring = rings[k];
        if (ring.nodes.size() > 1 && ring.nodes.front() == ring.nodes.back()) {
            ring.nodes.pop_back();
        } else if (ring.nodes.size() >= 3) {
            source_.note("open-ring", "rings that do not end where they begin are closed", ring.offset);
        }
        if (ring.nodes.size() >= 3) {
            polygon.rings.push_back(std::move(ring));
        } else {
            source_.note("flat-ring", "rings with fewer than 3 different positions are ignored", ring.offset);
            flat = flat || k == 0;
        }
    }
    if (flat || polygon.rings.empty() || !check_.faults().empty()) {
        return;
    }
    noteOuterHoles(polygon);
    polygon.boundaryTag = tagOf(boundaries_, label);
    polygon.regionTag = tagOf(regions_, label);
    polygon.feature = label.feature > 0 ? label.feature : nextFeature();
    polygon.name = label.name;
    polygon.size = label.size;
    hasSizes_ = hasSizes_ || label.size;
    polygons_.push_back(std::move(polygon));
}

/// Some programs write the parts of an area as the rings of one polygon, in any order.
void MapReader::noteOuterHoles(Polygon &polygon) {
    if (polygon.rings.size() < 2) {
        return;
    }
    const OutlineIndex outline(polygon.rings.front().nodes);
    for (std::size_t k = 1; k < polygon.rings.size(); ++k) {
        if (outline.isOutside(polygon.rings[k].nodes)) {
            polygon.evenOdd = true;
            source_.note("outer-hole",
                         "holes that do not lie in the outline of their polygon count as parts of it, by the even-odd "
                         "rule",
                         polygon.rings[k].offset);
        }
    }
}

void MapReader::addLine(MapPath line, const MapLabel &label) {
    if (label.size) {
        source_.note("line-size", "sizes of lines are ignored: only areas and points have sizes", line.offset);
    }
    lines_.push_back({std::move(line), tagOf(boundaries_, label)});
}

void MapReader::addPoint(Vec2 place, std::size_t offset, const MapLabel &label) {
    points_.push_back({place, offset, tagOf(boundaries_, label), label.size});
}

/// Reports rings that jump from one side of the map to the other: they cross the antimeridian without being cut there,
/// so they would run around the globe the other way.
void MapReader::noteJumps() const {
    constexpr double kNearly = 330.0, kWhole = 359.9; // degrees; a whole turn runs along the edge of the map
    constexpr double kRounding = 1e-6;
    Box2 box;
    for (const Polygon &polygon : polygons_) {
        for (const MapPath &ring : polygon.rings) {
            std::for_each(ring.nodes.begin(), ring.nodes.end(), [&](Vec2 node) { box.add(node); });
        }
    }
    if (box.empty() || box.min.x < -180.0 - kRounding || box.max.x > 180.0 + kRounding ||
        box.min.y < -90.0 - kRounding || box.max.y > 90.0 + kRounding) {
        return;
    }
    for (const Polygon &polygon : polygons_) {
        for (const MapPath &ring : polygon.rings) {
            for (std::size_t k = 0; k < ring.nodes.size(); ++k) {
                const double width = std::fabs(ring.nodes[(k + 1) % ring.nodes.size()].x - ring.nodes[k].x);
                if (width > kNearly && width < kWhole) {
                    source_.note("antimeridian",
                                 "rings that jump from one side of the map to the other are taken as they are; if they "
                                 "cross the antimeridian, cut them there, or add 360 to negative longitudes",
                                 ring.offset);
                    break;
                }
            }
        }
    }
}

/// Returns the bounds of all that is read.
Box2 MapReader::bounds() const {
    Box2 box;
    for (const Polygon &polygon : polygons_) {
        for (const MapPath &ring : polygon.rings) {
            std::for_each(ring.nodes.begin(), ring.nodes.end(), [&](Vec2 node) { box.add(node); });
        }
    }
    for (const Line &line : lines_) {
        std::for_each(line.path.nodes.begin(), line.path.nodes.end(), [&](Vec2 node) { box.add(node); });
    }
    for (const Point &point : points_) {
        box.add(point.place);
    }
    return box;
}

/// Projects, accepts or refuses longitudes and latitudes, as the options say.
void MapReader::settleDegrees(const JsonValue &whole) {
    const Box2 box = bounds();
    const DegreeRule rule = source_.options.degrees;
    contents_.degrees = !planar_ && maybeDegrees(box);
    if (!contents_.degrees) {
        if (rule == DegreeRule::Local) {
            check_.fault(whole, "not-degrees",
                         planar_
                             ? "the coordinates are not longitudes and latitudes, since the file names another "
                               "coordinate reference system"
                             : "the coordinates are not longitudes and latitudes in degrees, since some lie outside "
                               "-180 to 360 and -90 to 90",
                         "leave out --projection");
        }
        return;
    }
    if (rule == DegreeRule::Local) {
        project(whole, box);
        contents_.system = {.code = {}, .wkt = {}, .geographic = false, .centre = box.centre()};
        return;
    }
    constexpr double kNoticed = 1.01; // nearer to the equator, small plans are more likely
    const double distortion = degreeDistortion(box);
    contents_.system.geographic |= rule == DegreeRule::Keep || distortion > kNoticed;
    if (rule == DegreeRule::Warn && distortion > kNoticed) {
        std::array<char, 200> text{};
        std::snprintf(text.data(), text.size(),
                      "longitudes and latitudes in degrees are taken for coordinates in the plane: at latitude %.4g, "
                      "lengths from west to east are %.4g times too long",
                      box.centre().y, distortion);
        const std::string message = text.data();
        const std::string advice = "--projection local converts them to metres, --allow-degrees accepts them";
        if (source_.options.strict) {
            check_.fault(whole, kDegreesWarning, message, advice);
        } else {
            source_.warn(kDegreesWarning, message + "; " + advice, whole.offset());
        }
    }
}

/// Projects everything to metres about the middle of its bounds.
void MapReader::project(const JsonValue &whole, const Box2 &box) {
    constexpr double kNoticed = 1.01, kFarthest = std::numbers::pi / 2; // the latter a quarter of the globe away
    const Vec2 centre = box.centre();
    const LocalProjection projection(centre);
    double stretch = 1.0;
    const auto move = [&](Vec2 &place) {
        place = projection(place);
        stretch = std::max(stretch, LocalProjection::stretch(place));
    };
    for (Polygon &polygon : polygons_) {
        for (MapPath &ring : polygon.rings) {
            std::for_each(ring.nodes.begin(), ring.nodes.end(), move);
        }
    }
    for (Line &line : lines_) {
        std::for_each(line.path.nodes.begin(), line.path.nodes.end(), move);
    }
    for (Point &point : points_) {
        move(point.place);
    }
    for (PartName &part : partNames_) {
        part.from = projection(part.from);
        part.to = projection(part.to);
    }
    if (stretch > kFarthest) {
        check_.fault(whole, "large-map", "the map spans more than half of the globe; a local projection would tear it",
                     "project the map in another program, or keep degrees with --allow-degrees");
        return;
    }
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(),
                  "longitudes and latitudes are projected to metres about longitude %.9g, latitude %.9g", centre.x,
                  centre.y);
    std::string message = text.data();
    if (stretch > kNoticed) {
        std::snprintf(text.data(), text.size(),
                      "; at the rim, lengths across the direction of the centre are %.3g times too long", stretch);
        message += text.data();
    }
    source_.note("projected", message, whole.offset());
}

Result<DomainFile> MapReader::finish(const JsonValue &whole) {
    contents_.properties = names_.keys();
    if (check_.faults().empty() && !names_.found()) {
        constexpr std::size_t kShown = 12;
        check_.fault(whole, "unknown-property",
                     "no feature has a property '" + cleanName(names_.source()) + "' with text or a number",
                     contents_.properties.empty() ? "the features have no properties to take names from"
                                                  : "expected one of " + listed(contents_.properties, kShown));
    }
    requireSizes(whole);
    if (check_.faults().empty() && polygons_.empty() && lines_.empty()) {
        check_.fault(whole, "empty-domain",
                     points_.empty() ? "the file holds no polygon and no line that could bound a domain"
                                     : "the file holds only points (" + std::to_string(points_.size()) +
                                           "); expected polygons, or lines that form closed loops");
    }
    if (!check_.faults().empty()) {
        return check_.faults();
    }
    if (Diagnostics wrong = checkPlaces(partNames_, bounds()); !wrong.empty()) {
        return wrong;
    }
    noteJumps();
    settleDegrees(whole);
    if (!check_.faults().empty()) {
        return check_.faults();
    }
    buildPolygons();
    const bool mixed = !polygons_.empty() && !lines_.empty();
    const bool drops = source_.options.dropLines && mixed;
    contents_.lines = mixed;
    source_.reportContents(contents_);
    for (Line &line : lines_) {
        if (drops) {
            source_.note("dropped-lines", "lines are left out", line.path.offsets.front());
            continue;
        }
        builder_.from(std::move(line.path.offsets));
        builder_.addChain(line.path.nodes, line.tag);
    }
    for (const Point &point : points_) {
        builder_.from({point.offset});
        builder_.addPoint(point.place, point.tag);
    }
    noteUnused();
    Result<Domain> domain = builder_.finish();
    if (!domain) {
        return domain.faults();
    }
    domain->boundaryNames = boundaries_.names();
    domain->regionNames = regions_.names();
    const Diagnostics remarks = nameParts(partNames_, *domain);
    if (hasErrors(remarks)) {
        return remarks;
    }
    for (const Diagnostic &remark : remarks) {
        source_.note(remark.code, remark.message, whole.offset());
    }
    DomainFile file{std::move(*domain), {}};
    file.spacing.placed = sizesFor(file.domain);
    return file;
}

/// A hole is cut only out of its own polygon.
void MapReader::buildPolygons() {
    std::map<std::size_t, std::uint32_t> features;
    for (Polygon &polygon : polygons_) {
        const auto [feature, added] = features.try_emplace(polygon.feature, 0U);
        if (added) {
            feature->second = builder_.addFeature(polygon.regionTag, polygon.name);
        }
        const std::uint32_t shape = builder_.addShape(feature->second);
        std::uint32_t contour = 0;
        for (std::size_t k = 0; k < polygon.rings.size(); ++k) {
            if (k == 0 || !polygon.evenOdd) {
                contour = builder_.addContour(shape, polygon.evenOdd ? FillRule::EvenOdd : FillRule::NonZero, k > 0);
            }
            builder_.from(std::move(polygon.rings[k].offsets));
            builder_.addRing(contour, polygon.rings[k].nodes, polygon.boundaryTag);
        }
    }
    if (polygons_.size() > 1 || hasSizes_ || !regions_.names().empty() ||
        (!polygons_.empty() && polygons_.front().regionTag != 1)) {
        builder_.markRegions();
    }
}

} // namespace forefront
