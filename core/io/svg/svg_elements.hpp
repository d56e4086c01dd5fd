#pragma once

#include <pugixml.hpp>

#include <string>
#include <string_view>

namespace forefront {

/// Returns the name of an element without its namespace prefix.
std::string_view localName(const pugi::xml_node &node);
/// Returns the namespace prefix of an element; empty: none.
std::string_view prefixOf(const pugi::xml_node &node);

/// Returns true for elements that draw nothing themselves: definitions, which other elements refer to, and words about
/// the drawing.
bool isDefinition(std::string_view name);
/// Returns true for the elements that have an outline.
bool isShape(std::string_view name);
/// Returns the reason why a visible element is left out, as the end of a message.
std::string whyIgnored(std::string_view name);

} // namespace forefront
