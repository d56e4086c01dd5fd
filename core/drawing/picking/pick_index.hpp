#pragma once

#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/box_tree.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace forefront {

/// A handle near a point.
struct NodeHit {
    NodeRef ref;
    Vec2 at;
    double distance = 0.0;
};

/// A segment or circle near a point.
struct SegmentHit {
    SegmentRef ref;
    Vec2 a, b;      ///< ends; for a circle, both are the nearest point
    Vec2 at;        ///< nearest point on the segment or circle
    double t = 0.0; ///< position of `at` between a and b, or on the curve, in [0, 1]
    double distance = 0.0;
    std::optional<Curve> curve; ///< of a curved segment; not of a circle
};

/// Finds the parts of a document near a point, in O(log n). Hidden shapes are never found; locked ones are found only
/// by node() and segment(), for snapping. It is built once per document and keeps the document alive.
class PickIndex {
  public:
    explicit PickIndex(std::shared_ptr<const Document> document);

    const Document &document() const { return *document_; }

    /// Some handles and segments of shapes.
    struct Parts {
        std::set<NodeRef> nodes;
        std::set<SegmentRef> segments;
    };
    /// Restricts the items that a search may find; by default it finds all.
    struct Filter {
        Filter() = default;
        template <class Predicate>
        requires std::is_invocable_r_v<bool, Predicate, const Shape &> Filter(Predicate predicate)
            : shapes(std::move(predicate)) {}

        bool admitsNode(const Shape &shape, std::uint32_t handle) const {
            return (!shapes || shapes(shape)) && (!ignored || !ignored->nodes.contains({shape.id, handle}));
        }
        bool admitsSegment(const Shape &shape, std::uint32_t part) const {
            return (!shapes || shapes(shape)) && (!ignored || !ignored->segments.contains({shape.id, part}));
        }

        std::function<bool(const Shape &)> shapes; ///< returns false for shapes to ignore; empty: none
        std::shared_ptr<const Parts> ignored;      ///< parts of other shapes to ignore; null: none
    };

    /// Returns the handle nearest to p within `tolerance` (domain units); of equally near ones, the one drawn last.
    std::optional<NodeHit> node(Vec2 p, double tolerance, const Filter &filter = {}) const;
    /// Returns the segment or circle nearest to p within the tolerance.
    std::optional<SegmentHit> segment(Vec2 p, double tolerance, const Filter &filter = {}) const;
    /// Returns the curves of the segments, circles and ellipses within the tolerance, straight ones as lines; the
    /// nearest `most` of them, nearest first.
    std::vector<Curve> curvesNear(Vec2 p, double tolerance, std::size_t most, const Filter &filter = {}) const;
    /// Returns all segments and circles within the tolerance of p, hidden ones excepted, without order.
    std::vector<SegmentRef> segmentsAt(Vec2 p, double tolerance) const;
    /// Returns the nearest centre of an arc or a rectangle within the tolerance.
    std::optional<Vec2> centre(Vec2 p, double tolerance, const Filter &filter = {}) const;
    /// Returns the shape under p: one whose line or point is within the tolerance, else the smallest closed shape that
    /// contains p, else kNoIndex.
    std::uint32_t shape(Vec2 p, double tolerance) const;
    /// A size source near a point (by index), and the part of it that was hit.
    struct SourceHit {
        std::uint32_t source = 0;
        enum class Part : std::uint8_t { A, B, Whole, Rim, AfterA, AfterB } part = Part::A;
    };
    std::optional<SourceHit> source(Vec2 p, double tolerance) const;
    /// Returns the nearest region marker within the tolerance.
    std::optional<std::uint32_t> marker(Vec2 p, double tolerance) const;

    /// Returns the handles within a distance of p, the nearest ones first, at most `most`.
    std::vector<NodeHit> nodesNear(Vec2 p, double reach, std::size_t most, const Filter &filter = {}) const;
    /// Returns the straight segments within a distance of p, the nearest ones first, at most `most`.
    std::vector<SegmentHit> linesNear(Vec2 p, double reach, std::size_t most, const Filter &filter = {}) const;
    /// A circle or an arc of one, by its part of the drawing.
    struct CircleHit {
        SegmentRef ref;
        double radius = 0.0, away = 0.0; ///< distance from the place
    };
    /// Returns the circles and arcs of circles within a distance of p, the nearest ones first, at most `most`.
    std::vector<CircleHit> circlesNear(Vec2 p, double reach, std::size_t most, const Filter &filter = {}) const;

    /// Returns everything entirely inside a box; with `handles`, nodes instead of shapes.
    Selection inBox(const Box2 &box, bool handles) const;
    /// Returns the same for a closed line drawn by hand, by the even-odd rule; curves count as fine chords.
    Selection inLoop(std::span<const Vec2> loop, bool handles) const;

  private:
    struct Entry {
        std::uint32_t shape = 0; ///< position in Document::shapes
        std::uint32_t part = 0;  ///< handle or segment; of a centre, its segment
        Vec2 a, b;
        std::uint32_t curve = kNoCurve; ///< index into curves_
    };
    void addCentres(std::uint32_t shape, const Outline &outline);
    double lineDistance(const Entry &entry, Vec2 p) const;
    Curve curveOf(const Entry &entry) const;

    std::shared_ptr<const Document> document_;
    std::vector<Entry> handles_;
    std::vector<Entry> lines_; ///< segments, circles and points
    std::vector<Entry> centres_;
    std::vector<Curve> curves_;
    BoxTree handleTree_, lineTree_, shapeTree_, centreTree_;
};

} // namespace forefront
