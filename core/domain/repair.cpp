#include "core/domain/coordinate_range.hpp"
#include "core/domain/domain_meetings.hpp"
#include "core/domain/node_welder.hpp"
#include "core/domain/validate.hpp"
#include "core/geometry/polygon.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>

namespace forefront {

namespace {

constexpr int kMaxRounds = 40;
constexpr std::size_t kMaxMeetings = 1'000'000; // in all rounds
constexpr std::size_t kMaxNotes = 1000;

std::string number(std::size_t value) {
    return std::to_string(value);
}

/// A segment while it is repaired: part of one or several domain segments.
struct Part {
    std::uint32_t a = 0, b = 0;
    std::uint32_t source = 0;     ///< the first domain segment it is part of
    std::uint32_t boundaries = 0; ///< number of boundary segments here; 0: constraints only
};

/// Parts and the nodes to cut them at.
using Cuts = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

class Repairer {
  public:
    explicit Repairer(const Domain &domain) : given_(domain), nodes_(domain.nodes), points_(domain.points) {}

    Result<Repaired> run() {
        const Box2 box = given_.bounds();
        if (!box.empty() && (tooLarge(box.min) || tooLarge(box.max) || tooSmall(box) || tooFarAway(box))) {
            return error("out-of-range",
                         "the coordinates are beyond 1e60, smaller than 1e-60, or too far from the origin",
                         "scale and move the domain first");
        }
        NodeWelder welder(nodes_, box);
        collectParts();
        std::size_t count = 0;
        for (int round = 0;; ++round) {
            mergeNodes(round == 0);
            dropEmptyParts();
            mergeParts();
            const DomainGraph graph = graphOf(assembled());
            const PlaneSweepResult sweep = sweepPlane(graph.points, graph.edges);
            const DomainMeetings meetings = findDomainMeetings(graph, sweep, kMaxMeetings);
            if (meetings.empty()) {
                break;
            }
            count += meetings.crossings.size() + meetings.touches.size() + meetings.overlaps.size();
            if (!meetings.complete || count > kMaxMeetings) {
                return error("too-many-faults",
                             "more than " + number(kMaxMeetings) + " places where segments meet; expected fewer",
                             "correct the source of the domain");
            }
            if (round == kMaxRounds) {
                return error("repair-failed",
                             "segments still meet after " + number(kMaxRounds) + " rounds of splitting",
                             "move apart the nodes that nearly coincide");
            }
            split(graph, meetings, welder);
        }
        resolveRepeats();
        dropFoldsOutside();
        return finish();
    }

  private:
    void note(const char *code, std::string message, std::optional<Vec2> at, std::initializer_list<DomainPart> parts) {
        if (++noteCount_ <= kMaxNotes) {
            Diagnostic change;
            change.severity = Severity::Note;
            change.code = code;
            change.message = std::move(message);
            change.at = at && isFinite(*at) ? at : std::nullopt;
            change.parts = parts;
            result_.changes.push_back(std::move(change));
        }
    }

    /// Sets aside segments whose indices or coordinates are invalid; they stay as they are.
    void collectParts() {
        for (std::uint32_t s = 0; s < given_.segments.size(); ++s) {
            const DomainSegment &segment = given_.segments[s];
            const bool inRange = segment.a < nodes_.size() && segment.b < nodes_.size();
            if (inRange && segment.a != segment.b && !(isFinite(nodes_[segment.a]) && isFinite(nodes_[segment.b]))) {
                aside_.push_back(s);
            } else if (!inRange) {
                aside_.push_back(s);
            } else {
                parts_.push_back({segment.a, segment.b, s, segment.role == SegmentRole::Boundary ? 1U : 0U});
            }
        }
    }

    Domain assembled() const {
        Domain domain;
        domain.nodes = nodes_;
        for (const Part &part : parts_) {
            const DomainSegment &source = given_.segments[part.source];
            domain.segments.push_back(
                {part.a, part.b, source.tag, part.boundaries > 0 ? SegmentRole::Boundary : SegmentRole::Constraint});
        }
        domain.points = points_;
        domain.insideRule = given_.insideRule;
        domain.holeMarkers = given_.holeMarkers;
        return domain;
    }

