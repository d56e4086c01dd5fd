#pragma once

#include "core/engine/boundary/discretise.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/spacing/kept_field.hpp"

namespace forefront {

/// Gives the front nodes beside crowded segments, as points without a tag. There the size falls so fast that a front
/// would connect the far ends of the segments before it reached the size asked for: a square of four kept segments
/// would get four elements, whatever its size is. The nodes lie as far apart as the size at each, the coarsest placed
/// first. `faces`: the faces of the domain.
void addGradedNodes(const KeptField &spacing, const DomainFaces &faces, DiscreteDomain &boundary);

} // namespace forefront
