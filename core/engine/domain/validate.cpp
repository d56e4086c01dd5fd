#include "core/engine/domain/validate.hpp"

#include "core/engine/base/key_order.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/base/out_of_memory.hpp"
#include "core/engine/domain/domain_fault_list.hpp"
#include "core/engine/domain/domain_meetings.hpp"
#include "core/engine/domain/free_ends.hpp"
#include "core/engine/domain/part_checks.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

namespace forefront {

namespace {

/// Maximum number of meetings to search for, so that the unlisted ones can be counted.
constexpr std::size_t kMaxPairs = 100'000;

/// Maximum width of a gap for which the advice is to weld it, as a fraction of the domain's diagonal. Where the ends
/// are farther apart, something is missing.
constexpr double kWeldableGap = 0.01;

class Validator {
  public:
    Validator(const Domain &domain, std::size_t limit)
        : domain_(domain), weldable_(kWeldableGap * domain.bounds().diagonal()), faults_(limit) {}

    /// `found` receives the faces if the domain is valid.
    Diagnostics run(DomainFaces &found) {
        const bool complete = checkParts(domain_, faults_);
        found.graph = graphOf(domain_);
        const DomainGraph &graph = found.graph;
        if (graph.edges.empty()) {
            add("empty-domain", "the domain has no valid boundary segment", "draw or import a closed boundary");
            return faults_.take();
        }
        found.sweep = sweepPlane(graph.points, graph.edges);
        const PlaneSweepResult &sweep = found.sweep;
        checkDuplicateNodes(graph, sweep);
        checkMeetings(graph, sweep);
        checkChains(graph, sweep);
        // Inside and outside are defined only if the segments are simple and closed.
        if (sweep.droppedCount == 0 && complete && !open_) {
            found.faces = findFaces(graph.points, graph.edges, sweep);
            found.labels = labelFaces(domain_, graph, found.faces);
            checkFaces(found);
        }
        return faults_.take();
    }

  private:
    void add(const char *code, std::string message, std::string advice, std::optional<Vec2> at = {},
             std::initializer_list<DomainPart> parts = {}) {
        faults_.add(code, std::move(message), std::move(advice), at, parts);
    }

    void checkDuplicateNodes(const DomainGraph &graph, const PlaneSweepResult &sweep) {
        for (std::uint32_t point = 0; point < graph.node.size(); ++point) {
            const std::uint32_t first = sweep.canonical[point];
            if (first != point) {
                add("duplicate-node", "two nodes have the same coordinates", "merge them, or repair the domain",
                    graph.points[point], {aNode(graph.node[first]), aNode(graph.node[point])});
            }
        }
    }

    void checkMeetings(const DomainGraph &graph, const PlaneSweepResult &sweep) {
        const DomainMeetings meetings = findDomainMeetings(graph, sweep, std::max(faults_.limit(), kMaxPairs));
        if (!meetings.complete) {
            faults_.setIncomplete();
        }
        const auto a = [&](std::uint32_t edge) { return graph.points[graph.edges[edge].a]; };
        const auto b = [&](std::uint32_t edge) { return graph.points[graph.edges[edge].b]; };
        const auto part = [&](std::uint32_t edge) { return aSegment(graph.segment[edge]); };
        for (const auto &[first, second] : meetings.duplicates) {
            add("duplicate-segment", "two segments join the same nodes", "remove one of them, or repair the domain",
                midpoint(a(first), b(first)), {part(first), part(second)});
        }
        for (const EdgeMeeting &m : meetings.crossings) {
            add("crossing-segments", "two segments cross",
                "move a node, or repair the domain to split both where they cross",
                crossingPoint(a(m.first), b(m.first), a(m.second), b(m.second)), {part(m.first), part(m.second)});
        }
        for (const DomainMeetings::Touch &touch : meetings.touches) {
            add("touching-segments", "a node lies on a segment",
                "move the node, or repair the domain to split the segment there", graph.points[touch.point],
                {aNode(graph.node[touch.point]), part(touch.edge)});
        }
        for (const EdgeMeeting &m : meetings.overlaps) {
            std::array<Vec2, 4> p{a(m.first), b(m.first), a(m.second), b(m.second)};
            std::sort(p.begin(), p.end(), comesBefore);
            add("overlapping-segments", "two segments overlap",
                "remove one of them, or repair the domain, which keeps one copy of the common part",
                midpoint(p[1], p[2]), {part(m.first), part(m.second)});
        }
    }

