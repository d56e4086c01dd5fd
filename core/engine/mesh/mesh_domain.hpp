#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/mesh/cracks.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <vector>

namespace forefront {

/// Returns the domain that a mesh covers: its boundary edges, the interfaces between its regions and its tagged edges
/// and points, with tags and names, and a marker in every face. Outer edges without a tag share the lowest unused tag,
/// interfaces without a tag the next one. An edge of 3 nodes follows the parabola through its middle node, unless that
/// is closer to the chord than a millionth of its length. Open lines are closed; `cracks` receives them, with their
/// tags in the domain: those without one get an unused tag, named "crack" where that is free. Errors: empty-domain,
/// "cancelled".
Result<Domain> domainOfMesh(const MeshView &mesh, const Progress &progress = {},
                            std::vector<OpenLine> *cracks = nullptr);

/// Returns the outer edges and interfaces of a mesh that carry no tag, with the tags that domainOfMesh() gives them.
std::vector<TaggedEdge> untaggedEdges(const MeshView &mesh);

} // namespace forefront
