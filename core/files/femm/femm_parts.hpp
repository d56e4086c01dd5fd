#pragma once

#include "core/engine/domain/domain.hpp"
#include "core/files/source/domain_origin.hpp"
#include "core/files/source/source.hpp"

#include <cstdint>

namespace forefront {

/// Treats the parts of a problem that bound nothing as FEMM does: a node inside that no segment uses becomes an inner
/// point; such nodes, segments and labels outside the domain are left out, with a note. Changes nothing where segments
/// cross, which validation reports, and where nothing is inside. `origin`: the places of all parts, kept in step.
/// `pointTag`: tag of the new inner points.
void settleFemmParts(const SourceText &source, Domain &domain, DomainOrigin &origin, std::int32_t pointTag);

} // namespace forefront
