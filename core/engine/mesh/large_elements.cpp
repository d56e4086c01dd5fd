#include "core/engine/mesh/large_elements.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/lazy_faces.hpp"
#include "core/engine/mesh/placed_cell.hpp"
#include "core/engine/spacing/parts/regions/region_part.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr double kAreaRounding = 1e-9; // relative, of a computed area

/// The elements of a region that exceed its maximum area.
struct RegionExcess {
    std::size_t count = 0;
    double largest = 0.0; ///< area
    double allowed = 0.0;
    Vec2 at;
};

Diagnostic excessWarning(const RegionExcess &excess, const std::string &region) {
    Diagnostic warning;
    warning.severity = Severity::Warning;
    warning.code = "large-elements";
    warning.message = std::to_string(excess.count) + (excess.count == 1 ? " element exceeds" : " elements exceed") +
                      " the maximum area " + numberText(excess.allowed, 6) + " of region '" + region +
                      "'; the largest has " + numberText(excess.largest, 6);
    warning.advice = "give a smaller maximum area, unless a minimum size or kept segments are the reason";
    warning.at = excess.at;
    return warning;
}

} // namespace

Diagnostics largeElements(const MeshView &mesh, const Domain &domain, std::span<const RegionSize> regions) {
    const LazyFaces faces(domain, {}, placesOf(regions));
    const std::optional<RegionPart> part = RegionPart::build(regions, faces, 0.0);
    if (!part) {
        return {};
    }
    std::vector<RegionExcess> found(regions.size());
    forEachCell(mesh, [&](const PlacedCell &cell, std::size_t) {
        std::uint32_t region = 0;
        const Vec2 centre = cell.centre();
        const double area = 0.5 * twiceArea(cell), allowed = part->maxAreaAt(centre, region);
        if (area > allowed * (1.0 + kAreaRounding)) {
            RegionExcess &excess = found[region];
            ++excess.count;
            if (area > excess.largest) {
                excess.largest = area;
                excess.allowed = allowed;
                excess.at = centre;
            }
        }
    });
    const std::vector<std::string> names = namesOf(regions, domain, faces);
    Diagnostics warnings;
    for (std::size_t r = 0; r < found.size(); ++r) {
        if (found[r].count > 0) {
            warnings.push_back(excessWarning(found[r], names[r]));
        }
    }
    return warnings;
}

} // namespace forefront
