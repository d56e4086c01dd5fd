#include "core/drawing_files/svg/drawing/svg_drawer.hpp"
#include "core/drawing_files/svg/style/svg_notes.hpp"
#include "core/drawing_files/svg/values/svg_axes.hpp"
#include "core/drawing_files/svg/xml/svg_elements.hpp"
#include "core/drawing_files/svg/xml/svg_entities.hpp"
#include "core/engine/domain/coordinate_range.hpp"
#include "core/files/common/names.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace forefront {

Box2 SvgPath::box() const {
    Box2 box;
    for (const Vec2 node : nodes) {
        box.add(node);
    }
    return box;
}

Box2 SvgPath::bounds() const {
    Box2 box = this->box();
    for (const CurveStretch &stretch : stretches) {
        if (stretch.follows()) {
            box.add(curves[stretch.curve].bounds(stretch.t0, stretch.t1));
        }
    }
    return box;
}

double SvgPath::reach() const {
    return strokeArea ? 0.5 * paint.line.width * frame.stretch() : 0.0;
}

double SvgPath::farthestReach() const {
    const double corners = paint.line.corner == BandCorner::Miter ? paint.line.miterLimit : 1.0;
    return std::max(corners, std::numbers::sqrt2) * reach();
}

bool SvgPath::drawnAsLine() const {
    return isLine && !closed && paint.filled && !paint.fillGiven && paint.stroked;
}

bool SvgPath::painted() const {
    return paint.filled && nodes.size() > 2 && !drawnAsLine();
}

bool SvgPath::covers() const {
    return painted() || strokeArea;
}

Result<SvgPaths> SvgDrawer::run() {
    const pugi::xml_parse_result parsed =
        xml_.load_buffer(source_.text.data(), source_.text.size(), pugi::parse_default | pugi::parse_doctype);
    if (!parsed) {
        return Diagnostics{faultAt(source_, static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0)),
                                   "xml-syntax", std::string("the XML is malformed: ") + parsed.description())};
    }
    root_ = xml_.document_element();
    if (localName(root_) != "svg") {
        return Diagnostics{faultAt(source_, 0, "not-svg", "the file is not an SVG drawing")};
    }
    switch (expandEntities(xml_, kSpareNodes + kNodesPerByte * source_.text.size())) {
    case EntityExpansion::TooLarge:
        return Diagnostics{
            faultAt(source_, 0, "too-large", "the entities of the document type expand to too much text")};
    case EntityExpansion::Malformed:
        return Diagnostics{faultAt(source_, 0, "xml-syntax", "an entity of the document type holds malformed XML")};
    case EntityExpansion::Done:
        break;
    }
    collect();
    placeAxes();
    walk(std::nullopt);
    choosePage();
    const double size = visibleBox().diagonal();
    constexpr double kFineness = 2000.0;
    const double requested = source_.options.curveTolerance;
    const double tolerance = requested > 0.0 ? requested : size / kFineness;
    if (faults_.empty() && (!std::isfinite(size) || !(size > 0.0))) {
        reports_ = true;
        walk(1.0); // what is left out may be why nothing remains
        if (faults_.empty()) {
            faults_.push_back(nothingDrawn(source_, root_));
        }
    }
    if (faults_.empty()) {
        reports_ = true;
        walk(tolerance);
    }
    if (!faults_.empty()) {
        return faults_;
    }
    if (page_) {
        notePage();
        cropFarFromPage(tolerance);
    }
    dropWideViewports();
    return SvgPaths{std::move(paths_), std::move(clips_), size, tolerance, cropsFill_};
}

/// Records a fault at byte `within` of an attribute value, if it can be located in the text.
void SvgDrawer::fail(const pugi::xml_node &node, const char *attribute, std::size_t within, std::string code,
                     std::string message, std::string advice) {
    if (faults_.empty()) {
        faults_.push_back(
            faultAt(source_, byteOf(node, attribute, within), std::move(code), std::move(message), std::move(advice)));
    }
}

void SvgDrawer::note(const pugi::xml_node &node, std::string_view code, const std::string &message) const {
    source_.note(code, message, offsetOf(node));
}

