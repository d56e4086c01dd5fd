#include "core/drawing/constraints/orient.hpp"

#include "core/drawing/constraints/constraint_equations.hpp"
#include "core/drawing/sketch/solve_sketch.hpp"

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace forefront {

bool holdsIn(const Document &document, const SketchConstraint &constraint) {
    DocumentSketch sketch(document);
    addEquations(sketch, constraint, document);
    std::vector<std::uint32_t> all(sketch.system.equations.size());
    std::iota(all.begin(), all.end(), 0U);
    return holds(sketch.system, all);
}

SketchConstraint reoriented(const Document &document, SketchConstraint constraint) {
    if (holdsIn(document, constraint)) {
        return constraint;
    }
    DocumentSketch sketch(document);
    SketchConstraint turned = oriented(sketch, constraint);
    return turned != constraint && holdsIn(document, turned) ? turned : constraint;
}

} // namespace forefront
