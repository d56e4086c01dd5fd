#include "core/spacing/parts/sources/source_sites.hpp"

namespace forefront {
namespace {

SizeSite siteOf(const SizeSource &source) {
    return source.shape == SourceShape::Line
               ? SizeSite::segment(source.a, source.b, source.size, source.growth, source.radius)
               : SizeSite::point(source.a, source.size, source.growth, source.radius);
}

} // namespace

void addSourceSites(std::span<const SizeSource> sources, double minimum, double gradation, SiteSet &sites) {
    for (std::size_t i = 0; i < sources.size(); ++i) {
        sites.add(limited(siteOf(sources[i]), minimum, gradation),
                  {SpacingOrigin::Source, SiteReason::Source, static_cast<std::uint32_t>(i)});
    }
}

} // namespace forefront
