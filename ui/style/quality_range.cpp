#include "ui/style/quality_range.hpp"

#include <algorithm>

namespace forefront {

ColourRange fittedQualityRange(const MeshQuality &quality) {
    constexpr std::size_t kMinBins = 2; // a narrower range would exaggerate tiny differences
    std::uint64_t below = 0;
    std::size_t bin = 0;
    while (bin + kMinBins < kHistogramBins &&
           100 * (below + quality.alphaHistogram[bin]) <= static_cast<std::uint64_t>(quality.elements)) {
        below += quality.alphaHistogram[bin++];
    }
    return {static_cast<double>(bin) / static_cast<double>(kHistogramBins), 1.0};
}

} // namespace forefront
