#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/references.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace forefront {

class DocumentSketch;

/// Which joints a sketch has. Joints are implied by places: nodes at the same place, nodes on straight segments, and
/// curved segments that lie on one another between such nodes.
struct JointSource {
    /// The drawing that has the joints, mostly the document of the sketch itself; null: there are none. Must outlive
    /// the use of the source.
    const Document *places = nullptr;
    /// Nodes, and segments that are arcs, whose joints count though no constraint names them.
    std::set<SketchPart> moved{};
    std::set<NodeRef> apart{}; ///< nodes that are joined with one another only: they are being detached
};

/// Makes a solution of equations of a sketch exact where it is so up to a tolerance: numbers that are equal get the
/// same bits, see equaliseValues(), and nodes on upright and level sides lie on them. Else meshes would have slits
/// there. `rank`: at least 1.
void alignJoints(const DocumentSketch &sketch, std::span<const std::uint32_t> equations, std::vector<double> &values,
                 const std::function<int(std::uint32_t)> &rank);

/// A joint of a sketch: a node, and the node at the same place or the segment that it lies on; or two curved segments.
struct SketchJoint {
    SketchPart node, other;
    Vec2 at; ///< of the node, or the middle of the segments

    friend bool operator==(const SketchJoint &, const SketchJoint &) = default;
};

/// Brings the joints of the parts of a sketch into it, and those of the parts that these are joined with.
class JointFinder {
  public:
    JointFinder(DocumentSketch &sketch, const JointSource &source);

    /// Adds the unknowns of parts that are joined with those in the sketch. May be called again after others came in.
    void find();
    /// Adds an equation for each joint that was found. Where formulas, locks or fixed places give both sides, these
    /// stay as they are: a joint is broken on purpose there.
    void write();

  private:
    DocumentSketch &sketch_;
    const JointSource &source_;
    std::vector<std::pair<SketchPart, SketchPart>> joints_;
    std::size_t known_ = static_cast<std::size_t>(-1); ///< number of unknowns whose joints have been found
};

} // namespace forefront
