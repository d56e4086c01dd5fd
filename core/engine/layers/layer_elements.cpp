#include "core/engine/layers/layer_elements.hpp"

#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/geometry/predicates.hpp"
#include "core/engine/layers/layer_outline.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace forefront {

namespace {

/// Returns the cotangent of the least angle of a triangle.
double cotangentOfLeast(Vec2 a, Vec2 b, Vec2 c) {
    const double area = cross(b - a, c - a);
    return std::max({dot(b - a, c - a), dot(c - b, a - b), dot(a - c, b - c)}) / area;
}

class LayerElements {
  public:
    LayerElements(const CutBoundary &boundary, const FinishedRays &rays, std::span<const LayerSpec> specs)
        : boundary_(boundary), rays_(rays), chains_(rays.chains), heights_(rays.heights), specs_(specs) {}

    BoundaryLayers make() {
        number();
        auto outer = std::make_shared<DiscreteDomain>(boundary_.domain);
        outer->nodes = nodes_;
        nodes_.insert(nodes_.end(), result_.inner.begin(), result_.inner.end());
        for (std::size_t c = 0; c < chains_.size(); ++c) {
            for (std::size_t i = 0; i < chains_[c].columns.size(); ++i) {
                addColumn(c, i);
            }
        }
        leaveFree(*outer);
        result_.outer = std::move(outer);
        LayerReport report = reportOf(rays_, boundary_.domain);
        report.quadrilaterals = result_.report.quadrilaterals;
        report.triangles = result_.report.triangles;
        result_.report = std::move(report);
        return std::move(result_);
    }

  private:
    /// The numbers of the nodes of a ray: those inside the layers follow each other, and so do those that slide.
    struct RayNodes {
        std::uint32_t inner = 0;
        std::uint32_t top = 0;
    };

    void number() {
        nodes_ = boundary_.domain.nodes;
        std::uint32_t inner = 0;
        for (const RayChain &chain : chains_) {
            numbers_.emplace_back();
            for (const LayerRay &ray : chain.rays) {
                RayNodes numbers{inner, ray.node};
                if (ray.slidNode == kNoIndex && ray.count > 0) {
                    numbers.top = static_cast<std::uint32_t>(nodes_.size());
                    nodes_.push_back(placeOn(ray, ray.count, heights_));
                    for (std::uint32_t k = 1; k < ray.count; ++k) {
                        result_.inner.push_back(placeOn(ray, k, heights_));
                    }
                    inner += ray.count - 1;
                }
                numbers_.back().push_back(numbers);
            }
        }
        for (std::vector<RayNodes> &chain : numbers_) {
            for (RayNodes &numbers : chain) {
                numbers.inner += static_cast<std::uint32_t>(nodes_.size());
            }
        }
    }

    std::uint32_t node(std::size_t chain, std::size_t ray, std::uint32_t k) const {
        const LayerRay &r = chains_[chain].rays[ray];
        if (k == 0) {
            return r.node;
        }
        if (r.slidNode != kNoIndex) {
            return r.slidNode + k - 1;
        }
        const RayNodes &numbers = numbers_[chain][ray];
        return k == r.count ? numbers.top : numbers.inner + k - 1;
    }

    void addColumn(std::size_t c, std::size_t i) {
        const RayChain &chain = chains_[c];
        const std::size_t j = i + 1 < chain.rays.size() ? i + 1 : 0;
        const WallEdge &edge = chain.columns[i];
        const DiscreteSegment &segment = boundary_.domain.segments[edge.segment];
        const bool fan = RayChain::isFan(edge);
        region_ = segment.a == edge.a ? segment.leftRegion : segment.rightRegion;
        const std::uint32_t p = chain.rays[i].count, q = chain.rays[j].count, both = std::min(p, q);
        for (std::uint32_t k = 0; k < both; ++k) {
            const std::uint32_t a = node(c, i, k), b = node(c, j, k), above = node(c, j, k + 1), d = node(c, i, k + 1);
            if (a == b) {
                addTriangle(a, above, d);
            } else {
                addQuad(a, b, above, d, specs_[edge.spec].cells);
            }
        }
        if (p != q && !(fan && both == 0)) {
            addTriangle(node(c, i, both), node(c, j, both), p > q ? node(c, i, p) : node(c, j, q));
        }
        if (p > 0 || q > 0) {
            tops_.push_back(segment);
            tops_.back().a = node(c, i, p);
            tops_.back().b = node(c, j, q);
            tops_.back().leftRegion = region_;
            tops_.back().rightRegion = kOutside;
        }
    }

    void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        result_.cells.push_back({{a, b, c, kNoIndex}, region_});
        ++result_.report.triangles;
    }

