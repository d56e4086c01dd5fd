#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/files/source/source.hpp"

#include <string_view>

namespace forefront {

/// Reads geometries in well-known text, one or more: polygons bound the domain, each a region if there are several;
/// lines and points are constraints. Z and M are ignored. Faults: bad-number, bad-syntax, bad-count, unknown-geometry,
/// empty-domain; with ImportOptions::strict, coordinates in degrees.
Result<Domain> readWkt(const SourceText &source);
/// Returns true if the first bytes of a file show that it is well-known text.
bool looksLikeWkt(std::string_view head);

} // namespace forefront
