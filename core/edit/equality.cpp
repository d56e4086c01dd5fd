#include "core/edit/equality.hpp"

#include "core/spacing/part_list.hpp"

#include <algorithm>

namespace forefront {

bool sameContent(const Document &a, const Document &b) {
    return a.circleTolerance == b.circleTolerance && a.curveTolerance == b.curveTolerance && a.options == b.options &&
           a.limits == b.limits && a.boundaryNames == b.boundaryNames && a.regionNames == b.regionNames &&
           a.regionMarkers == b.regionMarkers && a.parameters == b.parameters && a.formulas == b.formulas &&
           std::equal(a.shapes.begin(), a.shapes.end(), b.shapes.begin(), b.shapes.end(),
                      [](const auto &s, const auto &t) { return s == t || *s == *t; }) &&
           sameContent(a.spacing, b.spacing);
}

} // namespace forefront
