#pragma once

#include "core/base/result.hpp"
#include "core/domain/domain.hpp"
#include "core/mesh/mesh.hpp"

namespace forefront {

/// The domain that a mesh covers, with tags and names, ready to be meshed anew: nodes that only divide a straight part
/// of one tag are dropped (straight within 1e-9), so that a coarser mesh is possible, too. Faults: "empty-domain".
Result<Domain> outlineOf(const Mesh &mesh);

/// The second part of it: merges the segments of straight runs.
Domain withoutStraightNodes(const Domain &domain);

} // namespace forefront
