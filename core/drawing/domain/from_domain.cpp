#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/chain_shape.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/domain/hole_markers.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/domain/validate.hpp"

#include <algorithm>

namespace forefront {
namespace {

/// A chain of segments.
struct Chain {
    std::vector<std::uint32_t> nodes; ///< a closed chain does not repeat its first node
    std::vector<std::uint32_t> segments;
    bool closed = false;
};

/// Chains the segments of one role: a chain continues through every node where exactly two of them meet.
class Chainer {
  public:
    Chainer(const Domain &domain, SegmentRole role) : domain_(domain), role_(role) {
        starts_.assign(domain.nodes.size() + 1, 0);
        for (const DomainSegment &segment : domain.segments) {
            if (takes(segment)) {
                ++starts_[segment.a + 1];
                ++starts_[segment.b + 1];
            }
        }
        for (std::size_t k = 1; k < starts_.size(); ++k) {
            starts_[k] += starts_[k - 1];
        }
        around_.resize(starts_.back());
        std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
        for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
            if (takes(domain.segments[s])) {
                around_[next[domain.segments[s].a]++] = s;
                around_[next[domain.segments[s].b]++] = s;
            }
        }
        used_.assign(domain.segments.size(), false);
    }

    /// Finds open chains first (from ends and junctions), then loops, both in the order of their first segments.
    std::vector<Chain> chains() {
        std::vector<Chain> result;
        for (std::uint32_t s = 0; s < domain_.segments.size(); ++s) {
            const DomainSegment &segment = domain_.segments[s];
            if (!takes(segment)) {
                continue;
            }
            if (!used_[s] && degree(segment.a) != 2) {
                result.push_back(walk(s, segment.a));
            }
            if (!used_[s] && degree(segment.b) != 2) {
                result.push_back(walk(s, segment.b));
            }
        }
        for (std::uint32_t s = 0; s < domain_.segments.size(); ++s) {
            if (takes(domain_.segments[s]) && !used_[s]) {
                result.push_back(walk(s, domain_.segments[s].a));
            }
        }
        return result;
    }

  private:
    bool takes(const DomainSegment &segment) const {
        return segment.role == role_ && segment.a < domain_.nodes.size() && segment.b < domain_.nodes.size();
    }
    std::uint32_t degree(std::uint32_t node) const { return starts_[node + 1] - starts_[node]; }

    Chain walk(std::uint32_t segment, std::uint32_t from) {
        Chain chain;
        chain.nodes.push_back(from);
        std::uint32_t at = from;
        while (segment != kNoIndex) {
            used_[segment] = true;
            const DomainSegment &s = domain_.segments[segment];
            at = s.a == at ? s.b : s.a;
            chain.segments.push_back(segment);
            chain.nodes.push_back(at);
            segment = kNoIndex;
            if (degree(at) == 2) {
                for (std::uint32_t k = starts_[at]; k < starts_[at + 1]; ++k) {
                    if (!used_[around_[k]]) {
                        segment = around_[k];
                        break;
                    }
                }
            }
        }
        if (at == from && chain.segments.size() > 2) {
            chain.closed = true;
            chain.nodes.pop_back();
        }
        return chain;
    }

    const Domain &domain_;
    SegmentRole role_;
    std::vector<std::uint32_t> starts_; ///< per node, into around_
    std::vector<std::uint32_t> around_; ///< segments by node
    std::vector<bool> used_;
};

std::shared_ptr<const Shape> pointShape(Vec2 at, ShapeUse use, std::int32_t tag, std::uint32_t id) {
    auto shape = std::make_shared<Shape>();
    shape->id = id;
    shape->kind = ShapeKind::Point;
    shape->use = use;
    shape->nodes = {at};
    shape->tag = tag;
    return shape;
}

void addPoints(const Domain &domain, Document &document) {
    std::vector<bool> used(domain.nodes.size(), false);
    for (const DomainSegment &segment : domain.segments) {
        if (segment.a < used.size() && segment.b < used.size()) {
            used[segment.a] = used[segment.b] = true;
        }
    }
    for (const ConstraintPoint &point : domain.points) {
        if (point.node < used.size()) {
            used[point.node] = true;
            document.shapes.push_back(
                pointShape(domain.nodes[point.node], ShapeUse::Constraint, point.tag, document.nextId++));
        }
    }
    // An unreferenced node stays visible, and validation reports it; it is not dropped silently.
    for (std::size_t node = 0; node < used.size(); ++node) {
        if (!used[node]) {
            document.shapes.push_back(pointShape(domain.nodes[node], ShapeUse::Boundary, 1, document.nextId++));
        }
    }
}

void addChains(const Domain &domain, LooseEnds ends, Document &document) {
    const ChainShapes shapes(domain, ends);
    for (const SegmentRole role : {SegmentRole::Boundary, SegmentRole::Constraint}) {
        for (const Chain &chain : Chainer(domain, role).chains()) {
            Shape shape = shapes.make(chain.nodes, chain.segments, chain.closed);
            shape.id = document.nextId++;
            shape.use = role == SegmentRole::Boundary ? ShapeUse::Boundary : ShapeUse::Constraint;
            document.shapes.push_back(std::make_shared<const Shape>(std::move(shape)));
        }
    }
}

} // namespace

Document fromDomain(const Domain &domain, LooseEnds ends) {
    Document document;
    if (domain.insideRule == InsideRule::HoleMarkers) {
        addChains(withEvenOddRoles(domain), ends, document);
    } else {
        addChains(domain, ends, document);
    }
    addPoints(domain, document);
    document.regionMarkers = domain.regionMarkers;
    document.boundaryNames = domain.boundaryNames;
    document.regionNames = domain.regionNames;
    document.curveTolerance = domain.curveTolerance;
    return document;
}

Document fromDomain(const Domain &domain) {
    Document document = fromDomain(domain, LooseEnds::MoveCurve);
    // Whole curves that are moved to end at their nodes may cross others nearby, or leave a region's marker.
    if (ChainShapes(domain).anyLooseEnd() && validate(toDomain(document)).size() > validate(domain).size()) {
        return fromDomain(domain, LooseEnds::MoveChord);
    }
    return document;
}

} // namespace forefront
