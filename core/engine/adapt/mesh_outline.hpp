#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/mesh/mesh_domain.hpp"
#include "core/engine/mesh/mesh_view.hpp"

namespace forefront {

/// Returns the domain that a mesh covers, with tags, names and the curves that its edges follow. Nodes that merely
/// subdivide a straight run with one tag (straight within 1e-9) are dropped, so that a new mesh can be coarser there.
/// The rest is that of domainOfMesh(). Errors: "empty-domain", "cancelled".
Result<MeshDomain> outlineOf(const MeshView &mesh, const Progress &progress = {});

/// Merges the segments of straight runs, the last step of outlineOf().
Domain withoutStraightNodes(const Domain &domain);

} // namespace forefront
