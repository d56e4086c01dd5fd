#include "core/drawing/domain/divide_at_joints.hpp"

#include "core/engine/domain/element_shares.hpp"
#include "core/engine/geometry/box_tree.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

namespace forefront {
namespace {

constexpr double kExact = 1e-10;  ///< distance that rounding causes, in diagonals of the domain
constexpr double kOnCurve = 1e-9; ///< distance within which a mesh follows a curve from node to node, likewise

/// A node inside a segment.
struct JointPlace {
    std::uint32_t segment = 0, node = 0;
    double t = 0.0;     ///< parameter of the curve, or along the straight segment from 0 to 1
    double along = 0.0; ///< the same from 0 at the segment's start to 1 at its end
};

class JointDivision {
  public:
    JointDivision(const Domain &domain, std::span<const JointNode> nodes, std::span<const std::uint32_t> shapes,
                  const SegmentElements &elements, const std::vector<bool> &whole, double tolerance)
        : domain_(domain), nodes_(nodes), shapes_(shapes), elements_(elements), whole_(whole),
          diagonal_(domain.bounds().diagonal()), tolerance_(tolerance) {}

    DividedSegments run() {
        find();
        DividedSegments result = divisions_.empty() ? DividedSegments{} : divide();
        result.farthest = farthest_;
        result.beside = std::move(beside_);
        return result;
    }

  private:
    const CurveStretch &stretch(std::uint32_t segment) const { return domain_.segments[segment].stretch; }
    Vec2 start(std::uint32_t segment) const { return domain_.nodes[domain_.segments[segment].a]; }
    Vec2 end(std::uint32_t segment) const { return domain_.nodes[domain_.segments[segment].b]; }

    /// Returns a box that holds a segment and its curve.
    Box2 boxOf(std::uint32_t segment) const {
        Box2 box{start(segment), start(segment)};
        box.add(end(segment));
        const CurveStretch &part = stretch(segment);
        return box.grown(part.follows() ? domain_.curves[part.curve].deviation(part.t0, part.t1) : 0.0);
    }

    void find() {
        std::vector<Box2> places, boxes;
        places.reserve(nodes_.size());
        for (const JointNode &joint : nodes_) {
            places.push_back({domain_.nodes[joint.node], domain_.nodes[joint.node]});
        }
        boxes.reserve(domain_.segments.size());
        for (std::uint32_t s = 0; s < domain_.segments.size(); ++s) {
            boxes.push_back(boxOf(s));
        }
        BoxTree(boxes).join(BoxTree(places), tolerance_, [this](std::uint32_t segment, std::uint32_t joint) {
            if (shapes_[segment] != nodes_[joint].shape && !whole_[segment]) {
                test(segment, nodes_[joint].node);
            }
            return true;
        });
        std::sort(divisions_.begin(), divisions_.end(), [](const JointPlace &a, const JointPlace &b) {
            return std::tuple(a.segment, a.along, a.node) < std::tuple(b.segment, b.along, b.node);
        });
    }

    /// Notes a node if it lies inside a segment.
    void test(std::uint32_t segment, std::uint32_t node) {
        const Vec2 a = start(segment), b = end(segment), p = domain_.nodes[node];
        const double rounding = kExact * diagonal_;
        if (!(distance(p, a) > rounding) || !(distance(p, b) > rounding)) {
            return;
        }
        const CurveStretch &part = stretch(segment);
        const Curve curve = part.follows() ? domain_.curves[part.curve] : Curve::line(a, b);
        const double t0 = part.follows() ? part.t0 : 0.0, t1 = part.follows() ? part.t1 : 1.0;
        const double t = curve.nearest(p, t0, t1);
        const double away = distance(curve.point(t), p);
        if (!(away <= tolerance_)) {
            return;
        }
        if (part.follows() && away > std::min(tolerance_, kOnCurve * diagonal_)) {
            const auto isNode = [&](const NodeBesideCurve &other) { return other.node == node; };
            if (t > 0.0 && t < 1.0 && std::none_of(beside_.begin(), beside_.end(), isNode)) {
                beside_.push_back({segment, node, away});
            }
            return;
        }
        if (t == t0 || t == t1) {
            return;
        }
        divisions_.push_back({segment, node, t, (t - t0) / (t1 - t0)});
        farthest_ = std::max(farthest_, away);
    }

