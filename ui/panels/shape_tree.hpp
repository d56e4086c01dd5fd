#pragma once

#include "core/drawing/shapes/references.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

/// A row of the tree of the drawing.
struct TreeRow {
    enum class Kind : std::uint8_t {
        Shapes,    ///< the three groups
        Parts,     //
        Regions,   //
        Shape,     ///< in Shapes
        ShapePart, ///< a boundary part of the shape above
        Part,      ///< a boundary tag, in Parts
        Region     ///< a region marker, in Regions
    };
    Kind kind = Kind::Shapes;
    std::uint32_t index = 0; ///< of the shape in Document::shapes, of the region in Document::regionMarkers
    std::int32_t tag = 0;    ///< of a part
    std::size_t count = 0;   ///< items of a group, segments and points of a part, parts of a shape

    bool isGroup() const { return kind <= Kind::Regions; }
    /// Returns true for a row of the same thing in the same document.
    bool same(const TreeRow &other) const {
        const bool tagged = kind == Kind::ShapePart || kind == Kind::Part;
        return kind == other.kind && index == other.index && (!tagged || tag == other.tag);
    }
};

/// Returns the name of the widget of a row.
std::string rowName(const Document &document, const TreeRow &row);
std::string rowTitle(const Document &document, const TreeRow &row);
/// Returns the grey text at the right of a row.
std::string rowDetail(const Document &document, const TreeRow &row);
/// Returns the segments of a boundary part of a shape.
std::set<SegmentRef> segmentsOf(const Shape &shape, std::int32_t tag);

/// The drawing as a tree: shapes with their boundary parts, boundary parts by tag, regions. Its rows are those that are
/// not folded away.
class ShapeTree {
  public:
    /// Rebuilds the rows if the document or the folding has changed.
    void follow(const Document &document, std::uint64_t revision);
    const std::vector<TreeRow> &rows() const { return rows_; }

    bool folded(TreeRow::Kind group) const { return folded_.contains(group); }
    void fold(TreeRow::Kind group, bool folds);
    /// Shapes are folded at first.
    bool unfolded(std::uint32_t shape) const { return unfolded_.contains(shape); }
    void unfold(std::uint32_t shape, bool unfolds);
    void foldAll(const Document &document, bool folds);

    /// Unfolds the groups and shapes around the selection and returns its first row.
    std::optional<std::size_t> reveal(const Document &document, const Selection &selection);
    /// Unfolds the groups and shapes around a row and returns its index; the number of items of `wanted` is ignored.
    std::optional<std::size_t> reveal(const Document &document, const TreeRow &wanted);
    /// Returns the boundary tags of which every segment and point is selected.
    std::set<std::int32_t> selectedTags(const Document &document, const Selection &selection) const;

  private:
    void build(const Document &document);

    std::vector<TreeRow> rows_;
    std::map<std::int32_t, std::size_t> tags_; ///< number of segments and points of each boundary tag
    std::set<TreeRow::Kind> folded_;
    std::set<std::uint32_t> unfolded_; ///< ids of shapes
    std::uint64_t revision_ = 0;
    bool stale_ = true;
};

/// A boundary part of a shape: its id and the tag.
using ShapePartKey = std::pair<std::uint32_t, std::int32_t>;
/// Returns the boundary parts of shapes of which every segment is selected, besides those of selected shapes.
std::set<ShapePartKey> selectedParts(const Document &document, const Selection &selection);

/// Returns the boundary parts of a shape in the order of its segments, with their numbers of segments.
std::vector<std::pair<std::int32_t, std::size_t>> boundaryPartsOf(const Shape &shape);

} // namespace forefront
