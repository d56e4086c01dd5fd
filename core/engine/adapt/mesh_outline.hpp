#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/mesh/cracks.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <vector>

namespace forefront {

/// Returns the domain that a mesh covers, with tags, names and the curves that its edges follow. Nodes that merely
/// subdivide a straight run with one tag (straight within 1e-9) are dropped, so that a new mesh can be coarser there.
/// `cracks`: as for domainOfMesh(). Errors: "empty-domain", "cancelled".
Result<Domain> outlineOf(const MeshView &mesh, const Progress &progress = {}, std::vector<OpenLine> *cracks = nullptr);

/// Merges the segments of straight runs, the last step of outlineOf().
Domain withoutStraightNodes(const Domain &domain);

} // namespace forefront
