#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/improve/improve_watch.hpp"
#include "core/engine/mesh/quality.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

/// The figures of a mesh by which a step of its improvement is judged.
struct ShapeFigures {
    double alphaMin = 0.0, alphaMean = 0.0;
    double minAngle = 0.0; ///< degrees
};

/// The figures of a mesh of quadrilaterals by which a step of its clean-up is judged.
struct QuadFigures {
    double jacobianMin = 0.0, jacobianMean = 0.0; ///< scaled Jacobians
    std::size_t irregular = 0;                    ///< interior nodes with other than four elements
};

/// An element of a step: three or four corners.
struct StepElement {
    std::array<Vec2, 4> at{};
    unsigned count = 3;

    const Vec2 *begin() const { return at.data(); }
    const Vec2 *end() const { return at.data() + count; }
};

/// A step of the improvement of a finished front, and what it changed.
struct ImproveStep {
    /// A node that stays in the mesh and moves.
    struct Move {
        NodeId node = kNoNode; ///< in the mesh shown
        Vec2 from, to;
    };
    ImproveChange change = ImproveChange::Swap;
    std::size_t number = 0; ///< of the step, from 1
    std::vector<Move> moves;
    std::vector<Vec2> addedNodes, removedNodes;
    std::vector<std::array<Vec2, 2>> addedEdges;   ///< as they are after the step
    std::vector<std::array<Vec2, 2>> removedEdges; ///< as they were before it
    std::vector<StepElement> elements;             ///< made by the step, after it
    ShapeFigures before, after;                    ///< of the whole mesh
    bool quads = false;                            ///< of a mesh of quadrilaterals, which has the figures below
    QuadFigures quadsBefore, quadsAfter;           ///< of the part that the front made
    bool measured = true;                          ///< the figures are known
    std::size_t refused = 0; ///< changes tried at the same node before this one, which did not pay
};

/// Returns the figures of a mesh.
ShapeFigures figuresOf(const TriMesh &mesh);
ShapeFigures figuresOf(const MeshQuality &quality);

/// Returns a step as a caption: "Improvement 3 of 41: edge swapped; minimum α .652 → .701, mean .931 → .932, minimum
/// angle 31.2° → 33.0°"; of quadrilaterals "Clean-up 7 of 90: edge turned to the next corners of its two elements; 2
/// others tried before did not pay; irregular nodes 31 → 29, scaled Jacobian minimum 0.412, mean 0.9312 → 0.9330".
/// `steps`: of the improvement.
std::string caption(const ImproveStep &step, std::size_t steps);

} // namespace forefront