/// Finds the style sheets and the elements that others refer to.
void SvgDrawer::collect() {
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

void SvgDrawer::addSheet(const pugi::xml_node &node) {
    std::string css;
    for (const pugi::xml_node part : node.children()) {
        css += part.value();
    }
    styles_.addSheet(css, [&](const std::string &rule) {
        note(node, "svg-style",
             "CSS rules for " + inQuotes(rule) +
                 " are ignored: only elements, .class, #id, descendants and children are supported");
    });
}

void SvgDrawer::placeAxes() {
    const SvgAxes axes = axesOf(root_);
    const std::string box = root_.attribute("viewBox").value();
    if (!box.empty() && !parseViewBox(box)) {
        reports_ = true;
        leaveOut(root_, "viewBox", 0, "bad-view-box", "invalid view box", inQuotes(box));
        reports_ = false;
    }
    axes_ = axes.map;
    if (axes.page && !source_.options.beyondPage) {
        const Vec2 corner = axes.page->corner, size = axes.page->size;
        const AffineMap page = axes.map * AffineMap{size.x, 0, 0, size.y, corner.x, corner.y};
        const Vec2 ends[] = {page({0, 0}), page({1, 1})};
        if (std::all_of(std::begin(ends), std::end(ends), [](Vec2 end) { return isFinite(end) && !tooLarge(end); })) {
            page_ = page;
        }
    }
    viewport_ = axes.viewport;
    source_.measured(axes.lengthUnit);
    if (!axes.unit.empty()) {
        note(root_, "svg-units", "coordinates are in " + unitName(axes.unit) + ", the unit of the document's size");
    }
}

/// Visits all shapes; without a tolerance, only measures them.
void SvgDrawer::walk(std::optional<double> tolerance) {
    tolerance_ = tolerance;
    uses_.clear();
    paths_.clear();
    clips_.clear();
    clipOf_.clear();
    visited_ = nodeCount_ = 0;
    std::vector<Visit> open = {{root_, axes_, viewport_}};
    if (page_ && tolerance) {
        open.front().limit = addViewport(root_, *page_, kNoClip);
        clips_.front().parts.front().name = "page";
    }
    visitAll(open);
}

void SvgDrawer::visitAll(std::vector<Visit> &open) {
    while (!open.empty() && faults_.empty()) {
        Visit visit = open.back();
        open.pop_back();
        if (visit.node.type() != pugi::node_element) {
            continue;
        }
        if (++visited_ > kSpareElements + source_.text.size()) {
            fail(visit.node, "", 0, "too-large",
                 "nested <use> elements, clip paths and entities expand to too many elements");
            return;
        }
        element(visit, open);
    }
}

void SvgDrawer::element(Visit &visit, std::vector<Visit> &open) {
    const std::string_view name = localName(visit.node);
    const bool drawn = visit.size.has_value() || !isDefinition(name);
    if (!drawn || !isOfSvg(visit.node)) {
        return; // definitions, and private data of editors
    }
    if (hidden(visit) || !drawnInClip(visit, name)) {
        return;
    }
    if (reports_) {
        noteUnusedStyle(source_, styles_, byId_, visit.node);
    }
    visit.paint = paintOf(visit.node, servers_, visit.paint);
    visit.fontSize = fontSizeOf(visit.node, visit.fontSize);
    visit.paint.line = lineStyleOf(visit);
    visit.map = visit.map * transformOf(visit.node, transformBox(visit));
    if (name == "use") {
        visit.map = visit.map * placeOf(visit);
    }
    limitBy(visit, open);
    contents(visit, name, open);
}

/// Draws an element, or opens its children.
void SvgDrawer::contents(Visit &visit, std::string_view name, std::vector<Visit> &open) {
    const bool masked = visit.partOf != kNoClip;
    if ((name == "svg" || name == "symbol") && !enterViewport(visit, name)) {
        return;
    }
    if (name == "svg" || name == "symbol" || name == "g" || name == "a") {
        for (pugi::xml_node child = visit.node.last_child(); child; child = child.previous_sibling()) {
            open.push_back(inside(visit, child));
        }
    } else if (name == "switch") {
        chosen(visit, open);
    } else if (name == "use") {
        use(visit, open);
    } else if (isShape(name) || (masked && name == "image")) {
        if (visit.visible) {
            shape(visit, name);
        } else if (reports_) {
            note(visit.node, "svg-hidden", "hidden shapes are ignored (visibility)");
        }
    } else if (reports_) {
        note(visit.node, "svg-element", '<' + std::string(name) + "> is ignored" + whyIgnored(name));
    }
}

SvgDrawer::Visit SvgDrawer::inside(const Visit &outer, const pugi::xml_node &child) {
    return {child,          outer.map, outer.viewport, outer.visible, outer.paint,
            outer.fontSize, outer.use, outer.limit,    outer.partOf};
}

/// Inherits the visibility. Returns true if the element and its children are not displayed.
bool SvgDrawer::hidden(Visit &visit) {
    if (isExcluded(visit.node)) {
        if (reports_) {
            note(visit.node, "svg-hidden",
                 "elements for other languages or programs are ignored (systemLanguage, requiredExtensions)");
        }
        return true;
    }
    if (styles_.value(visit.node, "display") == "none") {
        if (reports_) {
            note(visit.node, "svg-hidden", "hidden elements are ignored (display: none)");
        }
        return true;
    }
    inheritVisibility(visit);
    return false;
}

void SvgDrawer::inheritVisibility(Visit &visit) const {
    const std::string own = styles_.value(visit.node, "visibility");
    if (!own.empty() && own != "inherit") {
        visit.visible = own != "hidden" && own != "collapse";
    }
}

/// Enters the viewport of a <symbol> or <svg>. Returns false if it shows nothing.
bool SvgDrawer::enterViewport(Visit &visit, std::string_view name) {
    if (visit.node == root_) {
        return true;
    }
    if (name == "svg") {
        visit.map = visit.map * placeOf(visit);
    }
    const auto extent = [&](const char *attribute, double given, SvgExtent kind) {
        if (given > 0.0) {
            return given;
        }
        const double whole = kind == SvgExtent::Width ? visit.viewport.x : visit.viewport.y;
        return name == "svg" ? givenLength(visit, attribute, kind).value_or(whole) : whole;
    };
    const Vec2 given = visit.size.value_or(Vec2{});
    const Vec2 size{extent("width", given.x, SvgExtent::Width), extent("height", given.y, SvgExtent::Height)};
    if (name == "svg" && ((size.x <= 0.0 && isGiven(visit, "width")) || (size.y <= 0.0 && isGiven(visit, "height")))) {
        return false;
    }
    const std::string overflow = styles_.value(visit.node, "overflow");
    if (size.x > 0.0 && size.y > 0.0 && overflow != "visible" && overflow != "auto" && !measuresBox_) {
        visit.limit = addViewport(visit.node, visit.map * AffineMap{size.x, 0, 0, size.y, 0, 0}, visit.limit);
    }
    const auto box = parseViewBox(visit.node.attribute("viewBox").value());
    if (box && size.x > 0.0 && size.y > 0.0) {
        visit.map = visit.map * viewBoxMap(*box, size, visit.node.attribute("preserveAspectRatio").value());
        visit.viewport = box->size;
    } else if (size.x > 0.0 && size.y > 0.0) {
        visit.viewport = size;
    }
    return true;
}

/// Returns the first child of a <switch> that a program without extensions draws.
void SvgDrawer::chosen(const Visit &visit, std::vector<Visit> &open) const {
    for (const pugi::xml_node child : visit.node.children()) {
        if (child.type() == pugi::node_element && localName(child) != "foreignObject" && !isExcluded(child)) {
            open.push_back(inside(visit, child));
            return;
        }
    }
}

void SvgDrawer::use(Visit &visit, std::vector<Visit> &open) {
    const std::string_view href = hrefOf(visit.node);
    const auto found = href.starts_with('#') ? byId_.find(std::string(href.substr(1))) : byId_.end();
    if (found == byId_.end()) {
        if (reports_) {
            note(visit.node, "svg-use",
                 "<use> of " + inQuotes(href) + " is ignored: the drawing has no element with that id");
        }
        return;
    }
    const pugi::xml_node target = found->second;
    if (draws(visit.use, target) || isAncestor(target, visit.node)) {
        leaveOut(visit.node, "", 0, "use-cycle", "<use> draws the element that it is part of", inQuotes(href));
        return;
    }
    uses_.push_back({target, visit.use});
    Visit drawn = inside(visit, target);
    drawn.use = uses_.size() - 1;
    drawn.named = visit.node;
    if (localName(target) == "symbol" || localName(target) == "svg") {
        drawn.size = Vec2{length(visit, "width", SvgExtent::Width), length(visit, "height", SvgExtent::Height)};
    }
    open.push_back(drawn);
}

/// Returns the map to the place that the attributes x and y give.
AffineMap SvgDrawer::placeOf(const Visit &visit) {
    return AffineMap::translation({length(visit, "x", SvgExtent::Width), length(visit, "y", SvgExtent::Height)});
}

/// Returns true if a <use>, clip path or mask, or one around it, draws an element.
bool SvgDrawer::draws(std::size_t use, const pugi::xml_node &target) const {
    while (use != kNoUse && uses_[use].target != target) {
        use = uses_[use].outer;
    }
    return use != kNoUse;
}

Result<SvgPaths> drawnPaths(const SourceText &source) {
    return SvgDrawer(source).run();
}

} // namespace forefront