    /// Replaces nodes at the same place by the first of them.
    void mergeNodes(bool report) {
        std::vector<std::uint32_t> order;
        for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
            if (isFinite(nodes_[n])) {
                order.push_back(n);
            }
        }
        std::sort(order.begin(), order.end(), [&](std::uint32_t m, std::uint32_t n) {
            const Vec2 p = nodes_[m], q = nodes_[n];
            return p == q ? m < n : p.x != q.x ? p.x < q.x : p.y < q.y;
        });
        std::vector<std::uint32_t> kept(nodes_.size());
        std::iota(kept.begin(), kept.end(), 0U);
        for (std::size_t i = 1; i < order.size(); ++i) {
            if (nodes_[order[i]] == nodes_[order[i - 1]]) {
                kept[order[i]] = kept[order[i - 1]];
            }
        }
        for (std::uint32_t n = 0; n < nodes_.size() && report; ++n) {
            if (kept[n] != n) {
                note("duplicate-node", "merged two nodes with the same coordinates", nodes_[n],
                     {aNode(kept[n]), aNode(n)});
            }
        }
        for (Part &part : parts_) {
            part.a = kept[part.a];
            part.b = kept[part.b];
        }
        std::vector<std::uint8_t> listed(nodes_.size(), 0);
        std::erase_if(points_, [&](ConstraintPoint &point) {
            if (point.node >= nodes_.size()) {
                return false;
            }
            point.node = kept[point.node];
            return listed[point.node]++ != 0;
        });
        merged_ = std::move(kept);
    }

    void dropEmptyParts() {
        std::erase_if(parts_, [&](const Part &part) {
            const bool empty = part.a == part.b;
            const DomainSegment &source = given_.segments[part.source];
            if (empty && (source.a == source.b || given_.nodes[source.a] == given_.nodes[source.b])) {
                note("zero-length", "removed a segment of zero length", nodes_[part.a], {aSegment(part.source)});
            }
            return empty;
        });
    }

    /// Merges parts between the same nodes into one that counts its boundary segments.
    void mergeParts() {
        std::vector<std::size_t> order(parts_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto key = [&](std::size_t i) {
            return std::pair{std::min(parts_[i].a, parts_[i].b), std::max(parts_[i].a, parts_[i].b)};
        };
        std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
            return std::pair{key(i), i} < std::pair{key(j), j};
        });
        std::vector<std::uint8_t> gone(parts_.size(), 0);
        for (std::size_t i = 1, first = 0; i < order.size(); ++i) {
            if (key(order[i]) != key(order[first])) {
                first = i;
                continue;
            }
            Part &kept = parts_[order[first]];
            const Part &other = parts_[order[i]];
            if (kept.boundaries == 0 && other.boundaries > 0) { // the tag of the boundary wins
                kept.source = other.source;
            }
            kept.boundaries += other.boundaries;
            gone[order[i]] = 1;
            note("duplicate-segment", "kept the common part of two segments once",
                 midpoint(nodes_[kept.a], nodes_[kept.b]), {aSegment(kept.source), aSegment(other.source)});
        }
        std::size_t i = 0;
        std::erase_if(parts_, [&](const Part &) { return gone[i++] != 0; });
    }

    void split(const DomainGraph &graph, const DomainMeetings &meetings, NodeWelder &welder) {
        Cuts cuts;
        const auto node = [&](std::uint32_t point) { return graph.node[point]; };
        for (const DomainMeetings::Touch &touch : meetings.touches) {
            note("touching-segments", "split a segment at a node on it", graph.points[touch.point],
                 {aSegment(parts_[touch.edge].source)});
            cuts.emplace_back(touch.edge, node(touch.point));
        }
        for (const EdgeMeeting &overlap : meetings.overlaps) {
            for (const auto &[e, f] : {std::pair{overlap.first, overlap.second}, {overlap.second, overlap.first}}) {
                for (const std::uint32_t end : {parts_[e].a, parts_[e].b}) {
                    if (onSegment(nodes_[parts_[f].a], nodes_[parts_[f].b], nodes_[end])) {
                        cuts.emplace_back(f, end);
                    }
                }
            }
        }
        for (const EdgeMeeting &crossing : meetings.crossings) {
            if (splitNearEnds(crossing, welder, cuts)) {
                continue;
            }
            const Part &e = parts_[crossing.first], &f = parts_[crossing.second];
            const Vec2 at = crossingPoint(nodes_[e.a], nodes_[e.b], nodes_[f.a], nodes_[f.b]);
            note("crossing-segments", "split two segments where they cross", at,
                 {aSegment(e.source), aSegment(f.source)});
            const std::uint32_t place = welder.nodeAt(at, {e.a, e.b, f.a, f.b});
            cuts.emplace_back(crossing.first, place);
            cuts.emplace_back(crossing.second, place);
        }
        for (const auto &[from, into] : welder.welds()) {
            note("duplicate-node", "merged two nodes within rounding error of each other", nodes_[into],
                 {aNode(into), aNode(from)});
        }
        welder.move();
        cutParts(cuts);
    }