    /// With EvenOdd, an even number of boundary segments must meet at every node. Segments with one valid end count
    /// there; repeated segments and nodes at the same place count once, since they are reported as separate faults.
    void checkChains(const DomainGraph &graph, const PlaneSweepResult &sweep) {
        if (domain_.insideRule != InsideRule::EvenOdd) {
            return;
        }
        const auto place = [&](std::uint32_t node) {
            const std::uint32_t point = graph.pointOfNode[node];
            return point == kNoIndex ? node : graph.node[sweep.canonical[point]];
        };
        std::vector<std::uint64_t> spans;
        for (const DomainSegment &segment : domain_.segments) {
            const bool validA = segment.a < domain_.nodes.size(), validB = segment.b < domain_.nodes.size();
            if (segment.role == SegmentRole::Boundary && (validA || validB)) {
                const std::uint32_t a = validA ? place(segment.a) : kNoIndex, b = validB ? place(segment.b) : kNoIndex;
                if (a != b) {
                    spans.push_back(pairKey(std::min(a, b), std::max(a, b)));
                }
            }
        }
        std::vector<std::uint32_t> degree(domain_.nodes.size(), 0);
        std::uint64_t last = pairKey(kNoIndex, kNoIndex);
        for (const std::uint32_t i : orderByKeys(spans)) {
            if (spans[i] == std::exchange(last, spans[i])) {
                continue;
            }
            const auto [a, b] = pairOf(spans[i]);
            ++degree[a];
            if (b != kNoIndex) {
                ++degree[b];
            }
        }
        std::vector<std::uint32_t> ends;
        for (std::uint32_t n = 0; n < degree.size(); ++n) {
            if (degree[n] == 1) {
                ends.push_back(n);
            } else if (degree[n] % 2 != 0) {
                open_ = true;
                add("open-chain",
                    std::to_string(degree[n]) + " boundary segments meet at a node; expected an even number",
                    "close the loop, or turn boundary segments that bound nothing into inner lines", domain_.nodes[n],
                    {aNode(n)});
            }
        }
        open_ = open_ || !ends.empty();
        addOpenEnds(ends);
    }

    /// Reports nodes at which the boundary ends, each with the distance to the nearest other end.
    void addOpenEnds(const std::vector<std::uint32_t> &nodes) {
        std::vector<Vec2> places;
        places.reserve(nodes.size());
        for (const std::uint32_t n : nodes) {
            places.push_back(domain_.nodes[n]);
        }
        const FreeEnds ends(std::move(places));
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            if (faults_.full()) { // only counted, so the gaps do not matter
                faults_.addUnlisted(nodes.size() - k);
                return;
            }
            const double gap = ends.gap(k);
            add("open-chain", "the boundary ends at a node" + gapText(gap) + "; expected a closed loop",
                "close the loop" + weldAdvice(gap) + ", or turn boundary segments that bound nothing into inner lines",
                domain_.nodes[nodes[k]], {aNode(nodes[k])});
        }
    }

    static std::string gapText(double gap) {
        return std::isfinite(gap) ? ", " + numberText(gap, 3) + " from the nearest other end" : std::string();
    }

    /// Returns advice to weld a narrow gap, with a tolerance that is certainly sufficient; empty for wide gaps.
    std::string weldAdvice(double gap) const {
        if (!(gap <= weldable_)) {
            return {};
        }
        return ", repair the domain" + (gap > 0.0 ? " with a weld tolerance of " + numberText(1.1 * gap, 2) : "");
    }

    void checkFaces(const DomainFaces &found) {
        const auto &[graph, sweep, faces, labels] = found;
        if (std::none_of(labels.inside.begin(), labels.inside.end(), [](std::uint8_t inside) { return inside != 0; })) {
            if (!checkOpenEnds(graph, sweep, faces, labels)) { // those already explain it
                addEmpty(graph, sweep);
            }
            return;
        }
        const bool anyOpen = checkOpenEnds(graph, sweep, faces, labels);
        for (std::uint32_t e = 0; e < graph.edges.size() && !anyOpen; ++e) {
            if (labels.inside[faces.left[e]] == 0 && labels.inside[faces.right[e]] == 0) {
                add("segment-outside", "a segment lies outside the domain",
                    "remove it, extend the boundary around it, or repair the domain",
                    midpoint(graph.points[graph.edges[e].a], graph.points[graph.edges[e].b]),
                    {aSegment(graph.segment[e])});
            }
        }
        checkPointPlaces(graph, sweep, faces, labels);
        checkMarkerPlaces(graph, faces, labels);
    }

    void addEmpty(const DomainGraph &graph, const PlaneSweepResult &sweep) {
        if (std::any_of(domain_.segments.begin(), domain_.segments.end(),
                        [](const DomainSegment &segment) { return segment.role == SegmentRole::Boundary; })) {
            add("empty-domain", "nothing is inside the boundary",
                "draw a closed boundary, and keep hole markers out of the faces to mesh",
                graph.points[graph.edges[0].a]);
            return;
        }
        std::vector<std::uint32_t> degree(graph.points.size(), 0);
        for (const auto &edge : graph.edges) {
            ++degree[sweep.canonical[edge.a]];
            ++degree[sweep.canonical[edge.b]];
        }
        std::vector<std::uint32_t> edges; // per free end
        std::vector<Vec2> places;
        for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
            for (const std::uint32_t end : {graph.edges[e].b, graph.edges[e].a}) {
                if (degree[sweep.canonical[end]] == 1) {
                    edges.push_back(e);
                    places.push_back(graph.points[end]);
                }
            }
        }
        const bool anyFree = !places.empty();
        const Vec2 place = anyFree ? places.front() : graph.points[graph.edges[0].a];
        const double gap = anyFree ? FreeEnds(std::move(places)).gap(0) : std::numeric_limits<double>::infinity();
        add("empty-domain",
            "the domain has only inner lines and no boundary" +
                (anyFree ? "; a line ends" + gapText(gap) : std::string()),
            "draw a closed outline" + weldAdvice(gap) + ", or turn a closed line into a boundary", place,
            {aSegment(graph.segment[anyFree ? edges.front() : 0])});
    }

