#pragma once

#include <pugixml.hpp>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace forefront {

constexpr std::string_view kBlanks = " \t\r\n\f"; ///< between words in attributes and style sheets

/// Returns the name of an element without its namespace prefix.
std::string_view localName(const pugi::xml_node &node);
/// Returns true for elements of SVG rather than private data of editors: those whose name has no prefix, the prefix
/// "svg", or one that is declared for SVG in the element, in one around it, or in the outermost one.
bool isOfSvg(const pugi::xml_node &node);
/// Returns the reference of an element: its attribute href or, if that is empty, the first one with any prefix, as in
/// "xlink:href".
std::string_view hrefOf(const pugi::xml_node &node);
/// Returns the byte of the text at which an element begins; 0 if unknown.
std::size_t offsetOf(const pugi::xml_node &node);

/// The elements of a drawing by their id.
using SvgIds = std::map<std::string, pugi::xml_node, std::less<>>;
/// Returns the id in a value such as "url(#id)", also within quotes; empty if it has another form.
std::string_view idOfUrl(std::string_view value);
/// Returns the element that a value such as "url(#id)" refers to; null if there is none.
pugi::xml_node targetOf(std::string_view value, const SvgIds &ids);

/// Returns true for elements that draw nothing themselves: definitions, which other elements refer to, and
/// metadata.
bool isDefinition(std::string_view name);
/// Returns true if requiredExtensions or systemLanguage excludes an element for an English reader without extensions.
bool isExcluded(const pugi::xml_node &node);
/// Returns true if `outer` is one of the nearest 1,000 ancestors of `node`.
bool isAncestor(const pugi::xml_node &outer, const pugi::xml_node &node);
/// Returns true for the elements that have an outline.
bool isShape(std::string_view name);

} // namespace forefront
