#pragma once

#include "core/engine/spacing/sites/site_tree.hpp"

#include <optional>
#include <span>
#include <vector>

namespace forefront {

/// Builds the tree from the root down: each cell passes the sites that may win in it to its quarters. Accepts any
/// sites; the time grows faster than their number.
std::optional<SiteTree> buildTreeFromRoot(std::vector<SizeSite> sites, const Box2 &box, const Progress &progress);

/// Returns true if spreadSites() can take these sites: all of them grow at the same rate, which is not zero.
bool canSpread(std::span<const SizeSite> sites);

/// Builds the tree from the sites outwards, in time proportional to their number. Values may be a few percent too large
/// where one site takes over from another, seldom more. `cellsPerSize`: see SpreadOptions.
std::optional<SiteTree> spreadSites(std::vector<SizeSite> sites, const Box2 &box, double cellsPerSize,
                                    const Progress &progress);

} // namespace forefront
