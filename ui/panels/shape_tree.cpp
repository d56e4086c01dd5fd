#include "ui/panels/shape_tree.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/typed_length.hpp"

#include <algorithm>

namespace forefront {
namespace {

using RowKind = TreeRow::Kind;

bool hasOneTag(const Shape &shape) {
    return shape.segmentTags.empty() || isRound(shape);
}

} // namespace

std::vector<std::pair<std::int32_t, std::size_t>> boundaryPartsOf(const Shape &shape) {
    if (hasOneTag(shape)) {
        return {{shape.tag, std::max<std::size_t>(1, taggedSegments(shape))}};
    }
    std::vector<std::pair<std::int32_t, std::size_t>> parts;
    std::map<std::int32_t, std::size_t> places;
    const std::size_t segments = taggedSegments(shape);
    for (std::size_t k = 0; k < segments; ++k) {
        const std::int32_t tag = segmentTag(shape, k);
        const auto [place, fresh] = places.emplace(tag, parts.size());
        if (fresh) {
            parts.emplace_back(tag, 0);
        }
        ++parts[place->second].second;
    }
    return parts;
}

namespace {

const char *groupName(RowKind kind) {
    return kind == RowKind::Shapes ? "Shapes" : kind == RowKind::Parts ? "Boundary parts" : "Regions";
}

const char *groupId(RowKind kind) {
    return kind == RowKind::Shapes ? "shapes" : kind == RowKind::Parts ? "parts" : "regions";
}

std::string countOf(std::size_t number, const char *one, const char *many) {
    return ui::count(number) + ' ' + (number == 1 ? one : many);
}

} // namespace

std::string rowName(const Document &document, const TreeRow &row) {
    const std::string name = "shapes/";
    switch (row.kind) {
    case RowKind::Shape:
        return name + std::to_string(document.shapes[row.index]->id);
    case RowKind::ShapePart:
        return name + std::to_string(document.shapes[row.index]->id) + "/part/" + std::to_string(row.tag);
    case RowKind::Part:
        return name + "part/" + std::to_string(row.tag);
    case RowKind::Region:
        return name + "region/" + std::to_string(row.index);
    default:
        return name + "group/" + groupId(row.kind);
    }
}

std::string rowTitle(const Document &document, const TreeRow &row) {
    switch (row.kind) {
    case RowKind::Shape:
        return displayName(*document.shapes[row.index]);
    case RowKind::ShapePart:
    case RowKind::Part:
        return boundaryName(document.boundaryNames, row.tag);
    case RowKind::Region:
        return regionName(document.regionNames, document.regionMarkers[row.index].tag);
    default:
        return groupName(row.kind);
    }
}

std::string rowDetail(const Document &document, const TreeRow &row) {
    switch (row.kind) {
    case RowKind::Shape: {
        const std::string tag =
            row.count > 1 ? countOf(row.count, "part", "parts") : boundaryName(document.boundaryNames, row.tag);
        const Shape &shape = *document.shapes[row.index];
        return (shape.group != 0 ? "group " + std::to_string(shape.group) + ", " : "") +
               (shape.use == ShapeUse::Constraint ? "inner line, " : "") + tag;
    }
    case RowKind::ShapePart:
    case RowKind::Part:
        return countOf(row.count, "segment", "segments");
    case RowKind::Region: {
        const double area = document.regionMarkers[row.index].maxArea;
        return area > 0.0 ? "area \xe2\x89\xa4 " + ui::grouped(area, 3) + areaSuffix(document.unit) : std::string();
    }
    default:
        return ui::count(row.count);
    }
}

std::set<SegmentRef> segmentsOf(const Shape &shape, std::int32_t tag) {
    std::set<SegmentRef> segments;
    for (std::uint32_t k = 0; k < taggedSegments(shape); ++k) {
        if (segmentTag(shape, k) == tag) {
            segments.insert({shape.id, k});
        }
    }
    return segments;
}

void ShapeTree::follow(const Document &document, std::uint64_t revision) {
    constexpr int kLoads = 40; // see DocumentStore::revision()
    if ((revision >> kLoads) != (revision_ >> kLoads)) {
        unfolded_.clear(); // the ids are those of another drawing
    }
    if (stale_ || revision != revision_) {
        revision_ = revision;
        stale_ = false;
        build(document);
    }
}

void ShapeTree::build(const Document &document) {
    rows_.clear();
    tags_.clear();
    const bool open = !folded(RowKind::Shapes);
    rows_.push_back({.kind = RowKind::Shapes, .count = document.shapes.size()});
    for (std::uint32_t k = 0; k < document.shapes.size(); ++k) {
        const Shape &shape = *document.shapes[k];
        if (hasOneTag(shape)) {
            tags_[shape.tag] += std::max<std::size_t>(1, taggedSegments(shape));
            if (open) {
                rows_.push_back({.kind = RowKind::Shape, .index = k, .tag = shape.tag, .count = 1});
            }
            continue;
        }
        const auto parts = boundaryPartsOf(shape);
        if (open) {
            rows_.push_back({.kind = RowKind::Shape, .index = k, .tag = parts.front().first, .count = parts.size()});
        }
        const bool shown = open && parts.size() > 1 && unfolded(shape.id);
        for (const auto &[tag, count] : parts) {
            tags_[tag] += count;
            if (shown) {
                rows_.push_back({.kind = RowKind::ShapePart, .index = k, .tag = tag, .count = count});
            }
        }
    }
    rows_.push_back({.kind = RowKind::Parts, .count = tags_.size()});
    if (!folded(RowKind::Parts)) {
        for (const auto &[tag, count] : tags_) {
            rows_.push_back({.kind = RowKind::Part, .tag = tag, .count = count});
        }
    }
    const std::size_t regions = document.regionMarkers.size();
    rows_.push_back({.kind = RowKind::Regions, .count = regions});
    for (std::uint32_t k = 0; k < regions && !folded(RowKind::Regions); ++k) {
        rows_.push_back({.kind = RowKind::Region, .index = k, .tag = document.regionMarkers[k].tag});
    }
}

void ShapeTree::fold(RowKind group, bool folds) {
    stale_ = (folds ? folded_.insert(group).second : folded_.erase(group) > 0) || stale_;
}

void ShapeTree::unfold(std::uint32_t shape, bool unfolds) {
    stale_ = (unfolds ? unfolded_.insert(shape).second : unfolded_.erase(shape) > 0) || stale_;
}

void ShapeTree::foldAll(const Document &document, bool folds) {
    unfolded_.clear();
    folded_.clear();
    if (folds) {
        folded_ = {RowKind::Shapes, RowKind::Parts, RowKind::Regions};
    }
    for (std::size_t k = 0; k < document.shapes.size() && !folds; ++k) {
        unfolded_.insert(document.shapes[k]->id);
    }
    stale_ = true;
}

std::optional<std::size_t> ShapeTree::reveal(const Document &document, const Selection &selection) {
    TreeRow wanted;
    if (!selection.shapes.empty()) {
        wanted = {.kind = RowKind::Shape,
                  .index = static_cast<std::uint32_t>(positionOf(document, *selection.shapes.begin()))};
    } else if (!selection.segments.empty()) {
        const SegmentRef first = *selection.segments.begin();
        const std::size_t place = positionOf(document, first.shape);
        if (place == document.shapes.size()) {
            return std::nullopt;
        }
        const Shape &shape = *document.shapes[place];
        const bool several = boundaryPartsOf(shape).size() > 1;
        wanted = {.kind = several ? RowKind::ShapePart : RowKind::Shape,
                  .index = static_cast<std::uint32_t>(place),
                  .tag = segmentTag(shape, first.segment)};
    } else if (!selection.nodes.empty()) {
        wanted = {.kind = RowKind::Shape,
                  .index = static_cast<std::uint32_t>(positionOf(document, selection.nodes.begin()->shape))};
    } else if (!selection.markers.empty()) {
        wanted = {.kind = RowKind::Region, .index = *selection.markers.begin()};
    } else {
        return std::nullopt;
    }
    return reveal(document, wanted);
}

std::optional<std::size_t> ShapeTree::reveal(const Document &document, const TreeRow &wanted) {
    if (wanted.kind == RowKind::ShapePart && wanted.index < document.shapes.size()) {
        unfold(document.shapes[wanted.index]->id, true);
    }
    fold(wanted.kind == RowKind::Region ? RowKind::Regions
         : wanted.kind == RowKind::Part ? RowKind::Parts
                                        : RowKind::Shapes,
         false);
    follow(document, revision_);
    const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const TreeRow &row) { return row.same(wanted); });
    return found == rows_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - rows_.begin()));
}

