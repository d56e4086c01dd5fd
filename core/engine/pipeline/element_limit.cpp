#include "core/engine/pipeline/element_limit.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace forefront {

std::uint64_t limitOf(const MeshingOptions &options) {
    return std::min(options.maxElements, kMaxElements);
}

Diagnostics tooManyElements(const std::string &what, double needed, double limit, const PreparedJob &prepared) {
    // The number of elements falls with the square of the size. The margin is for the rounding and the estimate.
    const double factor = 1.05 * std::sqrt(std::max(1.0, needed / limit));
    const SpacingField &spacing = *prepared.spacing;
    const bool uniform = spacing.minimum() == spacing.maximum();
    std::string advice = uniform ? "choose an element size of at least " + numberText(factor * spacing.minimum(), 3)
                                 : "choose element sizes at least " + numberText(factor, 3) + " times as large";
    if (limit < static_cast<double>(kMaxElements)) {
        advice += ", or raise the maximum number of elements";
    }
    return error("too-many-elements", what + "; expected at most " + numberText(limit, 9), std::move(advice));
}

std::uint64_t elementsToStopAt(const MeshingOptions &options) {
    const std::uint64_t limit = limitOf(options); // estimates may be a fifth too low
    return std::min(limit + limit / 4 + 1000, kMaxElements);
}

Diagnostics stoppedFront(const PreparedJob &prepared, const MeshingOptions &options) {
    // How many elements the unmeshed part takes is unknown; assume as many.
    const auto made = static_cast<double>(elementsToStopAt(options));
    return tooManyElements("the front has made " + numberText(made, 3) + " elements and is not closed yet", 2.0 * made,
                           static_cast<double>(limitOf(options)), prepared);
}

} // namespace forefront
