#include "ui/workspace/coordinate_text.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/document/document_store.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

constexpr int kLeastDigits = 6, kMostDigits = 15; ///< significant ones; a double has no more that mean anything
constexpr int kMostDecimals = 9;
constexpr double kShown = 1e-5; ///< of the diagonal: 1000 pixels, of which a hundredth counts

} // namespace

double DrawingExtent::diagonal(const DocumentStore &document) const {
    if (revision_ != document.revision()) {
        revision_ = document.revision();
        diagonal_ = boundsOf(*document.current()).diagonal();
    }
    return diagonal_;
}

int coordinateDecimals(double diagonal) {
    if (!(diagonal > 0.0) || !std::isfinite(diagonal)) {
        return 0;
    }
    return std::clamp(static_cast<int>(-std::floor(std::log10(kShown * diagonal))), 0, kMostDecimals);
}

std::string coordinateText(double value, double diagonal) {
    const double size = std::abs(value);
    const int whole = size >= 1.0 && std::isfinite(size) ? static_cast<int>(std::floor(std::log10(size))) + 1 : 0;
    return ui::number(value, std::clamp(whole + coordinateDecimals(diagonal), kLeastDigits, kMostDigits));
}

} // namespace forefront
