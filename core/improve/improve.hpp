#pragma once

#include "core/base/api.hpp"
#include "core/base/progress.hpp"
#include "core/improve/improve_level.hpp"
#include "core/mesh/mesh.hpp"

namespace FOREFRONT_API forefront {

class SpacingField;

struct ImproveOptions {
    ImproveLevel level = ImproveLevel::Default;
    unsigned threads = 1;                  ///< the result does not depend on it
    const SpacingField *spacing = nullptr; ///< the node spacing wanted; null: that of the mesh as each round finds it
};

struct ImproveReport {
    std::size_t swaps = 0;
    std::size_t moves = 0;
    std::size_t merges = 0;    ///< nodes taken away
    std::size_t divisions = 0; ///< nodes added
    double alphaMinBefore = 0.0;
    double alphaMinAfter = 0.0; ///< never less than before; when cancelled, a lower bound, 0 where nothing was measured
    double seconds = 0.0;       ///< CPU time, of all threads
};

/// Edge swapping and node smoothing in place; level Best also takes nodes away and adds others where the mesh is not
/// regular, so that it has some more or fewer nodes and elements after, numbered as it comes. Nodes of tagged edges and
/// tagged points stay where they are, tagged edges are not swapped, elements keep their region. No element becomes
/// inverted or flat (exact sign), the least α never falls. Deterministic. Cancelling leaves a valid mesh, within some
/// 50 ms up to 10⁷ elements. Smoothing works in floats: where lengths lie beyond about 1e±38 it leaves the mesh as it
/// is.
ImproveReport improve(Mesh &mesh, const ImproveOptions &options = {}, const Progress &progress = {});

} // namespace forefront
