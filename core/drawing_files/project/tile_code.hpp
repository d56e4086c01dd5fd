#pragma once

#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace forefront {

/// Encodes a painted tile as short text: its 256 floats as little-endian words, runs of equal words packed (control
/// byte c < 128: c + 1 words follow; c >= 128: the next word c - 126 times), then base64. The bits are kept exactly.
std::string encodeTile(const PaintedSpacing::Tile &tile);
/// Decodes a tile; std::nullopt if the text does not encode exactly one tile.
std::optional<PaintedSpacing::Tile> decodeTile(std::string_view text);

} // namespace forefront
