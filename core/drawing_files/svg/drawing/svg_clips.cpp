#include "core/drawing_files/svg/drawing/svg_drawer.hpp"
#include "core/drawing_files/svg/xml/svg_elements.hpp"
#include "core/files/common/names.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace forefront {

namespace {

constexpr double kHides = 0.02; ///< greatest luminance that counts as black in a mask; likewise for white

std::array<double, 6> numbersOf(const AffineMap &map) {
    return {map.a, map.b, map.c, map.d, map.e, map.f};
}

} // namespace

class SvgDrawer::ElementBox {
  public:
    ElementBox(SvgDrawer &drawer, const Visit &visit) : drawer_(drawer), visit_(visit) {}

    /// Returns the map from the unit square to the box.
    AffineMap frame() {
        if (!frame_) {
            const Box2 box = drawer_.boxOf(visit_);
            const Vec2 size = box.empty() ? Vec2{} : box.size(), corner = box.empty() ? Vec2{} : box.min;
            frame_ = AffineMap{size.x, 0, 0, size.y, corner.x, corner.y};
        }
        return *frame_;
    }

  private:
    SvgDrawer &drawer_;
    const Visit &visit_;
    std::optional<AffineMap> frame_;
};

/// Limits an element by the clip path and the mask that it names, and by those that these name in turn.
void SvgDrawer::limitBy(Visit &visit, std::vector<Visit> &open) {
    if (measuresBox_) {
        return;
    }
    ElementBox box(*this, visit);
    std::vector<Visit> referrers;
    const auto follow = [&](const Visit &referrer) {
        for (const auto &[property, element] : {std::pair{"clip-path", "clipPath"}, {"mask", "mask"}}) {
            if (const pugi::xml_node target = clipTarget(referrer, property, element)) {
                visit.limit = addClip(target, referrer, visit.limit, box, open);
                referrers.push_back(referrer);
                referrers.back().node = target;
                referrers.back().use = uses_.size() - 1;
            }
        }
    };
    follow(visit);
    while (!referrers.empty() && faults_.empty()) {
        const Visit referrer = referrers.back();
        referrers.pop_back();
        ++visited_;
        follow(referrer);
    }
}

/// Returns the clip path or mask that an element names; null with a note if there is none.
pugi::xml_node SvgDrawer::clipTarget(const Visit &visit, std::string_view property, std::string_view expected) const {
    const std::string value = styles_.valueAsWritten(visit.node, property);
    if (value.empty() || value == "none" || value == "inherit") {
        return {};
    }
    const pugi::xml_node target = targetOf(value, byId_);
    const bool known = target && localName(target) == expected;
    if (known && !draws(visit.use, target)) {
        return target;
    }
    if (reports_) {
        const std::string element = '<' + std::string(expected) + '>';
        note(visit.node, "svg-" + std::string(property),
             std::string(property) + ' ' + inQuotes(value) + " is ignored: " +
                 (known                    ? "it refers to itself"
                  : idOfUrl(value).empty() ? "only url(#id) of a " + element + " of the drawing is read"
                                           : "the drawing has no " + element + " with that id"));
    }
    return {};
}

/// Adds a clip path or mask in the coordinates of the element that names it, unless it is known, and returns its index.
std::uint32_t SvgDrawer::addClip(const pugi::xml_node &target, const Visit &referrer, std::uint32_t within,
                                 ElementBox &box, std::vector<Visit> &open) {
    const bool isMask = localName(target) == "mask";
    uses_.push_back({target, referrer.use});
    AffineMap map = referrer.map;
    const char *units = target.attribute(isMask ? "maskContentUnits" : "clipPathUnits").value();
    if (isMask) {
        within = maskRegion(target, referrer, within, box);
    } else { // in units of the box, too, its transform acts in the coordinates of the element
        map = map * transformOf(target, viewportBox(referrer.viewport));
    }
    if (std::string_view(units) == "objectBoundingBox") {
        map = map * box.frame();
    }
    const auto [known, added] = clipOf_.try_emplace({2 * target.hash_value(), numbersOf(map), within},
                                                    static_cast<std::uint32_t>(clips_.size()));
    if (!added) {
        return known->second;
    }
    const bool alpha = styles_.value(target, "mask-type") == "alpha";
    clips_.push_back({within, !isMask ? SvgClipKind::ClipPath
                              : alpha ? SvgClipKind::AlphaMask
                                      : SvgClipKind::LuminanceMask});
    Visit around = clipContents(target, map);
    around.viewport = referrer.viewport;
    around.use = uses_.size() - 1;
    around.partOf = known->second;
    clips_.back().name = nameOf(around);
    for (pugi::xml_node child = target.last_child(); child; child = child.previous_sibling()) {
        open.push_back(inside(around, child));
    }
    return known->second;
}

/// Returns the style that the contents of a clip path or mask inherit: from its own ancestors, not from the clipped
/// elements.
SvgDrawer::Visit SvgDrawer::clipContents(const pugi::xml_node &target, const AffineMap &map) {
    std::vector<pugi::xml_node> around;
    for (pugi::xml_node node = target; node.type() == pugi::node_element; node = node.parent()) {
        around.push_back(node);
    }
    Visit visit{target, map, viewport_};
    for (auto node = around.rbegin(); node != around.rend(); ++node) {
        visit.node = *node;
        visit.paint = paintOf(*node, servers_, visit.paint);
        visit.fontSize = fontSizeOf(*node, visit.fontSize);
        inheritVisibility(visit);
    }
    visit.paint.opacity = 1.0;
    return visit;
}