    /// Reports free ends of boundary segments that bound nothing, where the rule allows free ends inside.
    bool checkOpenEnds(const DomainGraph &graph, const PlaneSweepResult &sweep, const Faces &faces,
                       const FaceLabels &labels) {
        if (domain_.insideRule == InsideRule::EvenOdd) {
            return false;
        }
        std::vector<std::uint32_t> degree(graph.points.size(), 0), last(graph.points.size(), 0);
        for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
            for (const std::uint32_t end : {graph.edges[e].a, graph.edges[e].b}) {
                ++degree[sweep.canonical[end]];
                last[sweep.canonical[end]] = e;
            }
        }
        std::vector<std::uint32_t> ends;
        for (std::uint32_t point = 0; point < graph.node.size(); ++point) {
            const std::uint32_t e = last[point];
            if (degree[point] == 1 && domain_.segments[graph.segment[e]].role == SegmentRole::Boundary &&
                labels.inside[faces.left[e]] == 0 && labels.inside[faces.right[e]] == 0) {
                ends.push_back(graph.node[point]);
            }
        }
        addOpenEnds(ends);
        return !ends.empty();
    }

    void checkPointPlaces(const DomainGraph &graph, const PlaneSweepResult &sweep, const Faces &faces,
                          const FaceLabels &labels) {
        for (std::uint32_t i = 0; i < domain_.points.size(); ++i) {
            const std::uint32_t node = domain_.points[i].node;
            const std::uint32_t point = node < domain_.nodes.size() ? graph.pointOfNode[node] : kNoIndex;
            if (point == kNoIndex || sweep.on[sweep.canonical[point]] != kNoIndex) {
                continue; // reported already
            }
            const std::uint32_t face = faces.ofPoint[point];
            if (face != kNoIndex && labels.inside[face] == 0) {
                add("point-outside", "an inner point lies outside the domain",
                    "move it, remove it, or repair the domain", graph.points[point], {aNode(node)});
            }
        }
    }

    void checkMarkerPlaces(const DomainGraph &graph, const Faces &faces, const FaceLabels &labels) {
        for (std::uint32_t i = 0; i < graph.holeMarker.size() && domain_.insideRule == InsideRule::HoleMarkers; ++i) {
            const std::uint32_t point = graph.holeMarker[i];
            const std::uint32_t face = point != kNoIndex ? faces.ofPoint[point] : kNoIndex;
            if (point != kNoIndex && (face == kNoIndex || face == 0)) {
                add("hole-outside",
                    face == 0 ? "a hole marker lies outside every closed loop" : "a hole marker lies on a segment",
                    "move it into the hole, or remove it", domain_.holeMarkers[i], {{DomainPartKind::HoleMarker, i}});
            }
        }
        for (std::uint32_t i = 0; i < graph.regionMarker.size(); ++i) {
            const std::uint32_t point = graph.regionMarker[i];
            if (point == kNoIndex) {
                continue;
            }
            const std::uint32_t face = faces.ofPoint[point];
            if (face == kNoIndex || labels.inside[face] == 0) {
                add("region-marker-outside",
                    face == kNoIndex ? "a region marker lies on a segment" : "a region marker lies outside the domain",
                    "move it into its region, or remove it", domain_.regionMarkers[i].at,
                    {{DomainPartKind::RegionMarker, i}});
            } else if (const std::uint32_t first = labels.marker[face];
                       domain_.regionMarkers[first].tag != domain_.regionMarkers[i].tag) {
                add("region-marker-conflict", "two region markers give the same region different tags",
                    "remove one of them, or divide the region by an inner line", domain_.regionMarkers[i].at,
                    {{DomainPartKind::RegionMarker, first}, {DomainPartKind::RegionMarker, i}});
            }
        }
    }

    const Domain &domain_;
    double weldable_; ///< maximum gap for which the advice is to weld it
    DomainFaultList faults_;
    bool open_ = false; // a loop is not closed
};

} // namespace

Diagnostics validate(const Domain &domain, std::size_t limit, DomainFaces *faces) {
    return orOutOfMemory("to check the domain", [&] {
        DomainFaces own;
        return Validator(domain, limit).run(faces != nullptr ? *faces : own);
    });
}

} // namespace forefront
