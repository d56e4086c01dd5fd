#include "core/drawing/shapes/boundary_loops.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/base/rows.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/geometry/predicates.hpp"

#include <algorithm>
#include <span>

namespace forefront {
namespace {

/// Follows directed boundary segments with the inside on their left.
class LoopTracer {
  public:
    explicit LoopTracer(const Domain &domain) : domain_(domain) {}

    std::optional<std::vector<BoundaryLoop>> run() {
        if (!direct()) {
            return std::nullopt;
        }
        collectLeaving();
        std::vector<std::uint8_t> used(domain_.segments.size(), 0);
        std::vector<BoundaryLoop> loops;
        for (std::uint32_t s = 0; s < domain_.segments.size(); ++s) {
            if (from_[s] == kNoIndex || used[s] != 0) {
                continue;
            }
            BoundaryLoop &loop = loops.emplace_back();
            for (std::uint32_t at = s; used[at] == 0; at = next(at)) {
                used[at] = 1;
                loop.nodes.push_back(from_[at]);
                loop.segments.push_back(at);
            }
        }
        return loops;
    }

  private:
    /// Directs the boundary segments; returns false if there are no faces.
    bool direct() {
        const DomainGraph graph = graphOf(domain_);
        const PlaneSweepResult sweep = sweepPlane(graph.points, graph.edges);
        std::vector<std::uint8_t> odd(domain_.nodes.size(), 0);
        for (const std::uint32_t s : graph.segment) {
            const DomainSegment &segment = domain_.segments[s];
            for (const std::uint32_t end : {segment.a, segment.b}) {
                odd[end] = (odd[end] != 0) != (segment.role == SegmentRole::Boundary);
            }
        }
        if (sweep.droppedCount > 0 || std::find(odd.begin(), odd.end(), 1) != odd.end()) {
            return false;
        }
        const Faces faces = findFaces(graph.points, graph.edges, sweep);
        const FaceLabels labels = labelFaces(domain_, graph, faces);
        from_.assign(domain_.segments.size(), kNoIndex);
        to_ = from_;
        for (std::size_t e = 0; e < graph.edges.size(); ++e) {
            const DomainSegment &segment = domain_.segments[graph.segment[e]];
            if (segment.role == SegmentRole::Boundary) {
                const bool forward = labels.inside[faces.left[e]] != 0;
                from_[graph.segment[e]] = forward ? segment.a : segment.b;
                to_[graph.segment[e]] = forward ? segment.b : segment.a;
            }
        }
        return true;
    }

    void collectLeaving() {
        leaving_ = Rows<std::uint32_t>(domain_.nodes.size(), [this](const auto &add) {
            for (std::uint32_t s = 0; s < from_.size(); ++s) {
                if (from_[s] != kNoIndex) {
                    add(from_[s], s);
                }
            }
        });
    }

    /// Returns the segment that continues around the same face: the first one clockwise from the way back.
    std::uint32_t next(std::uint32_t segment) const {
        const std::uint32_t node = to_[segment];
        const std::span<const std::uint32_t> here = leaving_[node];
        std::uint32_t best = here.front();
        for (const std::uint32_t other : here.subspan(1)) {
            if (isBefore(node, from_[segment], to_[other], to_[best])) {
                best = other;
            }
        }
        return best;
    }

    /// Returns true if a ray from `node` that turns clockwise from `start` meets p before q.
    bool isBefore(std::uint32_t node, std::uint32_t start, std::uint32_t p, std::uint32_t q) const {
        const auto turn = [&](std::uint32_t m, std::uint32_t n) {
            return orientation(domain_.nodes[node], domain_.nodes[m], domain_.nodes[n]);
        };
        const auto part = [&](std::uint32_t n) { return turn(start, n) < 0 ? 0 : turn(start, n) == 0 ? 1 : 2; };
        return part(p) != part(q) ? part(p) < part(q) : turn(p, q) < 0;
    }

    const Domain &domain_;
    std::vector<std::uint32_t> from_, to_; ///< per segment: its ends; kNoIndex for constraints
    Rows<std::uint32_t> leaving_;          ///< segments that leave each node
};

} // namespace

std::optional<std::vector<BoundaryLoop>> boundaryLoops(const Domain &domain) {
    return LoopTracer(domain).run();
}

} // namespace forefront