    /// Routes a crossing through an end of one part that almost touches the other. A new node beside that end would
    /// only create more such places, without end where segments nearly coincide.
    bool splitNearEnds(const EdgeMeeting &crossing, NodeWelder &welder, Cuts &cuts) {
        bool near = false;
        for (const auto &[p, q] :
             {std::pair{crossing.first, crossing.second}, std::pair{crossing.second, crossing.first}}) {
            const Part &other = parts_[q];
            for (const std::uint32_t end : {parts_[p].a, parts_[p].b}) {
                if (distanceToSegment(nodes_[other.a], nodes_[other.b], nodes_[end]) > welder.tolerance()) {
                    continue;
                }
                near = true;
                if (!welder.weld(end, other.a) && !welder.weld(end, other.b)) {
                    note("touching-segments", "split a segment at a node within rounding error of it", nodes_[end],
                         {aSegment(other.source)});
                    cuts.emplace_back(q, end);
                }
            }
        }
        return near;
    }

    void cutParts(Cuts &cuts) {
        std::sort(cuts.begin(), cuts.end());
        cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
        std::vector<Part> pieces;
        std::size_t next = 0;
        for (std::uint32_t p = 0; p < parts_.size(); ++p) {
            const Part &part = parts_[p];
            const Vec2 a = nodes_[part.a], along = nodes_[part.b] - a;
            std::vector<std::pair<double, std::uint32_t>> stations;
            for (; next < cuts.size() && cuts[next].first == p; ++next) {
                const std::uint32_t node = cuts[next].second;
                if (node != part.a && node != part.b) {
                    stations.emplace_back(dot(nodes_[node] - a, along), node);
                }
            }
            std::sort(stations.begin(), stations.end());
            std::uint32_t from = part.a;
            for (const auto &station : stations) {
                pieces.push_back({from, station.second, part.source, part.boundaries});
                from = station.second;
            }
            pieces.push_back({from, part.b, part.source, part.boundaries});
        }
        parts_ = std::move(pieces);
    }

    /// Decides the role of several coinciding boundary segments. If the boundary is closed with each kept once, a loop
    /// or segment was given twice. If it is closed only when all count, an even number of them does not separate inside
    /// from outside: neighbours share that boundary, and it stays as a constraint.
    void resolveRepeats() {
        if (given_.insideRule != InsideRule::EvenOdd) {
            return;
        }
        std::vector<std::uint8_t> oddOnce(nodes_.size(), 0), oddCounted(nodes_.size(), 0);
        for (const Part &part : parts_) {
            for (const std::uint32_t end : {part.a, part.b}) {
                oddOnce[end] ^= part.boundaries > 0 ? 1 : 0;
                oddCounted[end] ^= part.boundaries % 2;
            }
        }
        // Connected runs of parts with even counts are treated alike.
        std::vector<std::uint32_t> root(nodes_.size());
        std::iota(root.begin(), root.end(), 0U);
        const auto rootOf = [&](std::uint32_t n) {
            while (root[n] != n) {
                n = root[n] = root[root[n]];
            }
            return n;
        };
        const auto repeated = [](const Part &part) { return part.boundaries > 0 && part.boundaries % 2 == 0; };
        for (const Part &part : parts_) {
            if (repeated(part)) {
                root[rootOf(part.a)] = rootOf(part.b);
            }
        }
        std::vector<std::uint8_t> brokenOnce(nodes_.size(), 0), brokenCounted(nodes_.size(), 0);
        for (const Part &part : parts_) {
            for (const std::uint32_t end : {part.a, part.b}) {
                brokenOnce[rootOf(end)] |= oddOnce[end];
                brokenCounted[rootOf(end)] |= oddCounted[end];
            }
        }
        for (Part &part : parts_) {
            const std::uint32_t run = rootOf(part.a);
            if (repeated(part) && brokenOnce[run] != 0 && brokenCounted[run] == 0) {
                part.boundaries = 0;
                folded_.push_back({part.a, part.b});
                note("overlapping-segments", "turned the boundary shared by neighbours into a constraint",
                     midpoint(nodes_[part.a], nodes_[part.b]), {aSegment(part.source)});
            }
        }
    }

