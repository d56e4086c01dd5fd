#include "core/engine/spacing/parts/sources/source_sites.hpp"

#include "core/engine/spacing/parts/sources/graded_sources.hpp"

#include <algorithm>

namespace forefront {
namespace {

SizeSite siteOf(const SizeSource &source) {
    if (source.shape != SourceShape::Line) {
        return SizeSite::point(source.a, source.size, source.growth, source.radius);
    }
    const double size = std::min(source.size, source.endSize.value_or(source.size)); // both ends may be one point
    return SizeSite::segment(source.a, source.b, size, source.growth, source.radius);
}

} // namespace

void addSourceSites(std::span<const SizeSource> sources, double minimum, double gradation, SiteSet &sites) {
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (isGraded(sources[i]) || sources[i].shape == SourceShape::Box) {
            continue;
        }
        sites.add(limited(siteOf(sources[i]), minimum, gradation),
                  {SpacingOrigin::Source, SiteReason::Source, static_cast<std::uint32_t>(i)});
    }
}

} // namespace forefront
