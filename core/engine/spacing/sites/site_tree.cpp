#include "core/engine/spacing/sites/site_tree.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/spacing/sites/site_tree_builders.hpp"

#include <algorithm>
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

/// The points of a block go down together, level by level, so that the memory of one is fetched while others wait.
void SiteTree::lowerMany(std::span<const Vec2> points, std::span<double> rho) const {
    FOREFRONT_ASSERT(points.size() == rho.size());
    constexpr std::size_t kBlock = 64;
    std::array<Place, kBlock> places;
    std::array<std::uint32_t, kBlock> cells, above{};
    for (std::size_t begin = 0; begin < points.size(); begin += kBlock) {
        const std::size_t size = std::min(kBlock, points.size() - begin);
        for (std::size_t i = 0; i < size; ++i) {
            places[i] = placeOf(points[begin + i]);
            above[i] = static_cast<std::uint32_t>(i);
        }
        for (std::size_t left = size, next = 0; left > 0; left = next) {
            next = 0;
            for (std::size_t k = 0; k < left; ++k) {
                const std::uint32_t i = above[k];
                cells[i] = cells_[places[i].slot];
                const bool split = (cells[i] & kSplit) != 0;
                if (split) {
                    places[i].descend(cells[i]);
                }
                above[next] = i;
                next += split ? 1 : 0;
            }
        }
        for (std::size_t i = 0; i < size; ++i) {
            rho[begin + i] = std::min(rho[begin + i], valueIn(cells[i], places[i]));
        }
    }
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
