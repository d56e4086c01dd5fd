#include "core/drawing/document/equality.hpp"

#include "core/engine/spacing/part_list.hpp"

#include <algorithm>

namespace forefront {

bool sameDomain(const Document &a, const Document &b) {
    return a.circleTolerance == b.circleTolerance && a.curveTolerance == b.curveTolerance &&
           a.boundaryNames == b.boundaryNames && a.regionNames == b.regionNames && a.regionMarkers == b.regionMarkers &&
           std::equal(a.shapes.begin(), a.shapes.end(), b.shapes.begin(), b.shapes.end(),
                      [](const auto &s, const auto &t) { return s == t || *s == *t; });
}

bool sameConstraints(const Document &a, const Document &b) {
    return std::equal(a.constraints.begin(), a.constraints.end(), b.constraints.begin(), b.constraints.end(),
                      [](const auto &s, const auto &t) { return s == t || *s == *t; });
}

bool sameContent(const Document &a, const Document &b) {
    return a.options == b.options && a.limits == b.limits && a.parameters == b.parameters && a.formulas == b.formulas &&
           a.picture == b.picture && a.unit == b.unit && a.guides == b.guides && a.elementCounts == b.elementCounts &&
           a.layers == b.layers && a.periodic == b.periodic && a.cracks == b.cracks && a.mapped == b.mapped &&
           a.strips == b.strips && a.regionElements == b.regionElements && sameDomain(a, b) && sameConstraints(a, b) &&
           sameContent(a.spacing, b.spacing);
}

bool sameForMesher(const Document &a, const Document &b) {
    Document other = a;
    other.limits = b.limits;
    other.picture = b.picture;
    other.guides = b.guides;
    other.unit = b.unit;
    other.constraints = b.constraints;
    return sameContent(other, b);
}

} // namespace forefront
