#include "core/spacing/sites/site_tree.hpp"

#include "core/base/assert.hpp"
#include "core/spacing/sites/site_tree_builders.hpp"

#include <utility>

namespace forefront {

std::optional<SiteTree> SiteTree::build(std::vector<SizeSite> sites, const Box2 &box, const Progress &progress,
                                        const SpreadOptions &spread) {
    FOREFRONT_ASSERT(!sites.empty() && !box.empty());
    if (sites.size() > spread.many && canSpread(sites)) {
        return spreadSites(std::move(sites), box, spread.cellsPerSize, progress);
    }
    return buildTreeFromRoot(std::move(sites), box, progress);
}

std::size_t SiteTree::winner(Vec2 p) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < sites_.size(); ++i) {
        if (sites_[i].at(p) < sites_[best].at(p)) {
            best = i;
        }
    }
    return best;
}

std::size_t SiteTree::bytes() const {
    return sites_.size() * sizeof(SizeSite) + (cells_.size() + lists_.size()) * sizeof(std::uint32_t) +
           smooth_.size() * sizeof(Corners);
}

} // namespace forefront
