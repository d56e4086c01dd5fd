#include "core/io/svg/svg_drawing.hpp"

#include "core/io/common/names.hpp"
#include "core/io/svg/svg_axes.hpp"
#include "core/io/svg/svg_css.hpp"
#include "core/io/svg/svg_elements.hpp"
#include "core/io/svg/svg_notes.hpp"
#include "core/io/svg/svg_pen.hpp"
#include "core/io/svg/svg_viewport.hpp"

#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

class SvgDrawer {
  public:
    explicit SvgDrawer(const SourceText &source) : source_(source) {}

    Result<SvgPaths> run() {
        const pugi::xml_parse_result parsed = xml_.load_buffer(source_.text.data(), source_.text.size());
        if (!parsed) {
            return Diagnostics{faultAt(source_, static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0)),
                                       "xml-syntax", std::string("the XML is malformed: ") + parsed.description())};
        }
        root_ = xml_.document_element();
        if (localName(root_) != "svg") {
            return Diagnostics{faultAt(source_, 0, "not-svg", "the file is not an SVG drawing")};
        }
        collect();
        placeAxes();
        walk(std::nullopt);
        Box2 box;
        for (const SvgPath &path : paths_) {
            for (const Vec2 node : path.nodes) {
                box.add(node);
            }
        }
        paths_.clear();
        const double size = box.diagonal();
        constexpr double kFineness = 2000.0;
        const double requested = source_.options.curveTolerance;
        const double tolerance = requested > 0.0 ? requested : size / kFineness;
        if (faults_.empty() && (!std::isfinite(size) || !(size > 0.0))) {
            fail(root_, "", 0, "empty-domain", "the drawing holds no path that could bound a domain");
        }
        if (faults_.empty()) {
            walk(tolerance);
        }
        if (!faults_.empty()) {
            return faults_;
        }
        return SvgPaths{std::move(paths_), size};
    }

  private:
    /// An element to visit, with what it inherits.
    struct Visit {
        pugi::xml_node node;
        AffineMap map;
        Vec2 viewport;
        bool visible = true;
        SvgPaint paint = {};
        std::size_t use = kNoUse;      ///< the innermost <use> it is drawn by, in uses_
        std::optional<Vec2> size = {}; ///< of a <symbol> or <svg> drawn by a <use>
        pugi::xml_node named = {};     ///< the <use> that draws this very element
    };
    /// A <use> being drawn: what it draws, and the one around it.
    struct Use {
        pugi::xml_node target;
        std::size_t outer;
    };
    static constexpr auto kNoUse = static_cast<std::size_t>(-1);

    /// Records a fault at byte `within` of an attribute value, if it can be located in the text.
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

    void note(const pugi::xml_node &node, std::string_view code, const std::string &message) const {
        source_.note(code, message, offsetOf(node));
    }

    /// Finds the style sheets and the elements that others refer to.
    void collect() {
        struct Walker : pugi::xml_tree_walker {
            SvgDrawer *reader = nullptr;
            bool for_each(pugi::xml_node &node) override {
                if (node.type() == pugi::node_element) {
                    if (localName(node) == "style") {
                        reader->addSheet(node);
                    }
                    if (const pugi::xml_attribute id = node.attribute("id")) {
                        reader->byId_.emplace(id.value(), node);
                    }
                }
                return true;
            }
        } walker;
        walker.reader = this;
        xml_.traverse(walker);
    }

    void addSheet(const pugi::xml_node &node) {
        std::string css;
        for (const pugi::xml_node part : node.children()) {
            css += part.value();
        }
        styles_.addSheet(css, [&](const std::string &rule) {
            note(node, "svg-style",
                 "CSS rules for " + inQuotes(rule) +
                     " are ignored: only element, .class and #id selectors are supported");
        });
    }

    void placeAxes() {
        const SvgAxes axes = axesOf(root_);
        axes_ = axes.map;
        viewport_ = axes.viewport;
        if (!axes.unit.empty()) {
            note(root_, "svg-units", "coordinates are in " + unitName(axes.unit) + ", the unit of the document's size");
        }
    }

    /// Visits all shapes; without a tolerance, only measures them.
    void walk(std::optional<double> tolerance) {
        uses_.clear();
        std::size_t visited = 0;
        std::vector<Visit> open = {{root_, axes_, viewport_}};
        while (!open.empty() && faults_.empty()) {
            Visit visit = open.back();
            open.pop_back();
            if (visit.node.type() != pugi::node_element) {
                continue;
            }
            if (++visited > kSpareElements + source_.text.size()) {
                fail(visit.node, "", 0, "too-large", "nested <use> elements expand to too many elements");
                return;
            }
            element(visit, open, tolerance);
        }
    }

    void element(Visit &visit, std::vector<Visit> &open, std::optional<double> tolerance) {
        const std::string_view name = localName(visit.node);
        const bool drawn = visit.size.has_value() || !isDefinition(name);
        const bool reports = tolerance.has_value();
        if (!drawn ||
            std::string_view(visit.node.name()).find(':') < std::string_view(visit.node.name()).find("svg:")) {
            return; // definitions, and private data of editors
        }
        if (hidden(visit, reports)) {
            return;
        }
        if (reports) {
            noteUnusedStyle(source_, styles_, visit.node);
        }
        visit.paint = paintOf(visit.node, styles_, visit.paint);
        if (const pugi::xml_attribute text = visit.node.attribute("transform")) {
            const auto own = parseTransform(text.value());
            if (!own) {
                fail(visit.node, "transform", 0, "bad-transform",
                     "invalid transform " + inQuotes(text.value()) +
                         "; expected functions such as translate(1 2) or matrix(1 0 0 1 5 5)");
                return;
            }
            visit.map = visit.map * *own;
        }
        if (name == "svg" || name == "symbol") {
            enterViewport(visit, name);
        }
        if (name == "svg" || name == "symbol" || name == "g" || name == "a") {
            for (pugi::xml_node child = visit.node.last_child(); child; child = child.previous_sibling()) {
                open.push_back(inside(visit, child));
            }
        } else if (name == "switch") {
            chosen(visit, open);
        } else if (name == "use") {
            use(visit, open, reports);
        } else if (isShape(name)) {
            if (visit.visible) {
                shape(visit, name, tolerance);
            } else if (reports) {
                note(visit.node, "svg-hidden", "hidden shapes are ignored (visibility)");
            }
        } else if (reports) {
            note(visit.node, "svg-element", '<' + std::string(name) + "> is ignored" + whyIgnored(name));
        }
    }

    static Visit inside(const Visit &outer, const pugi::xml_node &child) {
        return {child, outer.map, outer.viewport, outer.visible, outer.paint, outer.use};
    }

    /// Inherits the visibility. Returns true if the element and its children are not displayed.
    bool hidden(Visit &visit, bool reports) {
        if (styles_.value(visit.node, "display") == "none") {
            if (reports) {
                note(visit.node, "svg-hidden", "hidden elements are ignored (display: none)");
            }
            return true;
        }
        const std::string own = styles_.value(visit.node, "visibility");
        if (!own.empty() && own != "inherit") {
            visit.visible = own != "hidden" && own != "collapse";
        }
        return false;
    }

    void enterViewport(Visit &visit, std::string_view name) {
        if (visit.node == root_) {
            return;
        }
        if (name == "svg") {
            visit.map =
                visit.map *
                AffineMap{1, 0, 0, 1, length(visit, "x", SvgExtent::Width), length(visit, "y", SvgExtent::Height)};
        }
        const auto extent = [&](const char *attribute, double given, SvgExtent kind) {
            if (given > 0.0) {
                return given;
            }
            const bool own = name == "svg" && !visit.node.attribute(attribute).empty();
            return own                        ? length(visit, attribute, kind)
                   : kind == SvgExtent::Width ? visit.viewport.x
                                              : visit.viewport.y;
        };
        const Vec2 given = visit.size.value_or(Vec2{});
        const Vec2 size{extent("width", given.x, SvgExtent::Width), extent("height", given.y, SvgExtent::Height)};
        const auto box = parseViewBox(visit.node.attribute("viewBox").value());
        if (box && size.x > 0.0 && size.y > 0.0) {
            visit.map = visit.map * viewBoxMap(*box, size, visit.node.attribute("preserveAspectRatio").value());
            visit.viewport = box->size;
        } else if (size.x > 0.0 && size.y > 0.0) {
            visit.viewport = size;
        }
    }

    /// Returns the first child of a <switch> that a program without extensions draws.
    void chosen(const Visit &visit, std::vector<Visit> &open) const {
        for (const pugi::xml_node child : visit.node.children()) {
            const std::string_view language = child.attribute("systemLanguage").value();
            const bool understood = child.attribute("systemLanguage").empty() || language.find("en") != language.npos;
            if (child.type() == pugi::node_element && localName(child) != "foreignObject" && understood &&
                std::string_view(child.attribute("requiredExtensions").value()).empty()) {
                open.push_back(inside(visit, child));
                return;
            }
        }
    }

    void use(Visit &visit, std::vector<Visit> &open, bool reports) {
        const char *plain = visit.node.attribute("href").value();
        const std::string_view href = *plain != '\0' ? plain : visit.node.attribute("xlink:href").value();
        const auto found = href.starts_with('#') ? byId_.find(std::string(href.substr(1))) : byId_.end();
        if (found == byId_.end()) {
            if (reports) {
                note(visit.node, "svg-use",
                     "<use> of " + inQuotes(href) + " is ignored: the drawing has no element of that id");
            }
            return;
        }
        const pugi::xml_node target = found->second;
        for (std::size_t outer = visit.use; outer != kNoUse; outer = uses_[outer].outer) {
            if (uses_[outer].target == target) {
                fail(visit.node, "", 0, "use-cycle", "<use> draws the element that it is part of: " + inQuotes(href),
                     "refer to another element");
                return;
            }
        }
        uses_.push_back({target, visit.use});
        Visit drawn = inside(visit, target);
        drawn.map = visit.map *
                    AffineMap{1, 0, 0, 1, length(visit, "x", SvgExtent::Width), length(visit, "y", SvgExtent::Height)};
        drawn.use = uses_.size() - 1;
        drawn.named = visit.node;
        if (localName(target) == "symbol" || localName(target) == "svg") {
            drawn.size = Vec2{length(visit, "width", SvgExtent::Width), length(visit, "height", SvgExtent::Height)};
        }
        open.push_back(drawn);
    }

    /// Returns a length in user units; 0 if absent.
    double length(const Visit &visit, const char *attribute, SvgExtent extent) {
        const std::string_view text = visit.node.attribute(attribute).value();
        if (text.find_first_not_of(" \t\r\n") == std::string_view::npos || text == "auto") {
            return 0.0;
        }
        const auto value = userLength(text, extent, visit.viewport);
        if (!value) {
            fail(visit.node, attribute, 0, "bad-number",
                 "invalid length " + inQuotes(text) + " for " + attribute +
                     "; expected a number with px, mm, cm, in, pt, pc, % or no unit");
        }
        return value.value_or(0.0);
    }

    void shape(const Visit &visit, std::string_view name, std::optional<double> tolerance) {
        const pugi::xml_node &node = visit.node;
        const double stretch = visit.map.stretch();
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
            pen.moveTo({length(visit, "x1", SvgExtent::Width), length(visit, "y1", SvgExtent::Height)});
            pen.lineTo({length(visit, "x2", SvgExtent::Width), length(visit, "y2", SvgExtent::Height)});
        } else {
            roundShape(visit, name, pen);
        }
        if (fault) {
            fail(node, attribute, fault->offset, "bad-path", fault->message);
            return;
        }
        for (SvgSubpath &subpath : pen.take()) {
            keep(visit, name, std::move(subpath));
        }
        ++elementCount_;
    }

    void roundShape(const Visit &visit, std::string_view name, SvgPen &pen) {
        const auto across = [&](const char *attribute) { return length(visit, attribute, SvgExtent::Width); };
        const auto down = [&](const char *attribute) { return length(visit, attribute, SvgExtent::Height); };
        if (name == "rect") {
            const Vec2 size{across("width"), down("height")};
            const bool hasX = !visit.node.attribute("rx").empty(), hasY = !visit.node.attribute("ry").empty();
            const double rx = hasX ? across("rx") : down("ry"), ry = hasY ? down("ry") : across("rx");
            if (size.x > 0.0 && size.y > 0.0) {
                pen.rectangle({across("x"), down("y")}, size, rx, ry);
            }
        } else if (name == "circle" || name == "ellipse") {
            const bool circle = name == "circle";
            const double rx = circle ? length(visit, "r", SvgExtent::Diagonal) : across("rx");
            const double ry = circle ? rx : down("ry");
            if (rx > 0.0 && ry > 0.0) {
                pen.ellipse({across("cx"), down("cy")}, rx, ry);
            }
        }
    }

    /// Returns the name of a shape: the label or id of the <use> that draws it, else its own.
    static std::string nameOf(const Visit &visit) {
        for (const pugi::xml_node &node : {visit.named, visit.node}) {
            for (const char *attribute : {"inkscape:label", "id"}) {
                if (const pugi::xml_attribute name = node.attribute(attribute); *name.value() != '\0') {
                    return cleanName(name.value());
                }
            }
        }
        return {};
    }

    /// Returns true for an arc that a transformation has pressed into a line, which the chords along it follow exactly.
    static bool isFlat(const Curve &curve) {
        const std::array<double, 8> n = curve.numbers();
        return curve.kind() == CurveKind::Arc && cross({n[2], n[3]}, {n[4], n[5]}) == 0.0;
    }

    void keep(const Visit &visit, std::string_view element, SvgSubpath subpath) {
        SvgPath path;
        path.closed = subpath.closed;
        path.nodes = std::move(subpath.nodes);
        for (Vec2 &p : path.nodes) {
            p = visit.map(p);
            if (!isFinite(p)) {
                fail(visit.node, "", 0, "non-finite", "a coordinate of the path is out of range");
                return;
            }
        }
        for (Curve &curve : subpath.curves) {
            curve = curve.mapped(visit.map);
        }
        for (CurveStretch &stretch : subpath.stretches) {
            if (stretch.follows() && isFlat(subpath.curves[stretch.curve])) {
                stretch = {};
            }
        }
        path.curves = std::move(subpath.curves);
        path.stretches = std::move(subpath.stretches);
        nodeCount_ += path.nodes.size();
        if (nodeCount_ > kSpareNodes + kNodesPerByte * source_.text.size()) {
            fail(visit.node, "", 0, "too-large", "the curves need too many nodes", "give a larger tolerance");
            return;
        }
        path.isLine = element == "line" || element == "polyline";
        path.paint = visit.paint;
        path.element = elementCount_;
        path.name = nameOf(visit);
        path.offset = offsetOf(visit.named ? visit.named : visit.node);
        paths_.push_back(std::move(path));
    }

    static constexpr std::size_t kSpareNodes = 2'000'000;
    static constexpr std::size_t kNodesPerByte = 8;
    static constexpr std::size_t kSpareElements = 100'000;

    const SourceText &source_;
    pugi::xml_document xml_;
    pugi::xml_node root_;
    SvgStyles styles_;
    std::map<std::string, pugi::xml_node> byId_;
    std::vector<Use> uses_;
    AffineMap axes_;
    Vec2 viewport_;
    std::size_t nodeCount_ = 0, elementCount_ = 0;
    std::vector<SvgPath> paths_;
    Diagnostics faults_;
};

} // namespace

Result<SvgPaths> drawnPaths(const SourceText &source) {
    return SvgDrawer(source).run();
}

} // namespace forefront
