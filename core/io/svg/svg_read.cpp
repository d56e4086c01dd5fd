#include "core/io/domain_builder.hpp"
#include "core/io/names.hpp"
#include "core/io/readers.hpp"
#include "core/io/svg/svg_pen.hpp"
#include "core/io/svg/svg_transform.hpp"

#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace forefront {

namespace {

/// A subpath in the coordinates of the domain.
struct DrawnPath {
    std::vector<Vec2> nodes;
    bool closed = false;
    std::string name;
    std::size_t offset = 0; ///< of its element in the text
};

/// Elements of SVG that only define something or carry text.
bool isSkipped(std::string_view name) {
    constexpr std::array kSkipped = {"defs",   "symbol", "clipPath", "mask",     "pattern",        "marker",
                                     "text",   "image",  "style",    "metadata", "linearGradient", "radialGradient",
                                     "filter", "title",  "desc",     "script",   "switch",         "foreignObject"};
    return std::find(kSkipped.begin(), kSkipped.end(), name) != kSkipped.end();
}

/// Reads the shapes of an SVG drawing. Closed outlines bound the domain by the even-odd rule, open ones are
/// constraints.
class SvgReader {
  public:
    explicit SvgReader(const SourceText &source) : source_(source) {}

    Result<Domain> read() {
        const pugi::xml_parse_result parsed = xml_.load_buffer(source_.text.data(), source_.text.size());
        if (!parsed) {
            return Diagnostics{faultAt(source_, static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0)),
                                       "xml-syntax", std::string("the XML is malformed: ") + parsed.description())};
        }
        root_ = xml_.document_element();
        if (local(root_) != "svg") {
            return Diagnostics{faultAt(source_, 0, "not-svg", "the file is not an SVG drawing")};
        }
        placeAxes();
        walk(std::nullopt);
        Box2 box;
        for (const DrawnPath &path : paths_) {
            for (const Vec2 node : path.nodes) {
                box.add(node);
            }
        }
        paths_.clear();
        size_ = box.diagonal();
        constexpr double kFineness = 2000.0;
        const double wanted = source_.options.curveTolerance;
        const double tolerance = wanted > 0.0 ? wanted : size_ / kFineness;
        if (faults_.empty() && (!std::isfinite(size_) || !(size_ > 0.0))) {
            fail(root_, "", 0, "empty-domain", "the drawing holds no path that could bound a domain");
        }
        if (faults_.empty()) {
            walk(tolerance);
        }
        if (!faults_.empty()) {
            return faults_;
        }
        return build();
    }

  private:
    static std::string_view local(const pugi::xml_node &node) {
        const std::string_view name = node.name();
        const std::size_t colon = name.find(':');
        return colon == std::string_view::npos ? name : name.substr(colon + 1);
    }

    static std::size_t offsetOf(const pugi::xml_node &node) {
        return static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
    }

    /// Records a fault at byte `within` of an attribute's value, as far as that can be found in the text.
    void fail(const pugi::xml_node &node, const char *attribute, std::size_t within, std::string code,
              std::string message, std::string advice = {}) {
        if (!faults_.empty()) {
            return;
        }
        std::size_t offset = offsetOf(node);
        const std::string_view text = source_.text;
        const std::string_view tag = text.substr(std::min(offset, text.size()));
        const std::string start = std::string(attribute) + '=';
        for (std::size_t at = tag.find(start); *attribute != '\0' && at < tag.find('>'); at = tag.find(start, at + 1)) {
            if (at > 0 && static_cast<unsigned char>(tag[at - 1]) <= ' ') {
                offset += at + start.size() + 1 + within;
                break;
            }
        }
        faults_.push_back(faultAt(source_, offset, std::move(code), std::move(message), std::move(advice)));
    }

    /// The y axis of a domain points up; the drawing is turned over within its view box.
    void placeAxes() {
        axes_ = AffineMap{1, 0, 0, -1, 0, 0};
        SvgNumbers box(root_.attribute("viewBox").value());
        Vec2 corner, size;
        if (box.point(corner) && box.point(size)) {
            axes_.f = 2.0 * corner.y + size.y;
        } else {
            SvgNumbers height(root_.attribute("height").value());
            height.number(axes_.f);
        }
    }

    /// Visits all shapes; without a tolerance only to measure.
    void walk(std::optional<double> tolerance) {
        struct Visit {
            pugi::xml_node node;
            AffineMap map;
        };
        std::vector<Visit> open = {{root_, axes_}};
        while (!open.empty() && faults_.empty()) {
            const Visit visit = open.back();
            open.pop_back();
            const std::string_view name = local(visit.node);
            if (visit.node.type() != pugi::node_element || isSkipped(name) || hidden(visit.node)) {
                continue;
            }
            AffineMap map = visit.map;
            if (const pugi::xml_attribute text = visit.node.attribute("transform")) {
                const auto own = parseTransform(text.value());
                if (!own) {
                    fail(visit.node, "transform", 0, "bad-transform", "the transform is malformed");
                    return;
                }
                map = map * *own;
            }
            if (name == "svg" || name == "g" || name == "a") {
                if (name == "svg" && visit.node != root_) {
                    map = map * AffineMap{1, 0, 0, 1, length(visit.node, "x"), length(visit.node, "y")};
                }
                for (pugi::xml_node child = visit.node.last_child(); child; child = child.previous_sibling()) {
                    open.push_back({child, map});
                }
            } else if (name == "use") {
                fail(visit.node, "", 0, "unknown-element", "copies of other elements (<use>) cannot be read",
                     "turn clones into paths in the drawing program");
            } else {
                shape(visit.node, name, map, tolerance);
            }
        }
    }

    static bool hidden(const pugi::xml_node &node) {
        const std::string_view style = node.attribute("style").value();
        return std::string_view(node.attribute("display").value()) == "none" ||
               style.find("display:none") != std::string_view::npos;
    }

    /// A length in user units; absent: 0.
    double length(const pugi::xml_node &node, const char *attribute) {
        const std::string_view text = node.attribute(attribute).value();
        SvgNumbers numbers(text);
        double value = 0.0;
        if (numbers.atEnd()) {
            return 0.0;
        }
        if (numbers.number(value)) {
            std::string_view unit = text.substr(numbers.offset());
            unit = unit.substr(0, unit.find_last_not_of(" \t\r\n") + 1);
            constexpr double kInch = 96.0;
            const std::pair<std::string_view, double> units[] = {{"", 1.0},
                                                                 {"px", 1.0},
                                                                 {"in", kInch},
                                                                 {"mm", kInch / 25.4},
                                                                 {"cm", kInch / 2.54},
                                                                 {"pt", kInch / 72.0},
                                                                 {"pc", kInch / 6.0}};
            for (const auto &[name, factor] : units) {
                if (unit == name) {
                    return factor * value;
                }
            }
        }
        fail(node, attribute, 0, "bad-number",
             std::string("expected a length for ") + attribute + ", found " + inQuotes(text));
        return 0.0;
    }

    void shape(const pugi::xml_node &node, std::string_view name, const AffineMap &map,
               std::optional<double> tolerance) {
        const double stretch = map.stretch();
        SvgPen pen(tolerance && stretch > 0.0 ? std::optional(*tolerance / stretch) : std::nullopt);
        std::optional<SvgFault> fault;
        const char *attribute = "";
        if (name == "path") {
            attribute = "d";
            fault = drawPath(node.attribute("d").value(), pen);
        } else if (name == "polygon" || name == "polyline") {
            attribute = "points";
            std::vector<Vec2> points;
            fault = readPoints(node.attribute("points").value(), points);
            for (const Vec2 p : points) {
                pen.down() ? pen.lineTo(p) : pen.moveTo(p);
            }
            if (name == "polygon") {
                pen.close();
            }
        } else if (name == "line") {
            pen.moveTo({length(node, "x1"), length(node, "y1")});
            pen.lineTo({length(node, "x2"), length(node, "y2")});
        } else {
            roundShape(node, name, pen);
        }
        if (fault) {
            fail(node, attribute, fault->offset, "bad-path", fault->message);
            return;
        }
        for (SvgSubpath &subpath : pen.take()) {
            keep(node, std::move(subpath), map);
        }
    }

    void roundShape(const pugi::xml_node &node, std::string_view name, SvgPen &pen) {
        if (name == "rect") {
            const Vec2 size{length(node, "width"), length(node, "height")};
            const bool hasX = !node.attribute("rx").empty(), hasY = !node.attribute("ry").empty();
            const double rx = length(node, hasX ? "rx" : "ry"), ry = length(node, hasY ? "ry" : "rx");
            if (size.x > 0.0 && size.y > 0.0) {
                pen.rectangle({length(node, "x"), length(node, "y")}, size, rx, ry);
            }
        } else if (name == "circle" || name == "ellipse") {
            const double rx = length(node, name == "circle" ? "r" : "rx");
            const double ry = length(node, name == "circle" ? "r" : "ry");
            if (rx > 0.0 && ry > 0.0) {
                pen.ellipse({length(node, "cx"), length(node, "cy")}, rx, ry);
            }
        }
    }

    void keep(const pugi::xml_node &node, SvgSubpath subpath, const AffineMap &map) {
        DrawnPath path;
        path.closed = subpath.closed;
        path.nodes = std::move(subpath.nodes);
        for (Vec2 &p : path.nodes) {
            p = map(p);
            if (!isFinite(p)) {
                fail(node, "", 0, "non-finite", "the path leaves the range of numbers");
                return;
            }
        }
        nodeCount_ += path.nodes.size();
        if (nodeCount_ > kSpareNodes + kNodesPerByte * source_.text.size()) {
            fail(node, "", 0, "too-large", "the curves need more nodes than can be held", "give a larger tolerance");
            return;
        }
        const char *label = node.attribute("inkscape:label").value();
        path.name = cleanName(*label != '\0' ? label : node.attribute("id").value());
        path.offset = offsetOf(node);
        paths_.push_back(std::move(path));
    }

    Domain build() {
        TagAllocator tags;
        DomainBuilder builder(source_.origin);
        if (source_.origin != nullptr) {
            source_.origin->showsColumns = true;
        }
        constexpr double kSameNode = 1e-6; // of the drawing's size: what relative path data loses by rounding
        for (DrawnPath &path : paths_) {
            std::vector<Vec2> &nodes = path.nodes;
            while (nodes.size() > 1 && distance(nodes.front(), nodes.back()) <= kSameNode * size_) {
                path.closed = path.closed || nodes.size() > 3;
                nodes.pop_back();
            }
            if (nodes.size() < 2) {
                continue;
            }
            const std::int32_t tag = tags.of(path.name);
            builder.from({path.offset});
            if (path.closed && nodes.size() > 2) {
                builder.addLoop(nodes, tag, SegmentRole::Boundary);
            } else {
                builder.addChain(nodes, tag);
            }
        }
        Domain domain = builder.finish();
        domain.boundaryNames = tags.names();
        return domain;
    }

    static constexpr std::size_t kSpareNodes = 2'000'000;
    static constexpr std::size_t kNodesPerByte = 8;

    const SourceText &source_;
    pugi::xml_document xml_;
    pugi::xml_node root_;
    AffineMap axes_;
    double size_ = 0.0;
    std::size_t nodeCount_ = 0;
    std::vector<DrawnPath> paths_;
    Diagnostics faults_;
};

} // namespace

bool looksLikeSvg(std::string_view head) {
    return head.find("<svg") != std::string_view::npos;
}

Result<Domain> readSvg(const SourceText &source) {
    return SvgReader(source).read();
}

} // namespace forefront
