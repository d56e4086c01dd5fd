#include "core/spacing/site_set.hpp"

#include "core/spacing/segment_tree.hpp"

namespace forefront {
namespace {

/// True if `strong` asks for no more than `weak` at every point of it, and so, growing no faster, everywhere.
bool dominates(const SizeSite &strong, const SizeSite &weak) {
    const double allowance = weak.size - weak.growth * weak.radius;
    return strong.growth <= weak.growth && strong.at(weak.a) <= allowance && strong.at(weak.a + weak.ab) <= allowance;
}

} // namespace

void SiteSet::dropDominated() {
    std::vector<PlacedSegment> shapes;
    shapes.reserve(sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) {
        shapes.push_back({sites[i].a, sites[i].a + sites[i].ab, static_cast<std::uint32_t>(i)});
    }
    const SegmentTree tree(std::move(shapes));
    std::size_t kept = 0;
    std::vector<bool> dropped(sites.size(), false);
    for (std::size_t i = 0; i < sites.size(); ++i) {
        // Only what is near can ask for less: growth·distance must stay below the size.
        const double reach = sites[i].growth > 0.0 ? sites[i].size / sites[i].growth : 0.0;
        tree.overlapping(boxAround(sites[i].a, reach), [&](std::uint32_t j) {
            const bool before = sites[j].size != sites[i].size ? sites[j].size < sites[i].size : j < i;
            if (before && !dropped[i] && dominates(sites[j], sites[i])) {
                dropped[i] = true;
            }
        });
    }
    for (std::size_t i = 0; i < sites.size(); ++i) {
        if (!dropped[i]) {
            sites[kept] = sites[i];
            labels[kept++] = labels[i];
        }
    }
    sites.resize(kept);
    labels.resize(kept);
}

} // namespace forefront
