#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/periodic.hpp"
#include "core/engine/mesh/cracks.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// The domain that a mesh covers, with what makes such a mesh of it again.
struct MeshDomain {
    Domain domain;
    std::vector<std::int32_t> cracks{};   ///< tags of its inner lines along which the mesh is open, ascending
    std::vector<PeriodicSpec> periodic{}; ///< parts of its boundary that the mesh has pairs of nodes on
    std::vector<OpenLine> lines{};        ///< the open lines that were closed, with their tags in the domain
};

/// Returns the domain that a mesh covers: its boundary edges, the interfaces between its regions and its tagged edges
/// and points, with tags and names, and a marker in every face. Outer edges without a tag share the lowest unused tag,
/// interfaces without a tag the next one. An edge of 3 nodes follows the parabola through its middle node, unless that
/// is closer to the chord than a millionth of its length. Open lines are closed as closeOpenLines() does. Periodic
/// parts inside the domain, and those that a crack touches, are left out. Errors: empty-domain, "cancelled".
Result<MeshDomain> domainOfMesh(const MeshView &mesh, const Progress &progress = {},
                                OpenLineRule rule = OpenLineRule::All);

/// Returns the outer edges and interfaces of a mesh that carry no tag, with the tags that domainOfMesh() gives them.
std::vector<TaggedEdge> untaggedEdges(const MeshView &mesh);

} // namespace forefront
