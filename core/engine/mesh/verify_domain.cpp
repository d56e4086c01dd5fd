#include "core/engine/base/number_text.hpp"
#include "core/engine/base/out_of_memory.hpp"
#include "core/engine/domain/curve_chains.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "core/engine/mesh/cracks.hpp"
#include "core/engine/mesh/edge_table.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/mesh/verify_discrete.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace forefront {

namespace {

/// The edges that may lie along segments of the domain, in rows by node: the tagged edges, or all edges where the file
/// keeps no tags.
class ChainEdges {
  public:
    ChainEdges(const MeshView &mesh, bool tagged) : offsets_(mesh.nodes.size() + 1, 0) {
        std::vector<std::pair<NodeId, NodeId>> edges;
        if (tagged) {
            for (const TaggedEdge &edge : mesh.edges) {
                edges.emplace_back(edge.a, edge.b);
            }
        } else {
            EdgeTable(mesh).forEach(
                [&edges](NodeId a, NodeId b, std::span<const HalfEdge>) { edges.emplace_back(a, b); });
        }
        for (const auto &[a, b] : edges) {
            ++offsets_[index(a)];
            ++offsets_[index(b)];
        }
        std::uint32_t sum = 0;
        for (std::uint32_t &offset : offsets_) {
            sum += offset;
            offset = sum;
        }
        others_.resize(sum);
        for (const auto &[a, b] : edges) {
            others_[--offsets_[index(a)]] = b;
            others_[--offsets_[index(b)]] = a;
        }
    }
    std::span<const NodeId> at(NodeId node) const {
        const std::uint32_t begin = offsets_[index(node)];
        return {others_.data() + begin, offsets_[index(node) + 1] - begin};
    }

  private:
    std::vector<std::uint32_t> offsets_;
    std::vector<NodeId> others_;
};

/// A node that a walk along a segment or curve can go to next, and how far along that is.
struct NextNode {
    NodeId node = kNoNode;
    double at = 0.0;     ///< parameter, or place along a segment
    bool beside = false; ///< only within the tolerance

    /// Orders nodes on the curve before those beside it, then by parameter: beside a needle, its other side is within
    /// the tolerance, too.
    friend bool operator<(const NextNode &x, const NextNode &y) {
        return std::tie(x.beside, x.at) < std::tie(y.beside, y.at);
    }
};

/// Returns the nodes of a walk from one node to another; empty if there is none. For a loop, both are the same.
/// `choices(nodes, reached)` returns the nodes that a walk so far can go to next, all of them farther along. Where one
/// leads nowhere, the walk goes back to the last other choice, and never comes to that node again.
template <class Choices>
std::vector<NodeId> walk(NodeId from, NodeId to, double start, const Choices &choices) {
    std::vector<NodeId> nodes{from};
    std::vector<double> reached{start};
    std::vector<std::vector<NextNode>> open; // per node of the walk; the best one last
    std::set<NodeId> dead;
    do {
        open.push_back(choices(nodes, reached.back()));
        std::sort(open.back().rbegin(), open.back().rend());
        const auto isDead = [&](const NextNode &next) { return next.node != to && dead.contains(next.node); };
        while (open.back().empty() || isDead(open.back().back())) {
            if (!open.back().empty()) {
                open.back().pop_back();
                continue;
            }
            open.pop_back(); // back to where there may be another choice
            if (open.empty()) {
                return {};
            }
            if (from != to || nodes.size() > 2) { // a loop may end at the node that it may not begin with
                dead.insert(nodes.back());
            }
            nodes.pop_back();
            reached.pop_back();
        }
        nodes.push_back(open.back().back().node);
        reached.push_back(open.back().back().at);
        open.back().pop_back();
    } while (nodes.back() != to);
    return nodes;
}

/// Returns the nodes of the mesh from one end of a straight segment to the other, along edges within `tolerance` of it;
/// empty when there is no such chain. In a needle the other side is within the tolerance as well, but leads elsewhere.
std::vector<NodeId> chain(const MeshView &mesh, const ChainEdges &edges, NodeId from, NodeId to, double tolerance) {
    constexpr double kOn = 1e-4; // of the tolerance
    const Vec2 a = mesh.nodes[index(from)], end = mesh.nodes[index(to)];
    const Vec2 along = end - a;
    const double maxCross = tolerance * length(along);
    return walk(from, to, 0.0, [&](const std::vector<NodeId> &nodes, double) {
        std::vector<NextNode> found;
        if (nodes.size() > mesh.nodes.size()) {
            return found; // rounding leads it round and round
        }
        for (const NodeId next : edges.at(nodes.back())) {
            // Steps are measured between neighbours: distances from an end far away would round them to nothing.
            const Vec2 p = mesh.nodes[index(next)];
            const double step = dot(along, p - mesh.nodes[index(nodes.back())]), off = std::abs(cross(along, p - a));
            if (step > 0.0 && (next == to || dot(along, end - p) > 0.0) && off <= maxCross) {
                found.push_back({next, step, off > kOn * maxCross});
            }
        }
        return found;
    });
}

/// Walks along the curve of a chain from one of its ends to the other.
class CurveWalk {
  public:
    CurveWalk(const Domain &domain, const CurveChain &chain, SegmentElements elements, double tolerance)
        : domain_(domain), chain_(chain), curve_(domain.curves[chain.curve]), tolerance_(tolerance),
          deviation_(chordTolerance(domain)) {
        for (const std::uint32_t number : chain.segments) {
            const DomainSegment &segment = domain.segments[number];
            boxes_.push_back(curve_.bounds(segment.stretch.t0, segment.stretch.t1));
            boxes_.back().add(boxOf(domain.nodes[segment.a], domain.nodes[segment.b]));
            boxes_.back() = boxes_.back().grown(tolerance);
            deviation_ = std::max(deviation_, curve_.deviation(segment.stretch.t0, segment.stretch.t1));
        }
        deviation_ *= 1.01; // parameters of nodes are rounded
        if (elementsAlong(domain, chain, elements) > 0) {
            deviation_ = curve_.length(chain.t0, chain.t1); // few elements may be anywhere between their nodes
        }
    }

