#pragma once

#include "core/edit/references.hpp"
#include "core/geometry/box_tree.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace forefront {

struct NodeHit {
    NodeRef ref;
    Vec2 at;
    double distance = 0.0;
};

struct SegmentHit {
    SegmentRef ref;
    Vec2 a, b;      ///< ends; of a circle both are the nearest point
    Vec2 at;        ///< nearest point on the segment or circle
    double t = 0.0; ///< place of `at` between a and b
    double distance = 0.0;
};

/// Answers what is near a point of a document, in O(log n). Built once per document; holds it.
class PickIndex {
  public:
    explicit PickIndex(std::shared_ptr<const Document> document);

    const Document &document() const { return *document_; }

    /// Judges a shape of the document: false leaves it out of a search (the one being dragged, for example).
    using Filter = std::function<bool(const Shape &)>;

    /// The handle nearest to p, not farther than `tolerance` (domain units); of equally near ones, the one drawn last.
    std::optional<NodeHit> node(Vec2 p, double tolerance, const Filter &filter = {}) const;
    /// The segment or circle nearest to p.
    std::optional<SegmentHit> segment(Vec2 p, double tolerance, const Filter &filter = {}) const;
    /// The shape under p: the one whose line or point is within the tolerance, else the smallest closed one that
    /// contains p. kNoIndex: none.
    std::uint32_t shape(Vec2 p, double tolerance) const;
    /// The size source whose drawn shape is within the tolerance (index), and the handle meant.
    struct SourceHit {
        std::uint32_t source = 0;
        enum class Part : std::uint8_t { A, B, Whole, Rim } part = Part::A;
    };
    std::optional<SourceHit> source(Vec2 p, double tolerance) const;
    /// The region marker within the tolerance.
    std::optional<std::uint32_t> marker(Vec2 p, double tolerance) const;

    /// What lies wholly inside a box; `handles`: nodes instead of shapes.
    Selection inBox(const Box2 &box, bool handles) const;

  private:
    struct Entry {
        std::uint32_t shape = 0; ///< position in Document::shapes
        std::uint32_t part = 0;  ///< handle or segment
        Vec2 a, b;
    };
    double lineDistance(const Entry &entry, Vec2 p) const;

    std::shared_ptr<const Document> document_;
    std::vector<Entry> handles_;
    std::vector<Entry> lines_; ///< segments, circles and points
    BoxTree handleTree_, lineTree_, shapeTree_;
};

} // namespace forefront
