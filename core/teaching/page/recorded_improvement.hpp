#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/improve/improve_step.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/engine/session/mesh_stepper.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace forefront {

/// The steps of an improvement as the player reads them. Nodes keep their numbers: the first are those of the finished
/// front, new ones follow. Elements keep their places in a list.
struct RecordedImprovement {
    unsigned width = 3;             ///< corners written for each element; 4 if there are quadrilaterals
    double unit = 0.0;              ///< of lengths
    std::vector<std::string> steps; ///< JSON objects, see recordImprovement(); fewer than `total` if they are too long
    std::size_t total = 0;          ///< steps of the improvement
    QuadFigures before, after;      ///< of the part that a front of quadrilaterals made; zero for triangles

    /// Returns the number of moments that the player shows after the front. If some steps are left out, the last moment
    /// is that after all of them.
    std::size_t moments() const { return steps.size() < total ? steps.size() + 1 : std::max<std::size_t>(total, 1); }
    /// Leaves out the last steps, until the text of the others has at most `maxBytes`.
    void limit(std::size_t maxBytes);
};

/// Records the steps from the finished front on, where the stepper must be, until their text has `maxBytes`. `front`:
/// the mesh there. `width`: see RecordedImprovement. Leaves the stepper anywhere; stops early if it is cancelled. A
/// step is
/// {"m": moved nodes [number, Δx, Δy, ...], "n": new nodes [x, y, ...], "r": removed nodes, "c": changed elements
/// [place, a, b, c, ...], removed ones with -1, "f": [mean α, minimum α] after it, "w": its caption}, in units of
/// length; what is empty is left out. Of width 4, an element has four corners, the last of a triangle is -1; "f" of a
/// clean-up is [mean scaled Jacobian, minimum, irregular nodes], or empty if it is not measured.
RecordedImprovement recordImprovement(MeshStepper &stepper, const Mesh &front, unsigned width, std::size_t maxBytes,
                                      const Progress &progress);

} // namespace forefront
