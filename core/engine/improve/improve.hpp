#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/improve/improve_level.hpp"
#include "core/engine/mesh/tri_mesh.hpp"

namespace FOREFRONT_API forefront {

class ImproveWatch;
class SpacingField;

/// Options of improve().
struct ImproveOptions {
    ImproveLevel level = ImproveLevel::Default;
    unsigned threads = 1;                  ///< the mesh does not depend on it
    const SpacingField *spacing = nullptr; ///< target node spacing; null: the spacing of the mesh at each round
    ImproveWatch *watch = nullptr;         ///< learns of each change; null: none. The mesh does not depend on it
};

/// The result of improve().
struct ImproveReport {
    std::size_t swaps = 0;
    std::size_t moves = 0;
    std::size_t merges = 0;    ///< nodes removed
    std::size_t divisions = 0; ///< nodes added
    double alphaMinBefore = 0.0;
    double alphaMinAfter = 0.0; ///< not below alphaMinBefore; a lower bound, or 0, when cancelled
    double seconds = 0.0;       ///< CPU time of all threads
};

/// Improves a mesh in place by swapping edges and smoothing nodes. Level Best then also removes and adds nodes where
/// the mesh is irregular, which changes the numbers of nodes and elements and their order, and evens the areas of
/// neighbours; level Default removes and adds nodes if the geometric mean of α is between 0.93 and 0.95, and if that
/// does not suffice, moves nodes to improve the shapes alone. Nodes of tagged edges and tagged points do not move,
/// tagged edges are not swapped, and elements keep their regions. No element becomes inverted or flat (exact sign), and
/// the minimum α never falls. Deterministic. Cancelling leaves a valid mesh and takes about 50 ms up to 10⁶ elements,
/// 0.4 s up to 10⁷. Smoothing works in single precision: lengths beyond about 1e±38 leave the mesh as it is. Throws
/// std::bad_alloc if memory runs out; the mesh is then unusable.
ImproveReport improve(TriMesh &mesh, const ImproveOptions &options = {}, const Progress &progress = {});

} // namespace forefront
