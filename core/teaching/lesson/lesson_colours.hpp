#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesh/tri_mesh.hpp"

#include <string>
#include <vector>

namespace forefront {

/// The values by which a page of a lesson colours the mesh: those of an expression in x and y at its nodes, or the
/// error that they have on each element.
struct LessonColours {
    std::string expression{}; ///< empty: none; the mesh has the colours of a measure
    std::string name{};       ///< of the values, in the legend
    bool ofError = false;

    bool any() const { return !expression.empty(); }
    friend bool operator==(const LessonColours &, const LessonColours &) = default;
};

/// Returns a value for each node of a mesh or, of the error, for each element. Errors: those of expressionField() and
/// estimateError().
Result<std::vector<double>> coloursOn(const LessonColours &colours, const TriMesh &mesh, const Progress &progress);

} // namespace forefront
