#pragma once

#include "core/base/result.hpp"
#include "core/domain/domain.hpp"
#include "core/mesh/mesh.hpp"

namespace forefront {

/// Returns the domain that a mesh covers: its boundary edges, the interfaces between its regions and its tagged edges
/// and points, with tags and names, and a marker in every face. Errors: empty-domain (neither elements nor edges).
Result<Domain> domainOfMesh(const Mesh &mesh);

} // namespace forefront
