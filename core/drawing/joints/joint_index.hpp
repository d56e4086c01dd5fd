#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/geometry/box_tree.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace forefront {

/// A handle that can be joined with others.
struct JointHandle {
    std::size_t shape = 0; ///< position in Document::shapes
    std::uint32_t handle = 0;
    Vec2 at;
};

/// A straight segment on which handles can lie.
struct JointSegment {
    std::size_t shape = 0;  ///< position in Document::shapes
    std::uint32_t side = 0; ///< index of the segment; it starts at the handle with the same index
    Vec2 a, b;
};

/// Returns true if the handles of a shape can be joined with others: those of paths, rectangles and points.
bool canJoin(const Shape &shape);

/// Returns true if two shapes have the same handles in another order, as before and after reversing a path.
bool hasReorderedHandles(const Shape &before, const Shape &after);

/// Returns the parameter along a segment of the point nearest to p, in [0, 1]; none if it is farther than `tolerance`.
std::optional<double> alongSegment(Vec2 a, Vec2 b, Vec2 p, double tolerance);

/// Finds the handles and straight segments of a document near a place, in O(log n). Keeps a reference to the document.
class JointIndex {
  public:
    explicit JointIndex(const Document &document);
    /// Finds only handles and segments in a box or that meet it, which takes less time.
    JointIndex(const Document &document, const Box2 &within);

    const Document &document() const { return document_; }
    /// Returns the distance within which places are the same; see samePlaceDistance().
    double tolerance() const { return tolerance_; }
    /// Returns the segment that p lies inside of, the first in the document; null if there is none.
    template <class Admits>
    const JointSegment *segmentAt(Vec2 p, const Admits &admits) const {
        std::uint32_t first = kNoIndex;
        segmentTree_.query(Box2{p, p}.grown(tolerance_), [&](std::uint32_t k) {
            if (k < first && liesInside(segments_[k], p) && admits(segments_[k])) {
                first = k;
            }
        });
        return first == kNoIndex ? nullptr : &segments_[first];
    }
    /// Returns the segments that p lies inside of, in the order of the document.
    std::vector<JointSegment> segmentsAt(Vec2 p) const;
    /// Calls visit(handle) for every handle at a place.
    template <class Visit>
    void handlesAt(Vec2 p, const Visit &visit) const {
        handleTree_.query(Box2{p, p}.grown(tolerance_), [&](std::uint32_t k) {
            if (distance(handles_[k].at, p) <= tolerance_) {
                visit(handles_[k]);
            }
        });
    }
    /// Calls visit(handle, t) for every handle that lies inside the segment from a to b, at parameter t.
    template <class Visit>
    void handlesOn(Vec2 a, Vec2 b, const Visit &visit) const {
        Box2 box{a, a};
        box.add(b);
        handleTree_.query(box.grown(tolerance_), [&](std::uint32_t k) {
            const Vec2 at = handles_[k].at;
            if (liesInside({handles_[k].shape, 0, a, b}, at)) {
                visit(handles_[k], *alongSegment(a, b, at, tolerance_));
            }
        });
    }

  private:
    /// Returns true if p lies on a segment, and not at its ends.
    bool liesInside(const JointSegment &segment, Vec2 p) const {
        return distance(p, segment.a) > tolerance_ && distance(p, segment.b) > tolerance_ &&
               alongSegment(segment.a, segment.b, p, tolerance_);
    }
    void addShape(std::size_t shape, const std::vector<Vec2> &handles, const Box2 &within);
    void build();

    const Document &document_;
    double tolerance_;
    std::vector<JointHandle> handles_;
    std::vector<JointSegment> segments_; ///< in the order of the document
    BoxTree handleTree_, segmentTree_;
};

/// Returns true if segment k of a shape, which starts at its handle k, is straight from handle to handle.
bool isStraightSide(const Shape &shape, std::size_t k);
/// Returns the number of segments between the handles of a path or rectangle; 0 for others.
std::size_t sideCount(const Shape &shape);

} // namespace forefront