    void addQuad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, LayerCells cells) {
        if (cells == LayerCells::Quads) {
            result_.cells.push_back({{a, b, c, d}, region_});
            ++result_.report.quadrilaterals;
            return;
        }
        const Vec2 p = nodes_[a], q = nodes_[b], r = nodes_[c], s = nodes_[d];
        const double ac = std::max(cotangentOfLeast(p, q, r), cotangentOfLeast(p, r, s));
        const double bd = std::max(cotangentOfLeast(p, q, s), cotangentOfLeast(q, r, s));
        if (ac <= bd) {
            addTriangle(a, b, c);
            addTriangle(a, c, d);
        } else {
            addTriangle(a, b, d);
            addTriangle(b, c, d);
        }
    }

    /// Reduces a copy of the boundary to what the layers leave free.
    void leaveFree(DiscreteDomain &outer) {
        const std::vector<std::uint8_t> covered = coveredSides(boundary_.domain, chains_);
        std::vector<std::uint8_t> wasUsed(outer.nodes.size(), 0), isUsed(outer.nodes.size(), 0);
        std::vector<DiscreteSegment> segments;
        std::vector<CurveStretch> stretches;
        for (std::size_t s = 0; s < outer.segments.size(); ++s) {
            DiscreteSegment segment = outer.segments[s];
            wasUsed[segment.a] = wasUsed[segment.b] = 1;
            if (boundary_.besideLayers[s] != 0 || !isExposed(segment, covered[s])) {
                continue;
            }
            segment.leftRegion = (covered[s] & 1U) != 0 ? kOutside : segment.leftRegion;
            segment.rightRegion = (covered[s] & 2U) != 0 ? kOutside : segment.rightRegion;
            segments.push_back(segment);
            if (!outer.stretches.empty()) {
                stretches.push_back(outer.stretches[s]);
            }
        }
        if (!outer.stretches.empty()) {
            stretches.resize(segments.size() + tops_.size());
        }
        segments.insert(segments.end(), tops_.begin(), tops_.end());
        for (const DiscreteSegment &segment : segments) {
            isUsed[segment.a] = isUsed[segment.b] = 1;
        }
        outer.segments = std::move(segments);
        outer.stretches = std::move(stretches);
        // A tagged point on a wall is a node of the layers.
        std::erase_if(outer.points, [&](const ConstraintPoint &point) {
            return wasUsed[point.node] != 0 && isUsed[point.node] == 0;
        });
        dropGradedNodes(outer);
        for (const LayerCell &cell : result_.cells) {
            outer.regions[cell.region].area -= areaOf(cell);
        }
    }

    /// Drops the points without a tag that lie in the layers, or closer to their tops than half of a top: they lead the
    /// front to the size asked for, to which the tops lead it now.
    void dropGradedNodes(DiscreteDomain &outer) const {
        if (outer.gradedNodes == 0) {
            return;
        }
        std::vector<Box2> boxes;
        for (const LayerCell &cell : result_.cells) {
            Box2 &box = boxes.emplace_back();
            for (const std::uint32_t node : cell.nodes) {
                if (node != kNoIndex) {
                    box.add(nodes_[node]);
                }
            }
        }
        for (const DiscreteSegment &top : tops_) {
            Box2 box;
            box.add(nodes_[top.a]);
            box.add(nodes_[top.b]);
            boxes.push_back(box.grown(0.5 * distance(nodes_[top.a], nodes_[top.b])));
        }
        const BoxTree tree(boxes);
        const std::size_t tagged = outer.taggedPoints().size();
        std::size_t kept = tagged;
        for (std::size_t k = tagged; k < outer.points.size(); ++k) {
            const Vec2 p = outer.nodes[outer.points[k].node];
            bool covered = false;
            tree.query({p, p}, [&](std::uint32_t item) {
                covered = covered || item >= result_.cells.size() || holds(result_.cells[item], p);
            });
            if (!covered) {
                outer.points[kept++] = outer.points[k];
            }
        }
        outer.points.resize(kept);
        outer.gradedNodes = kept - tagged;
    }
    bool holds(const LayerCell &cell, Vec2 p) const {
        const std::size_t corners = cell.nodes[3] == kNoIndex ? 3 : 4;
        for (std::size_t k = 0; k < corners; ++k) {
            if (orientation(nodes_[cell.nodes[k]], nodes_[cell.nodes[(k + 1) % corners]], p) < 0) {
                return false;
            }
        }
        return true;
    }

    double areaOf(const LayerCell &cell) const {
        const Vec2 a = nodes_[cell.nodes[0]], b = nodes_[cell.nodes[1]], c = nodes_[cell.nodes[2]];
        const double half = 0.5 * cross(b - a, c - a);
        return cell.nodes[3] == kNoIndex ? half : half + 0.5 * cross(c - a, nodes_[cell.nodes[3]] - a);
    }

    const CutBoundary &boundary_;
    const FinishedRays &rays_;
    std::span<const RayChain> chains_;
    std::span<const LayerHeights> heights_;
    std::span<const LayerSpec> specs_;
    std::vector<std::vector<RayNodes>> numbers_; ///< per chain and ray
    std::vector<Vec2> nodes_;                    ///< of the boundary, then tops, then those inside the layers
    std::vector<DiscreteSegment> tops_;
    std::uint32_t region_ = 0; ///< of the column
    BoundaryLayers result_;
};

} // namespace

BoundaryLayers layerElements(const CutBoundary &boundary, const FinishedRays &rays, std::span<const LayerSpec> specs) {
    return LayerElements(boundary, rays, specs).make();
}

} // namespace forefront
