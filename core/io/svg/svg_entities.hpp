#pragma once

#include <pugixml.hpp>

#include <cstddef>

namespace forefront {

/// Replaces entities that the document type defines with their texts, in attributes and in the texts of elements, where
/// they may hold elements; some drawing programs write styles that way. The document must have been parsed with its
/// document type. Returns false if the texts would grow to more than `limit` bytes.
bool expandEntities(pugi::xml_document &document, std::size_t limit);

} // namespace forefront