std::set<std::int32_t> ShapeTree::selectedTags(const Document &document, const Selection &selection) const {
    std::map<std::int32_t, std::size_t> counts;
    for (const std::uint32_t id : selection.shapes) {
        if (const Shape *const shape = findShape(document, id)) {
            for (const auto &[tag, count] : boundaryPartsOf(*shape)) {
                counts[tag] += count;
            }
        }
    }
    for (const SegmentRef segment : selection.segments) {
        const Shape *const shape =
            selection.shapes.contains(segment.shape) ? nullptr : findShape(document, segment.shape);
        if (shape != nullptr) {
            ++counts[segmentTag(*shape, segment.segment)];
        }
    }
    std::set<std::int32_t> all;
    for (const auto &[tag, count] : counts) {
        const auto known = tags_.find(tag);
        if (known != tags_.end() && known->second == count) {
            all.insert(tag);
        }
    }
    return all;
}

std::set<ShapePartKey> selectedParts(const Document &document, const Selection &selection) {
    std::map<ShapePartKey, std::size_t> counts;
    for (const SegmentRef segment : selection.segments) {
        if (const Shape *const shape = findShape(document, segment.shape)) {
            ++counts[{segment.shape, segmentTag(*shape, segment.segment)}];
        }
    }
    std::set<ShapePartKey> whole;
    const Shape *shape = nullptr;
    std::vector<std::pair<std::int32_t, std::size_t>> parts; // of that shape
    for (const auto &[part, count] : counts) {
        if (shape == nullptr || shape->id != part.first) {
            shape = findShape(document, part.first);
            parts = boundaryPartsOf(*shape);
        }
        if (std::find(parts.begin(), parts.end(), std::pair(part.second, count)) != parts.end()) {
            whole.insert(part);
        }
    }
    return whole;
}

} // namespace forefront
