#pragma once

#include "core/drawing/constraints/sketch_joints.hpp"
#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/joints/joint_index.hpp"

#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace forefront {

/// Follows joints from part to part of a drawing: first to what moves with the given parts, then to the segments of
/// other shapes on which these lie. Such segments stand still unless the sketch can only be solved by moving them.
class JointSearch {
  public:
    /// `document`: of the sketch; shapes that have other handles in it than in the drawing of the source have no
    /// joints.
    JointSearch(const Document &document, const JointSource &source);

    /// Adds a node to start from: a handle of its shape.
    void addNode(NodeRef node);
    /// Adds a curved segment to start from.
    void addCurve(const SketchPart &segment);
    void run();

    /// A part that joints reach.
    struct Found {
        SketchPart part;
        bool standing = false;
    };
    /// Returns the nodes and curves that were found, those to start from included.
    const std::vector<Found> &parts() const { return parts_; }
    /// Returns pairs of a node, and the node at its place or the segment under it; or of two curved segments. In order.
    const std::vector<std::pair<SketchPart, SketchPart>> &joints() const { return joints_; }

  private:
    bool usable(std::uint32_t id) const;
    NodeRef refOf(std::size_t shape, std::uint32_t handle) const { return {places_.shapes[shape]->id, handle}; }
    std::pair<NodeRef, NodeRef> endsOf(const JointSegment &segment) const;
    bool isApart(NodeRef handle) const { return source_.apart.contains(handle); }
    bool isWith(NodeRef handle, const JointSegment &segment) const;
    void enter(NodeRef handle);
    void enterCurve(const SketchPart &segment);
    void search();
    void followAll();
    void follow(NodeRef handle);
    NodeRef followNodes(NodeRef handle, Vec2 at, std::size_t count, bool isClosed);
    std::vector<JointSegment> segmentsUnder(NodeRef handle, Vec2 at, std::size_t position) const;
    void followSegments(NodeRef handle, Vec2 at, std::size_t position, NodeRef first);
    void followSide(const JointSegment &side);
    void followCurve(const SketchPart &part);
    bool isSame(const Curve &a, const Curve &b) const;

    const Document &document_, &places_;
    const JointSource &source_;
    std::set<NodeRef> nodes_;
    std::set<SketchPart> curves_;
    std::optional<JointIndex> index_;
    Box2 box_;   ///< that the index covers
    Box2 reach_; ///< of what was looked at
    bool standing_ = false;
    std::set<SketchPart> entered_;
    std::vector<SketchPart> queue_; ///< entered, to be followed
    std::vector<NodeRef> under_;    ///< ends of segments that nodes lie on
    std::vector<Found> parts_;
    std::vector<std::pair<SketchPart, SketchPart>> joints_;
};

} // namespace forefront