/// Returns the rectangle outside of which a mask shows nothing, as a clip; `within` if the mask gives none: the default
/// is larger than the element.
std::uint32_t SvgDrawer::maskRegion(const pugi::xml_node &mask, const Visit &referrer, std::uint32_t within,
                                    ElementBox &box) {
    const bool user = std::string_view(mask.attribute("maskUnits").value()) == "userSpaceOnUse";
    constexpr std::pair<const char *, SvgExtent> kSides[] = {
        {"x", SvgExtent::Width}, {"y", SvgExtent::Height}, {"width", SvgExtent::Width}, {"height", SvgExtent::Height}};
    constexpr double kDefault[] = {-0.1, -0.1, 1.2, 1.2};
    double side[4] = {};
    bool given = false;
    for (std::size_t k = 0; k < 4; ++k) {
        const auto &[attribute, extent] = kSides[k];
        const std::string_view text = mask.attribute(attribute).value();
        const double whole = !user ? 1.0 : extent == SvgExtent::Width ? referrer.viewport.x : referrer.viewport.y;
        const auto value = userLength(text, extent, user ? referrer.viewport : Vec2{1.0, 1.0}, referrer.fontSize);
        side[k] = value.value_or(kDefault[k] * whole);
        given = given || value;
    }
    if (!given || !(side[2] > 0.0 && side[3] > 0.0)) {
        return within;
    }
    const AffineMap map = user ? referrer.map : referrer.map * box.frame();
    return addViewport(mask, map * AffineMap{side[2], 0, 0, side[3], side[0], side[1]}, within);
}

/// Adds the image of the unit square as a clip, unless it is known, and returns its index.
std::uint32_t SvgDrawer::addViewport(const pugi::xml_node &node, const AffineMap &frame, std::uint32_t within) {
    // Even keys are clip paths and masks.
    const auto [known, added] = clipOf_.try_emplace({2 * node.hash_value() + 1, numbersOf(frame), within},
                                                    static_cast<std::uint32_t>(clips_.size()));
    if (added) {
        SvgPath path;
        path.nodes = {frame({0, 0}), frame({1, 0}), frame({1, 1}), frame({0, 1})};
        path.closed = true;
        path.element = elementCount_++;
        path.name = nameOf({node, frame, {}});
        path.offset = offsetOf(node);
        clips_.push_back({within, SvgClipKind::Viewport, {std::move(path)}, frame});
    }
    return known->second;
}

/// Returns the box of an element in its own coordinates, without what clips hide.
Box2 SvgDrawer::boxOf(const Visit &visit) {
    Visit element = visit;
    element.limit = element.partOf = kNoClip;
    element.map = {};
    std::vector<SvgPath> paths;
    paths.swap(paths_);
    const std::size_t nodes = nodeCount_;
    const std::optional<double> tolerance = tolerance_;
    const double stretch = visit.map.stretch();
    if (tolerance_ && stretch > 0.0) {
        *tolerance_ /= stretch;
    }
    const bool reports = std::exchange(reports_, false);
    measuresBox_ = true;
    std::vector<Visit> open;
    contents(element, localName(element.node), open);
    visitAll(open);
    Box2 box;
    for (const SvgPath &path : paths_) {
        box.add(path.bounds());
    }
    measuresBox_ = false;
    reports_ = reports;
    tolerance_ = tolerance;
    nodeCount_ = nodes;
    paths_.swap(paths);
    return box;
}

/// Returns false, with a note, for an element that has no effect in the clip path it is drawn into.
bool SvgDrawer::drawnInClip(const Visit &visit, std::string_view name) const {
    const bool inClipPath = visit.partOf != kNoClip && clips_[visit.partOf].kind == SvgClipKind::ClipPath;
    if (!inClipPath || isShape(name) || name == "text" || (name == "use" && !visit.named)) {
        return true;
    }
    if (reports_) {
        note(visit.node, "svg-element",
             '<' + std::string(name) +
                 "> is ignored: a clip path consists of shapes and <use> elements that draw shapes");
    }
    return false;
}

/// Adds a path to the clip path or mask that it is drawn into.
void SvgDrawer::keepPart(const Visit &visit, SvgPath path) {
    SvgClip &clip = clips_[visit.partOf];
    if (path.name.empty()) {
        path.name = clip.name;
    }
    const SvgPaint &paint = visit.paint;
    if (clip.kind == SvgClipKind::ClipPath) {
        path.paint.rule = paint.clipRule;
        clip.parts.push_back(std::move(path));
        return;
    }
    const bool image = localName(visit.node) == "image", plain = paint.fill.plain && !image;
    const double alpha = image ? 1.0 : paint.fillAlpha();
    const bool shaded = plain && clip.kind == SvgClipKind::LuminanceMask;
    const double shade = shaded ? paint.fill.luminance : 1.0;
    path.removes = alpha > 0.0 && shade <= kHides;
    const bool removesLittle = path.removes && alpha < 1.0 - kHides;
    const bool showsPartly = alpha > 0.0 && !path.removes && alpha * shade < 1.0 - kHides;
    const bool filtered = alpha > 0.0 && !styles_.value(visit.node, "filter").empty();
    if (reports_ &&
        (paint.strokeAlpha() > 0.0 || (alpha > 0.0 && !plain) || removesLittle || showsPartly || filtered)) {
        note(visit.node, "svg-mask",
             "masks are read as clips: what gradients, images, filters and partial shades in a mask paint is shown in "
             "full, and strokes in a mask are ignored");
    }
    if (alpha > 0.0 && !removesLittle) {
        clip.parts.push_back(std::move(path));
    }
}

} // namespace forefront
