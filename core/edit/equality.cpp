#include "core/edit/equality.hpp"

#include <algorithm>

namespace forefront {
namespace {

/// Compares the contents of two pointers; shared content is equal without a look inside.
template <class T, class Equal>
bool samePointed(const std::shared_ptr<const T> &a, const std::shared_ptr<const T> &b, Equal equal) {
    return a == b || (a && b && equal(*a, *b));
}

bool sameSource(const SizeSource &a, const SizeSource &b) {
    return a.shape == b.shape && a.a == b.a && a.b == b.b && a.radius == b.radius && a.size == b.size &&
           a.growth == b.growth && a.name == b.name;
}

bool samePaint(const PaintedSpacing &a, const PaintedSpacing &b) {
    return a.origin == b.origin && a.pitch == b.pitch &&
           std::equal(a.tiles.begin(), a.tiles.end(), b.tiles.begin(), b.tiles.end(), [](const auto &s, const auto &t) {
               return s.first == t.first &&
                      samePointed<PaintedSpacing::Tile>(s.second, t.second,
                                                        [](const auto &u, const auto &v) { return u == v; });
           });
}

bool sameBackground(const BackgroundMesh &a, const BackgroundMesh &b) {
    return a.nodes == b.nodes && a.elements == b.elements && a.values == b.values;
}

} // namespace

bool sameContent(const SpacingSpec &a, const SpacingSpec &b) {
    return a.size == b.size && a.expression == b.expression && a.fromBoundary == b.fromBoundary &&
           a.minimum == b.minimum && a.maximum == b.maximum && a.gradation == b.gradation &&
           std::equal(a.sources.begin(), a.sources.end(), b.sources.begin(), b.sources.end(), sameSource) &&
           samePaint(a.paint, b.paint) && samePointed<BackgroundMesh>(a.background, b.background, sameBackground);
}

bool sameContent(const Document &a, const Document &b) {
    return a.circleTolerance == b.circleTolerance && a.options == b.options && a.boundaryNames == b.boundaryNames &&
           a.regionNames == b.regionNames && a.regionMarkers == b.regionMarkers &&
           std::equal(a.shapes.begin(), a.shapes.end(), b.shapes.begin(), b.shapes.end(),
                      [](const auto &s, const auto &t) {
                          return samePointed<Shape>(s, t, [](const Shape &u, const Shape &v) { return u == v; });
                      }) &&
           sameContent(a.spacing, b.spacing);
}

} // namespace forefront