    DividedSegments divide() const {
        DividedSegments result;
        auto next = divisions_.cbegin();
        for (std::uint32_t s = 0; s < domain_.segments.size(); ++s) {
            const auto first = next;
            next = std::find_if(next, divisions_.cend(),
                                [s](const JointPlace &division) { return division.segment != s; });
            addParts(s, {first, next}, result);
        }
        return result;
    }

    void addParts(std::uint32_t s, std::span<const JointPlace> at, DividedSegments &result) const {
        std::vector<JointPlace> divisions = apart(at);
        std::vector<ElementShare> shares = sharesOf(s, divisions);
        if (shares.size() > elementsOf(s) ||
            std::any_of(shares.begin(), shares.end(), [](const ElementShare &share) { return !share.keepsBias; })) {
            divisions.clear();
            shares.clear();
        }
        DomainSegment rest = domain_.segments[s];
        const auto add = [&](const DomainSegment &part, std::size_t k) {
            result.segments.push_back(part);
            result.given.push_back(s);
            result.elements.push_back(shares.empty() ? 0 : shares[k].elements);
            result.biases.push_back(shares.empty() ? ElementBias{} : shares[k].bias);
        };
        for (std::size_t k = 0; k < divisions.size(); ++k) {
            DomainSegment part = rest;
            part.b = rest.a = divisions[k].node;
            if (rest.stretch.follows()) {
                part.stretch.t1 = rest.stretch.t0 = divisions[k].t;
            }
            add(part, k);
        }
        add(rest, divisions.size());
    }

    /// Returns the divisions of a segment without those at the place of another.
    std::vector<JointPlace> apart(std::span<const JointPlace> at) const {
        const double rounding = kExact * diagonal_;
        std::vector<JointPlace> kept;
        for (const JointPlace &division : at) {
            const bool first =
                kept.empty() || distance(domain_.nodes[kept.back().node], domain_.nodes[division.node]) > rounding;
            if (first) {
                kept.push_back(division);
            }
        }
        return kept;
    }

    /// Returns the elements along the parts of a segment with a number of them; none if it stays whole.
    std::vector<ElementShare> sharesOf(std::uint32_t s, const std::vector<JointPlace> &divisions) const {
        const std::uint32_t whole = elementsOf(s);
        if (whole == 0 || divisions.empty()) {
            return {};
        }
        std::vector<double> ends;
        for (const JointPlace &division : divisions) {
            ends.push_back(division.along);
        }
        ends.push_back(1.0);
        return shareElements(whole, elements_.bias(s), ends);
    }

    /// Returns the number of elements to share among the parts of a segment; those of a curve share by themselves.
    std::uint32_t elementsOf(std::uint32_t s) const { return stretch(s).follows() ? 0 : elements_[s]; }

    const Domain &domain_;
    std::span<const JointNode> nodes_;
    std::span<const std::uint32_t> shapes_;
    SegmentElements elements_;
    const std::vector<bool> &whole_;
    double diagonal_, tolerance_;
    std::vector<JointPlace> divisions_;
    std::vector<NodeBesideCurve> beside_;
    double farthest_ = 0.0;
};

} // namespace

DividedSegments divideAtJoints(const Domain &domain, std::span<const JointNode> nodes,
                               std::span<const std::uint32_t> shapes, const SegmentElements &elements,
                               const std::vector<bool> &whole, double tolerance) {
    return JointDivision(domain, nodes, shapes, elements, whole, tolerance).run();
}

} // namespace forefront
