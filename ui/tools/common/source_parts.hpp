#pragma once

#include "core/drawing/picking/pick_index.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace forefront {

using SourcePart = PickIndex::SourceHit::Part;

/// Returns the corner of a box that a part of a source is, as in SourceBox::corners().
std::optional<std::size_t> cornerOfPart(const SizeSource &source, SourcePart part);

/// Returns the place of the part of a source that was hit at `place`; `reach`: distance at which the centre counts.
Vec2 placeOfPart(const SizeSource &source, SourcePart part, Vec2 place, double reach);

/// Returns a source with one of its parts moved: an end, a corner, the centre or the rim.
SizeSource withMovedPart(SizeSource source, SourcePart part, Vec2 to);

/// Returns a name such as "point 3" that no source has, so that the inspector can tell which source wins.
std::string freeSourceName(const Document &document, const std::string &kind);

} // namespace forefront
