#pragma once

#include "core/drawing/document/document.hpp"

namespace forefront {

/// Returns true if two documents describe the same domain: they have the same shapes (ids included), markers and names.
bool sameDomain(const Document &a, const Document &b);

/// Returns true if two documents have the same sketch constraints.
bool sameConstraints(const Document &a, const Document &b);

/// Returns true if two documents have the same shapes (ids included), markers, names, constraints, spacing, options,
/// limits and background picture, regardless of where they are in memory; ignores `nextId`.
bool sameContent(const Document &a, const Document &b);

/// Returns true if two documents have the same mesh: they differ at most in limits, background picture, guides, unit
/// and constraints. What constraints move is in the shapes.
bool sameForMesher(const Document &a, const Document &b);

} // namespace forefront
