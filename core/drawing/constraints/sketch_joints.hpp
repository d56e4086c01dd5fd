#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/references.hpp"

#include <memory>
#include <set>
#include <vector>

namespace forefront {

class DocumentSketch;

/// Which joints a sketch has. Joints are implied by places: nodes at the same place, and nodes on straight segments.
struct JointSource {
    /// The drawing that has the joints, mostly the document of the sketch itself; null: there are none. Must outlive
    /// the use of the source.
    const Document *places = nullptr;
    std::set<NodeRef> moved{}; ///< nodes that no constraint names, but whose joints count
    std::set<NodeRef> apart{}; ///< nodes that are joined with one another only: they are being detached
};

/// A joint of a sketch: a node, and the node at the same place or the segment that it lies on.
struct SketchJoint {
    SketchPart node, other;
    Vec2 at;

    friend bool operator==(const SketchJoint &, const SketchJoint &) = default;
};

/// Brings the joints of the parts of a sketch into it, and those of the parts that these are joined with.
class JointFinder {
  public:
    JointFinder(DocumentSketch &sketch, const JointSource &source);
    ~JointFinder();
    JointFinder(const JointFinder &) = delete;
    JointFinder &operator=(const JointFinder &) = delete;

    /// Adds the unknowns of nodes that are joined with those in the sketch. May be called again after others came in.
    void find();
    /// Adds an equation for each joint that was found. Where formulas, locks or fixed places give both sides, these
    /// stay as they are: a joint is broken on purpose there.
    void write();

  private:
    class Search;
    std::unique_ptr<Search> search_; ///< none without joints
};

} // namespace forefront
