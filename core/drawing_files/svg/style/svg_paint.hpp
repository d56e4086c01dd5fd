#pragma once

#include "core/drawing/arrangement/arrangement.hpp"
#include "core/drawing_files/svg/style/svg_colour.hpp"
#include "core/drawing_files/svg/style/svg_css.hpp"
#include "core/drawing_files/svg/style/svg_line_style.hpp"
#include "core/drawing_files/svg/xml/svg_elements.hpp"

#include <pugixml.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>

namespace forefront {

/// Fill and stroke of a shape.
struct SvgPaint {
    bool filled = true;
    bool fillGiven = false;       ///< the drawing states the fill
    bool patterned = false;       ///< the fill is a pattern
    bool faded = false;           ///< the fill is a gradient that is transparent in parts
    bool strokePatterned = false; ///< the same for the stroke
    bool strokeFaded = false;
    bool stroked = false;
    FillRule rule = FillRule::NonZero;
    FillRule clipRule = FillRule::NonZero; ///< the rule that applies instead inside a clip path
    SvgColour fill, stroke;
    SvgColour current; ///< the property `color`
    double fillOpacity = 1.0, strokeOpacity = 1.0;
    double opacity = 1.0; ///< product of the opacities of the element and all its ancestors
    SvgLineStyle line;

    /// Returns the opacity of the fill; 0: nothing is filled.
    double fillAlpha() const { return filled ? fill.alpha * fillOpacity * opacity : 0.0; }
    double strokeAlpha() const { return stroked ? stroke.alpha * strokeOpacity * opacity : 0.0; }
};

/// The gradients and patterns of a drawing. Remembers which of them paint nothing, since any number of shapes may refer
/// to one with any number of stops.
class SvgPaintServers {
  public:
    SvgPaintServers(const SvgStyles &styles, const SvgIds &ids) : styles_(styles), ids_(ids) {}

    /// Resolves a value of `fill` or `stroke`: "none" if it refers to a gradient or pattern that paints nothing; if it
    /// refers to anything else, or to nothing, the fallback after the reference, or "none".
    std::string paintedBy(const pugi::xml_node &node, const char *property, const std::string &value);
    /// Returns true if a property is a gradient with stops that show and others that are nearly transparent.
    bool fades(const pugi::xml_node &node, const char *property);

    const SvgStyles &styles() const { return styles_; }
    const SvgIds &ids() const { return ids_; }

  private:
    enum class Coverage : std::uint8_t { Nothing, Parts, Everything };

    /// Returns Nothing if a gradient has no stops or only transparent ones, or a pattern is empty, and Parts for a
    /// gradient that fades(). Stops and contents may be inherited from another gradient or pattern.
    Coverage coverageOf(pugi::xml_node server);
    Coverage coverageOfStops(const pugi::xml_node &gradient) const;
    pugi::xml_node origin(const pugi::xml_node &server) const;

    const SvgStyles &styles_;
    const SvgIds &ids_;
    std::unordered_map<std::size_t, Coverage> known_; ///< by the hash value of the element
};

/// Returns the paint of an element: its own where given, otherwise inherited.
SvgPaint paintOf(const pugi::xml_node &node, SvgPaintServers &servers, const SvgPaint &inherited);

} // namespace forefront
