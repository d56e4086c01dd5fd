#pragma once

#include "core/drawing_files/svg/style/svg_css.hpp"
#include "core/drawing_files/svg/style/svg_paint.hpp"
#include "core/drawing_files/svg/xml/svg_elements.hpp"
#include "core/files/source/source.hpp"

#include <pugixml.hpp>

#include <string>
#include <string_view>

namespace forefront {

/// Reports unsupported styles and animations of an element that would change its appearance in a browser.
void noteUnusedStyle(const SourceText &source, const SvgStyles &styles, const SvgIds &ids, const pugi::xml_node &node);
/// Reports that the paint of a shape, a pattern or a gradient that fades to transparent, counts as solid.
void notePaint(const SourceText &source, const SvgPaint &paint, const pugi::xml_node &node);
/// Returns the fault of a drawing without visible paths, with the cause, if known, and a remedy.
Diagnostic nothingDrawn(const SourceText &source, const pugi::xml_node &root);
/// Returns the reason why a visible element is left out, as the end of a message.
std::string whyIgnored(std::string_view name);

} // namespace forefront
