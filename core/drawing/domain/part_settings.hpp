#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/mesher/options.hpp"

namespace forefront {

/// Adds what a document sets for boundary parts, inner lines and regions to its job: boundary layers, periodic parts,
/// cracks, strips, mapped regions and regions with elements of their own. Leaves out those whose parts do not exist, as
/// after a part was deleted, and adds a warning "unused-setting" for each to MeshingJob::findings; likewise for sizes
/// and numbers of elements of such boundary parts, which have no effect. `job`: has its domain.
void addPartSettings(const Document &document, MeshingJob &job);

} // namespace forefront
