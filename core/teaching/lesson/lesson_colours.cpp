#include "core/teaching/lesson/lesson_colours.hpp"

#include "core/engine/adapt/adaptive_meshing.hpp"
#include "core/engine/adapt/error_estimate.hpp"

#include <utility>

namespace forefront {

Result<std::vector<double>> coloursOn(const LessonColours &colours, const TriMesh &mesh, const Progress &progress) {
    const Result<NodalField> field = expressionField(colours.expression);
    if (!field) {
        return field.faults();
    }
    Result<std::vector<double>> values = (*field)(mesh, progress);
    if (!values || !colours.ofError) {
        return values;
    }
    Result<ErrorEstimate> estimate = estimateError(mesh, *values, progress);
    if (!estimate) {
        return estimate.faults();
    }
    return std::move(estimate->elements);
}

} // namespace forefront
