#pragma once

#include <pugixml.hpp>

#include <cstddef>
#include <cstdint>

namespace forefront {

enum class EntityExpansion : std::uint8_t {
    Done,
    TooLarge, ///< the texts would grow beyond the limit
    Malformed ///< an entity holds elements that are malformed
};

/// Replaces entities that the document type defines with their texts, in attributes and in the texts of elements, where
/// they may hold elements; some drawing programs write styles that way. The document must have been parsed with its
/// document type. `limit`: number of bytes that the texts may grow to.
EntityExpansion expandEntities(pugi::xml_document &document, std::size_t limit);

} // namespace forefront