    /// Drops boundaries that are folded onto themselves outside the domain and bound nothing.
    void dropFoldsOutside() {
        if (folded_.empty()) {
            return;
        }
        const Domain domain = assembled();
        const DomainGraph graph = graphOf(domain);
        const PlaneSweepResult sweep = sweepPlane(graph.points, graph.edges);
        std::vector<std::uint8_t> odd(nodes_.size(), 0);
        for (const Part &part : parts_) {
            odd[part.a] ^= part.boundaries > 0 ? 1 : 0;
            odd[part.b] ^= part.boundaries > 0 ? 1 : 0;
        }
        if (std::find(odd.begin(), odd.end(), 1) != odd.end()) {
            return; // not closed: inside is undefined
        }
        const Faces faces = findFaces(graph.points, graph.edges, sweep);
        const FaceLabels labels = labelFaces(domain, graph, faces);
        std::sort(folded_.begin(), folded_.end());
        std::size_t edge = 0;
        std::erase_if(parts_, [&](const Part &part) {
            const std::size_t e = edge++;
            const bool outside = std::binary_search(folded_.begin(), folded_.end(), std::pair{part.a, part.b}) &&
                                 labels.inside[faces.left[e]] == 0 && labels.inside[faces.right[e]] == 0;
            if (outside) {
                note("segment-outside", "removed a folded segment outside the domain",
                     midpoint(nodes_[part.a], nodes_[part.b]), {aSegment(part.source)});
            }
            return outside;
        });
    }

    /// Assembles the result without unreferenced nodes.
    Repaired finish() {
        std::vector<std::uint8_t> used(nodes_.size(), 0);
        for (const Part &part : parts_) {
            used[part.a] = used[part.b] = 1;
        }
        const auto use = [&](std::uint32_t node) {
            if (node < used.size()) {
                used[node] = 1;
            }
        };
        for (const ConstraintPoint &point : points_) {
            use(point.node);
        }
        for (const std::uint32_t s : aside_) {
            use(given_.segments[s].a);
            use(given_.segments[s].b);
        }
        Domain &domain = result_.domain = given_;
        domain.nodes.clear();
        domain.segments.clear();
        std::vector<std::uint32_t> renumbered(nodes_.size(), kNoIndex);
        for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
            if (used[n] != 0 || !isFinite(nodes_[n])) {
                renumbered[n] = static_cast<std::uint32_t>(domain.nodes.size());
                domain.nodes.push_back(nodes_[n]);
            } else if (n < given_.nodes.size() && merged_[n] == n) {
                note("unreferenced-node", "removed an unreferenced node", nodes_[n], {aNode(n)});
            }
        }
        const auto renumber = [&](std::uint32_t node) { return node < nodes_.size() ? renumbered[node] : kNoIndex; };
        for (const Part &part : parts_) {
            const DomainSegment &source = given_.segments[part.source];
            domain.segments.push_back({renumbered[part.a], renumbered[part.b], source.tag,
                                       part.boundaries > 0 ? SegmentRole::Boundary : SegmentRole::Constraint});
        }
        for (const std::uint32_t s : aside_) {
            DomainSegment segment = given_.segments[s];
            segment.a = renumber(segment.a);
            segment.b = renumber(segment.b);
            domain.segments.push_back(segment);
        }
        domain.points = points_;
        for (ConstraintPoint &point : domain.points) {
            point.node = renumber(point.node);
        }
        if (noteCount_ > kMaxNotes) {
            Diagnostic rest;
            rest.severity = Severity::Note;
            rest.code = "more-changes";
            rest.message = number(noteCount_ - kMaxNotes) + " more changes are not listed";
            result_.changes.push_back(std::move(rest));
        }
        return std::move(result_);
    }

    const Domain &given_;
    std::vector<Vec2> nodes_; // the given nodes, then those of crossings
    std::vector<ConstraintPoint> points_;
    std::vector<Part> parts_;
    std::vector<std::uint32_t> aside_;
    std::vector<std::uint32_t> merged_; // per node: the node it was merged into in the last round
    std::vector<std::pair<std::uint32_t, std::uint32_t>> folded_;
    std::size_t noteCount_ = 0;
    Repaired result_;
};

} // namespace

Result<Repaired> repair(const Domain &domain) {
    return Repairer(domain).run();
}

bool repairable(const Diagnostic &fault) {
    static constexpr std::array<std::string_view, 7> kCodes{
        "zero-length",       "unreferenced-node", "duplicate-node",      "duplicate-segment",
        "crossing-segments", "touching-segments", "overlapping-segments"};
    return std::find(kCodes.begin(), kCodes.end(), fault.code) != kCodes.end();
}

bool anyRepairable(const Diagnostics &faults) {
    return std::any_of(faults.begin(), faults.end(), repairable);
}

} // namespace forefront
