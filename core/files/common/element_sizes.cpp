#include "core/files/common/element_sizes.hpp"

#include "core/engine/mesh/mesh_spacing.hpp"
#include "core/engine/mesh/mesh_view.hpp"

namespace forefront {

Result<SpacingSpec> elementSizes(const Mesh &mesh, const SourceText &source) {
    SpacingSpec spec;
    spec.background = spacingOfMesh(mesh);
    if (!spec.background) {
        Diagnostics faults = error("no-values", "the file holds neither nodal values nor elements to use as spacing");
        faults.front().file = source.name;
        return faults;
    }
    source.note("element-sizes", "the file has no nodal values; the sizes of its elements are the spacing", 0);
    return spec;
}

} // namespace forefront