    /// Returns the area by which chords of the curve may differ.
    double areaBetween() const { return 2.0 * deviation_ * curve_.length(chain_.t0, chain_.t1); }

    /// Returns the nodes of the mesh on the curve or its chords; empty when they do not reach the end, or when an edge
    /// is farther from the curve than it may be.
    std::vector<NodeId> nodes(const MeshView &mesh, const ChainEdges &edges, NodeId from, NodeId to) const {
        return walk(from, to, chain_.t0, [&](const std::vector<NodeId> &nodes, double reached) {
            std::vector<NextNode> found;
            for (const NodeId next : edges.at(nodes.back())) {
                if (nodes.size() > 1 && next == nodes[nodes.size() - 2]) {
                    continue; // where it came from
                }
                const NextNode spot =
                    next == to ? NextNode{to, chain_.t1, false} : find(next, mesh.nodes[index(next)], reached);
                if (spot.node != kNoNode && spot.at > reached && curve_.deviation(reached, spot.at) <= deviation_) {
                    found.push_back(spot);
                }
            }
            return found;
        });
    }

    /// Returns true if a place between its ends lies on the curve or its chords.
    bool holds(Vec2 place) const { return find(NodeId{0}, place, chain_.t0).node != kNoNode; }

  private:
    /// Finds a node on the curve or its chords at the first parameter beyond another one; kNoNode: it is on neither.
    NextNode find(NodeId node, Vec2 p, double reached) const {
        constexpr double kOn = 1e-4; // of the tolerance
        for (std::size_t k = 0; k < boxes_.size(); ++k) {
            const DomainSegment &segment = domain_.segments[chain_.segments[k]];
            const double low = std::max(reached, std::min(segment.stretch.t0, segment.stretch.t1));
            const double high = std::max(segment.stretch.t0, segment.stretch.t1);
            const Vec2 a = domain_.nodes[segment.a], b = domain_.nodes[segment.b];
            if (high <= reached || !boxes_[k].contains(p)) {
                continue;
            }
            const double at = curve_.nearest(p, low, high);
            const double offset = std::min(distance(curve_.point(at), p), distanceToSegment(a, b, p));
            if (at > reached && offset <= tolerance_) {
                return {node, at, offset > kOn * tolerance_};
            }
        }
        return {};
    }

