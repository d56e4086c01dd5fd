#include "core/spacing/sites/site_set.hpp"

#include "core/geometry/box_tree.hpp"

namespace forefront {
namespace {

/// Returns true if `strong` asks for at most the spacing of `weak` at all its points, and so everywhere, growing no
/// faster.
bool dominates(const SizeSite &strong, const SizeSite &weak) {
    const double allowance = weak.size - weak.growth * weak.radius;
    return strong.growth <= weak.growth && strong.at(weak.a) <= allowance && strong.at(weak.a + weak.ab) <= allowance;
}

} // namespace

void SiteSet::dropDominated() {
    std::vector<Box2> boxes;
    boxes.reserve(sites.size());
    for (const SizeSite &site : sites) {
        boxes.push_back(boxOf(site.a, site.a + site.ab));
    }
    const BoxTree tree(boxes);
    std::size_t kept = 0;
    std::vector<bool> dropped(sites.size(), false);
    for (std::size_t i = 0; i < sites.size(); ++i) {
        // Only what is near can ask for less: growth·distance must stay below the size.
        const double reach = sites[i].growth > 0.0 ? sites[i].size / sites[i].growth : 0.0;
        tree.query(boxAround(sites[i].a, reach), [&](std::uint32_t j) {
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
