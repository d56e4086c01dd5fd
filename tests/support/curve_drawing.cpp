#include "tests/support/curve_drawing.hpp"

namespace forefront::testing {

std::int32_t CurveDrawing::feature(const CurveLoop &curves) {
    const auto tag = static_cast<std::int32_t>(input.features.size()) + 1;
    loop(curves, input.addContour(input.addShape(input.addFeature(tag)), FillRule::EvenOdd), tag);
    return tag;
}

void CurveDrawing::loop(const CurveLoop &curves, std::uint32_t contour, std::int32_t tag) {
    flatten(curves);
    nodes_.pop_back(); // the first one again
    input.addRing(contour, nodes_, tag, stretches_);
}

void CurveDrawing::line(const CurveLoop &curves, std::int32_t tag) {
    flatten(curves);
    input.addChain(nodes_, tag, stretches_);
}

/// Each curve begins exactly where the previous one ends.
void CurveDrawing::flatten(const CurveLoop &curves) {
    nodes_ = {curves.front().point(0.0)};
    stretches_.clear();
    for (const Curve &curve : curves) {
        const auto id = static_cast<std::uint32_t>(input.curves.size());
        input.curves.push_back(curve);
        double from = 0.0;
        for (const double to : curve.flatten(deviation_)) {
            nodes_.push_back(curve.point(to));
            stretches_.push_back({id, from, to});
            from = to;
        }
    }
}

} // namespace forefront::testing