    const Domain &domain_;
    const CurveChain &chain_;
    const Curve &curve_;
    double tolerance_;
    std::vector<Box2> boxes_; ///< per segment of the chain
    double deviation_;        ///< maximum distance of an edge from the curve
};

/// Returns the constraint point of a domain at a place, which must have one.
DomainPart partAt(const Domain &domain, Vec2 place) {
    const auto found = std::find_if(domain.points.begin(), domain.points.end(),
                                    [&](const ConstraintPoint &point) { return domain.nodes[point.node] == place; });
    return {DomainPartKind::ConstraintPoint, static_cast<std::uint32_t>(found - domain.points.begin())};
}

/// Bounds the area between a straight segment and a chain of mesh edges between its ends: its length times the maximum
/// distance of the nodes. A distance c/|d|, with c a cross product of d and a vector no longer than d, errs by
/// 5u·2·|d| (see AreaSum), and d itself by less.
double areaBeside(const MeshView &mesh, const std::vector<NodeId> &nodes) {
    const Vec2 a = mesh.nodes[index(nodes.front())];
    const Vec2 d = mesh.nodes[index(nodes.back())] - a;
    const double span = length(d);
    double farthest = 0.0;
    for (const NodeId node : nodes) {
        farthest = std::max(farthest, std::abs(cross(d, mesh.nodes[index(node)] - a)));
    }
    return farthest + 6.0 * std::numeric_limits<double>::epsilon() * span * span;
}

/// Checks that the middle nodes of the edges between successive nodes lie on their segment, or on the curve that it
/// follows, or on the chord.
class MiddleCheck {
  public:
    MiddleCheck(const MeshView &mesh, double tolerance, FaultList &faults)
        : mesh_(mesh), tolerance_(tolerance), faults_(faults) {
        if (mesh.hasSecondOrder()) {
            table_.emplace(mesh);
        }
    }

    /// `curve`: null for a straight segment.
    void check(const std::vector<NodeId> &nodes, const CurveWalk *curve, const DiscreteSegment &segment) {
        for (std::size_t i = 0; table_ && i + 1 < nodes.size(); ++i) {
            const std::span<const HalfEdge> sides = table_->find(nodes[i], nodes[i + 1]);
            const NodeId middle = sides.empty() ? kNoNode : table_->halfEdges().middleOf(sides[0]);
            if (middle == kNoNode) {
                continue;
            }
            const Vec2 a = mesh_.nodes[index(nodes[i])], b = mesh_.nodes[index(nodes[i + 1])],
                       place = mesh_.nodes[index(middle)];
            if (distanceToSegment(a, b, place) > tolerance_ && (curve == nullptr || !curve->holds(place))) {
                faults_.add(
                    "middle-node",
                    "the middle node of an edge along a segment of the domain with tag " + std::to_string(segment.tag) +
                        (curve == nullptr ? " does not lie on the segment"
                                          : " lies neither on the segment's curve nor on the chord of the edge"),
                    place, {static_cast<std::uint32_t>(middle)}, {aSegment(segment.source)});
            }
        }
    }

  private:
    const MeshView &mesh_;
    double tolerance_;
    FaultList &faults_;
    std::optional<EdgeTable> table_;
};

/// The domain with its segments divided as the mesh divides them, and the area by which straight ones may differ.
struct CutDomain {
    DiscreteDomain domain;
    double areaBeside = 0.0;
};
CutDomain cutAsMeshed(const MeshView &mesh, const Domain &domain, const CurveChains &chains, SegmentElements elements,
                      const DiscreteDomain &given, double tolerance, bool innerTags, FaultList &faults) {
    CutDomain result;
    DiscreteDomain &cut = result.domain;
    cut.nodes.assign(mesh.nodes.begin(), mesh.nodes.end());
    cut.regions = given.regions;
    const NodeFinder finder(mesh, innerTags);
    const ChainEdges usual(mesh, !carriesNoTags(mesh));
    MiddleCheck middles(mesh, tolerance, faults);
    const Mesh none;
    const ChainEdges all(innerTags ? MeshView(none) : mesh, false);
    for (DiscreteSegment s : given.segments) {
        const ChainEdges &edges = innerTags || !isInner(s) ? usual : all;
        const std::uint32_t number = chains.ofSegment[s.source];
        const CurveChain *const curved = number == kNoIndex ? nullptr : &chains.list[number];
        if (curved != nullptr) {
            if (s.source != curved->segments.front()) {
                continue; // the chain is processed at its first segment
            }
            if (domain.segments[s.source].stretch.t1 < domain.segments[s.source].stretch.t0) {
                std::swap(s.leftRegion, s.rightRegion);
            }
            s.a = curved->start;
            s.b = curved->end;
        }
        const Vec2 a = given.nodes[s.a], b = given.nodes[s.b];
        const NodeId from = finder.find(a), to = finder.find(b);
        const std::string name = "a segment of the domain with tag " + std::to_string(s.tag);
        if (from == kNoNode || to == kNoNode) {
            faults.add("missing-node", "an end of " + name + " is not a boundary node of the mesh",
                       from == kNoNode ? a : b, {s.source}, {aSegment(s.source)});
            continue;
        }
        std::optional<CurveWalk> curve;
        if (curved != nullptr) {
            curve.emplace(domain, *curved, elements, tolerance);
        }
        const std::vector<NodeId> nodes =
            curve ? curve->nodes(mesh, edges, from, to) : chain(mesh, edges, from, to, tolerance);
        middles.check(nodes, curve ? &*curve : nullptr, s);
        if (nodes.empty()) {
            faults.add("missing-segment", name + " is not covered by edges of the mesh", midpoint(a, b), {s.source},
                       {aSegment(s.source)});
        } else if (curved == nullptr) {
            result.areaBeside += areaBeside(mesh, nodes);
        }
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
            DiscreteSegment piece = s;
            piece.a = static_cast<std::uint32_t>(nodes[i]);
            piece.b = static_cast<std::uint32_t>(nodes[i + 1]);
            cut.segments.push_back(piece);
        }
    }
    for (const ConstraintPoint &point : given.points) {
        const NodeId node = finder.find(given.nodes[point.node]);
        if (node == kNoNode) {
            faults.add("missing-point", "an inner point of the domain is not a node of the mesh",
                       given.nodes[point.node], {point.node}, {partAt(domain, given.nodes[point.node])});
        } else {
            cut.points.push_back({static_cast<std::uint32_t>(node), point.tag});
        }
    }
    return result;
}

