#pragma once

#include "core/drawing_files/svg/drawing/svg_drawing.hpp"
#include "core/drawing_files/svg/style/svg_css.hpp"
#include "core/drawing_files/svg/values/svg_pen.hpp"
#include "core/drawing_files/svg/values/svg_viewport.hpp"
#include "core/drawing_files/svg/xml/svg_elements.hpp"

#include <pugixml.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace forefront {

/// Walks over the elements of an SVG drawing and collects its shapes, clip paths and masks.
class SvgDrawer {
  public:
    explicit SvgDrawer(const SourceText &source) : source_(source) {}

    Result<SvgPaths> run();

  private:
    /// An element to visit, with its inherited style.
    struct Visit {
        pugi::xml_node node;
        AffineMap map;
        Vec2 viewport;
        bool visible = true;
        SvgPaint paint = {};
        double fontSize = kMediumFont;  ///< in user units
        std::size_t use = kNoUse;       ///< the innermost <use>, clip path or mask it is drawn by, in uses_
        std::uint32_t limit = kNoClip;  ///< the clip that limits it
        std::uint32_t partOf = kNoClip; ///< the clip that it is drawn into; none: the drawing itself
        std::optional<Vec2> size = {};  ///< of a <symbol> or <svg> drawn by a <use>
        pugi::xml_node named = {};      ///< the <use> that draws this very element
    };
    /// A <use>, clip path or mask being drawn: its target, and the enclosing one.
    struct Use {
        pugi::xml_node target;
        std::size_t outer;
    };
    static constexpr auto kNoUse = static_cast<std::size_t>(-1);
    /// A clip path or mask in the coordinates of an element, within another clip.
    using ClipKey = std::tuple<std::size_t, std::array<double, 6>, std::uint32_t>;
    /// The box of an element in its own coordinates; computed when first needed.
    class ElementBox;

    // svg_drawing.cpp
    void fail(const pugi::xml_node &node, const char *attribute, std::size_t within, std::string code,
              std::string message, std::string advice = {});
    void note(const pugi::xml_node &node, std::string_view code, const std::string &message) const;
    void collect();
    void addSheet(const pugi::xml_node &node);
    void placeAxes();
    void walk(std::optional<double> tolerance);
    void visitAll(std::vector<Visit> &open);
    void element(Visit &visit, std::vector<Visit> &open);
    void contents(Visit &visit, std::string_view name, std::vector<Visit> &open);
    static Visit inside(const Visit &outer, const pugi::xml_node &child);
    bool hidden(Visit &visit);
    void inheritVisibility(Visit &visit) const;
    bool enterViewport(Visit &visit, std::string_view name);
    void chosen(const Visit &visit, std::vector<Visit> &open) const;
    void use(Visit &visit, std::vector<Visit> &open);
    AffineMap placeOf(const Visit &visit);
    bool draws(std::size_t use, const pugi::xml_node &target) const;

    // svg_values.cpp
    bool isGiven(const Visit &visit, const char *property) const;
    double fontSizeOf(const pugi::xml_node &node, double inherited) const;
    SvgLineStyle lineStyleOf(const Visit &visit) const;
    static std::optional<double> userStrokeLength(const Visit &visit, std::string_view text);
    static std::vector<double> dashesOf(const Visit &visit, std::string_view text);
    double length(const Visit &visit, const char *attribute, SvgExtent extent);
    std::optional<double> givenLength(const Visit &visit, const char *attribute, SvgExtent extent);
    Box2 transformBox(const Visit &visit);
    AffineMap transformOf(const pugi::xml_node &node, const Box2 &reference);
    void leaveOut(const pugi::xml_node &node, const char *attribute, std::size_t within, std::string code,
                  const std::string &message, const std::string &value = {}, std::string_view ignored = "it");
    std::size_t byteOf(const pugi::xml_node &node, const char *attribute, std::size_t within) const;

    // svg_shapes.cpp
    void shape(const Visit &visit, std::string_view name);
    void roundShape(const Visit &visit, std::string_view name, SvgPen &pen);
    static std::string nameOf(const Visit &visit);
    void keep(const Visit &visit, std::string_view element, SvgSubpath subpath, double dashScale);

    // svg_clips.cpp
    void limitBy(Visit &visit, std::vector<Visit> &open);
    pugi::xml_node clipTarget(const Visit &visit, std::string_view property, std::string_view expected) const;
    std::uint32_t addClip(const pugi::xml_node &target, const Visit &referrer, std::uint32_t within, ElementBox &box,
                          std::vector<Visit> &open);
    Visit clipContents(const pugi::xml_node &target, const AffineMap &map);
    std::uint32_t maskRegion(const pugi::xml_node &mask, const Visit &referrer, std::uint32_t within, ElementBox &box);
    std::uint32_t addViewport(const pugi::xml_node &node, const AffineMap &frame, std::uint32_t within);
    Box2 boxOf(const Visit &visit);
    bool drawnInClip(const Visit &visit, std::string_view name) const;
    void keepPart(const Visit &visit, SvgPath path);

    // svg_visible.cpp
    void choosePage();
    void notePage() const;
    void cropFarFromPage(double tolerance);
    Box2 visibleBox() const;
    void dropWideViewports();

    static constexpr std::size_t kSpareNodes = 2'000'000;
    static constexpr std::size_t kNodesPerByte = 8;
    static constexpr std::size_t kSpareElements = 100'000;

    const SourceText &source_;
    pugi::xml_document xml_;
    pugi::xml_node root_;
    SvgStyles styles_;
    SvgIds byId_;
    SvgPaintServers servers_{styles_, byId_};
    std::vector<Use> uses_;
    AffineMap axes_;
    Vec2 viewport_;
    std::optional<AffineMap> page_;   ///< maps the unit square to the visible area; absent: all is visible
    std::optional<double> tolerance_; ///< of the curves; absent: only measure
    bool reports_ = false;
    bool cropsFill_ = false;   ///< as in SvgPaths
    bool measuresBox_ = false; ///< of an element, without its clips
    std::size_t visited_ = 0, nodeCount_ = 0, elementCount_ = 0;
    std::vector<SvgPath> paths_;
    std::vector<SvgClip> clips_;
    std::map<ClipKey, std::uint32_t> clipOf_;
    Diagnostics faults_;
};

} // namespace forefront
