#include "core/engine/domain/chains/chain_order.hpp"

#include "core/engine/domain/chains/segment_chains.hpp"
#include "core/engine/domain/node_merger.hpp"
#include "core/engine/domain/validate.hpp"

namespace forefront {
namespace {

/// Adds chains of a domain to another one, which it builds.
class ChainOrderer {
  public:
    ChainOrderer(const Domain &domain, LooseEnds ends, ChainOrder &order)
        : domain_(domain), paths_(domain, ends), order_(order), merger_(ordered_.nodes) {
        ordered_.nodes.reserve(domain.nodes.size());
        ordered_.segments.reserve(domain.segments.size());
        merger_.reserve(domain.nodes.size());
    }

    Domain run() {
        for (const SegmentRole role : {SegmentRole::Boundary, SegmentRole::Constraint}) {
            for (const SegmentChain &chain : segmentChains(domain_, role)) {
                addPath(paths_.make(chain.nodes, chain.segments, chain.closed), role);
            }
        }
        addPoints();
        ordered_.holeMarkers = domain_.holeMarkers;
        ordered_.regionMarkers = domain_.regionMarkers;
        ordered_.insideRule = domain_.insideRule;
        ordered_.curveTolerance = domain_.curveTolerance;
        ordered_.boundaryNames = domain_.boundaryNames;
        ordered_.regionNames = domain_.regionNames;
        return std::move(ordered_);
    }

  private:
    std::uint32_t addNode(Vec2 at, std::uint32_t from) {
        const std::uint32_t node = merger_.add(at);
        if (order_.nodes.size() < ordered_.nodes.size()) {
            order_.nodes.push_back(from);
        }
        return node;
    }

    void addSegment(const ChainPath &path, std::size_t part, SegmentRole role, const CurveStretch &stretch) {
        const std::size_t chord = ids_.size();
        ids_.push_back(addNode(stretch.t0 > 0.0 ? path.curves[part].point(stretch.t0) : path.nodes[part],
                               path.chords[chord].node));
        ordered_.segments.push_back({ids_.back(), 0, path.tags[part], role, stretch});
        order_.segments.push_back(path.chords[chord].segment);
    }

    void addPath(const ChainPath &path, SegmentRole role) {
        const std::size_t first = ordered_.segments.size();
        ids_.clear();
        for (std::size_t part = 0; part < path.tags.size(); ++part) {
            if (part >= path.curves.size() || path.curves[part].kind() == CurveKind::Line) {
                addSegment(path, part, role, {});
                continue;
            }
            const auto curve = static_cast<std::uint32_t>(ordered_.curves.size());
            ordered_.curves.push_back(path.curves[part]);
            double from = 0.0;
            for (const double cut : path.cuts[part]) {
                addSegment(path, part, role, {curve, from, cut});
                from = cut;
            }
            if (from < 1.0) {
                addSegment(path, part, role, {curve, from, 1.0});
            }
        }
        ids_.push_back(path.closed ? ids_.front() : addNode(path.nodes.back(), path.end));
        for (std::size_t k = first; k < ordered_.segments.size(); ++k) {
            ordered_.segments[k].b = ids_[k - first + 1];
        }
    }

    void addPoints() {
        std::vector<bool> used(domain_.nodes.size(), false);
        for (const DomainSegment &segment : domain_.segments) {
            if (segment.a < used.size() && segment.b < used.size()) {
                used[segment.a] = used[segment.b] = true;
            }
        }
        for (std::uint32_t p = 0; p < domain_.points.size(); ++p) {
            const ConstraintPoint &point = domain_.points[p];
            if (point.node < used.size()) {
                used[point.node] = true;
                ordered_.points.push_back({addNode(domain_.nodes[point.node], point.node), point.tag});
                order_.points.push_back(p);
            }
        }
        // A node that nothing refers to stays for validation to report.
        for (std::uint32_t node = 0; node < used.size(); ++node) {
            if (!used[node]) {
                addNode(domain_.nodes[node], node);
            }
        }
    }

    const Domain &domain_;
    ChainPaths paths_;
    ChainOrder &order_;
    Domain ordered_;
    NodeMerger merger_;
    std::vector<std::uint32_t> ids_; ///< new nodes along the path
};

} // namespace

Domain inChainOrder(const Domain &domain, LooseEnds ends, ChainOrder *order) {
    ChainOrder own;
    ChainOrder &filled = order != nullptr ? *order : own;
    filled = {};
    return ChainOrderer(domain, ends, filled).run();
}

Domain inChainOrder(const Domain &domain, ChainOrder *order) {
    return inChainOrder(domain, bestLooseEnds(domain), order);
}

LooseEnds bestLooseEnds(const Domain &domain) {
    if (!ChainPaths(domain).anyLooseEnd()) {
        return LooseEnds::MoveCurve;
    }
    const Domain moved = inChainOrder(domain, LooseEnds::MoveCurve);
    return validate(moved).size() > validate(domain).size() ? LooseEnds::MoveChord : LooseEnds::MoveCurve;
}

} // namespace forefront