/// Returns how far rounding may move a node inserted into a segment: a + t·(b - a) errs in x by u·(2·|b.x - a.x| + |x|)
/// at most, which is 5u times the largest |x|, and likewise in y; so by 5·√2·u = 3.6ε times the largest coordinate.
/// Other formulas, such as (1 - t)·a + t·b, err by as much.
double roundingOf(const Box2 &bounds) {
    const double maxCoordinate =
        std::max({std::abs(bounds.min.x), std::abs(bounds.min.y), std::abs(bounds.max.x), std::abs(bounds.max.y)});
    return 8.0 * std::numeric_limits<double>::epsilon() * maxCoordinate; // with a margin
}

/// Returns the deviations of a counter-clockwise mesh without faults from a domain.
Diagnostics deviations(const MeshView &mesh, const Domain &domain, std::size_t limit, const MeshNumbers &numbers,
                       bool innerTags, SegmentElements elements) {
    Diagnostics wrong = validate(domain, limit);
    if (hasErrors(wrong)) {
        return wrong;
    }
    SpacingSpec spec;
    spec.size = domain.bounds().diagonal();
    const auto spacing = SpacingField::build(spec, domain);
    if (!spacing) {
        return spacing.faults();
    }
    const Result<DiscreteDomain> given = discretise(domain, **spacing, true);
    if (!given) {
        return given.faults();
    }
    FaultList faults(limit);
    const CurveChains chains = curveChains(domain);
    const double tolerance = std::max(1e-9 * domain.bounds().diagonal(), roundingOf(domain.bounds()));
    CutDomain meshed = cutAsMeshed(mesh, domain, chains, elements, *given, tolerance, innerTags, faults);
    DiscreteDomain &cut = meshed.domain;
    if (!faults.clean()) {
        return faults.take();
    }
    const BoundedArea whole = enclosedArea(*given), is = meshArea(mesh);
    double allowed = is.error + whole.error + meshed.areaBeside;
    // Along curves, the edges of the mesh cut off other areas than the chords of the domain.
    for (const CurveChain &chain : chains.list) {
        allowed += CurveWalk(domain, chain, elements, 0.0).areaBetween();
    }
    if (!(std::abs(is.area - whole.area) <= allowed)) {
        faults.add("area",
                   "the area of the mesh is " + numberText(is.area, 15) + " instead of " + numberText(whole.area, 15),
                   mesh.bounds().centre());
    }
    // Areas of faces are those of the cut domain from here on; the sum was compared above.
    if (!cut.regions.empty()) {
        double rest = enclosedArea(cut).area;
        for (std::size_t i = 1; i < cut.regions.size(); ++i) {
            rest -= cut.regions[i].area;
        }
        cut.regions[0].area = rest;
    }
    checkAgainst(mesh, cut, faults, numbers, innerTags);
    return faults.take();
}

} // namespace

Diagnostics verifyAgainst(const MeshView &mesh, const Domain &domain, SegmentElements elements, std::size_t limit,
                          const MeshNumbers &numbers, bool innerTags, std::span<const std::int32_t> cracks) {
    return orOutOfMemory("to check the mesh", [&] {
        Diagnostics own = verify(mesh, limit, numbers);
        if (hasErrors(own)) {
            return own;
        }
        std::optional<Mesh> copy;
        const MeshView right = turnedRight(mesh, copy);
        Diagnostics found = cracks.empty() ? Diagnostics() : verifyCracks(right, cracks, numbers);
        if (found.empty()) {
            const Mesh whole = cracks.empty() ? Mesh() : closeCracks(right, cracks).mesh;
            found = deviations(cracks.empty() ? right : MeshView(whole), domain, limit, numbers, innerTags, elements);
        }
        found.insert(found.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
        return found;
    });
}

} // namespace forefront
