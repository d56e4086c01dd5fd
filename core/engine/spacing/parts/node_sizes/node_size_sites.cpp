#include "core/engine/spacing/parts/node_sizes/node_size_sites.hpp"

#include "core/engine/spacing/parts/automatic/boundary_spacing.hpp"

namespace forefront {

void addNodeSizeSites(std::span<const NodeSize> sizes, double minimum, double gradation, SiteSet &sites) {
    for (std::uint32_t k = 0; k < sizes.size(); ++k) {
        if (isUsable(sizes[k].at)) {
            sites.add(limited(SizeSite::point(sizes[k].at, sizes[k].size, sizes[k].growth), minimum, gradation),
                      {SpacingOrigin::Boundary, SiteReason::NodeSize, k});
        }
    }
}

} // namespace forefront
