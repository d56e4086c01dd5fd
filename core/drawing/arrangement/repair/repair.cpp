#include "core/drawing/arrangement/repair/repair.hpp"

#include "core/drawing/arrangement/curves/snap_report.hpp"
#include "core/drawing/arrangement/repair/repairer.hpp"
#include "core/engine/base/out_of_memory.hpp"
#include "core/engine/domain/coordinate_range.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>
#include <utility>

namespace forefront {

namespace {

/// Returns true if the lines meet only at common ends and pass no point.
bool meetOnlyInEnds(const SnappedLines &lines, const std::stop_token &stop) {
    const PlaneSweepResult sweep = sweepPlane(lines.nodes, lines.edges, stop);
    return sweep.droppedCount == 0 &&
           std::all_of(sweep.on.begin(), sweep.on.end(), [](std::uint32_t edge) { return edge == kNoIndex; });
}

Diagnostics cancelledRepair() {
    return error("cancelled", "the repair was cancelled");
}

} // namespace

Result<Repaired> Repairer::run(double tolerance, const std::stop_token &stop) {
    const Box2 box = given_.bounds();
    if (!box.empty() && (tooLarge(box.min) || tooLarge(box.max) || tooSmall(box) || tooFarAway(box))) {
        return error("out-of-range", "the coordinates are too large, too small, or too far from the origin",
                     "scale and move the domain first");
    }
    collectLines();
    takeLines(join(tolerance, stop));
    if (!joined_.finished) {
        return cancelledRepair();
    }
    collectEdges();
    const PlaneSweepResult sweep = sweepPlane(joined_.nodes, joined_.edges, stop);
    if (sweep.droppedCount != 0 && !stop.stop_requested()) {
        return error("repair-failed", "segments still cross or touch after joining",
                     "please report this file as a bug");
    }
    resolveRepeats();
    dropOutside(stop);
    if (stop.stop_requested()) {
        return cancelledRepair();
    }
    build();
    return std::move(result_);
}

bool Repairer::valid(const DomainSegment &segment) const {
    return segment.a < given_.nodes.size() && segment.b < given_.nodes.size() && isFinite(given_.nodes[segment.a]) &&
           isFinite(given_.nodes[segment.b]);
}

void Repairer::collectLines() {
    for (std::uint32_t s = 0; s < given_.segments.size(); ++s) {
        const DomainSegment &segment = given_.segments[s];
        if (!valid(segment)) {
            continue;
        }
        const Vec2 a = given_.nodes[segment.a], b = given_.nodes[segment.b];
        if (a == b) {
            changes_.add(ChangeKind::EmptySegments, a, 0.0, s);
            continue;
        }
        lines_.lines.push_back({a, b});
        lines_.stretches.push_back(segment.stretch);
        segmentOf_.push_back(s);
    }
    for (std::uint32_t i = 0; i < given_.points.size(); ++i) {
        const std::uint32_t node = given_.points[i].node;
        if (node < given_.nodes.size() && isFinite(given_.nodes[node])) {
            lines_.lines.push_back({given_.nodes[node], given_.nodes[node]});
            lines_.stretches.emplace_back();
            pointOf_.push_back(i);
        }
    }
}

/// Joins the collected lines. If the tolerance is 0 and they meet only at common ends, they are left unchanged.
JoinedLines Repairer::join(double tolerance, const std::stop_token &stop) const {
    Box2 box;
    for (const SnapLine &line : lines_.lines) {
        box.add(line.a);
        box.add(line.b);
    }
    const double resolution = resolutionOf(box);
    if (tolerance == 0.0) {
        JoinedLines kept = lines_;
        kept.source.resize(kept.lines.size());
        std::iota(kept.source.begin(), kept.source.end(), 0U);
        kept.snapped = unsnapped(kept.lines);
        if (keepsNodes(kept, resolution, stop)) {
            return kept;
        }
    }
    return joinLines(lines_.lines, lines_.stretches, given_.curves, std::max(tolerance, resolution), stop);
}

/// Returns true if lines as given, and the curves that they follow, meet only at common ends.
bool Repairer::keepsNodes(const JoinedLines &kept, double resolution, const std::stop_token &stop) const {
    LineDivision division(kept.lines, kept.stretches, given_.curves, resolution);
    division.divide(stop);
    return division.meetings().empty() && meetOnlyInEnds(kept.snapped, stop);
}

/// Stores the joined lines and finds the segment or point that each is part of.
void Repairer::takeLines(JoinedLines lines) {
    lines_ = std::move(lines);
    const std::vector<std::uint32_t> segments = std::exchange(segmentOf_, {});
    for (const std::uint32_t given : lines_.source) {
        if (given < segments.size()) {
            segmentOf_.push_back(segments[given]);
        }
    }
    result_.radius = joined_.radius;
    noteJoining(lines_, changes_);
}

/// Finds the given segments along each joined edge.
void Repairer::collectEdges() {
    edges_.assign(joined_.edges.size(), {});
    for (std::uint32_t i = 0; i < segmentOf_.size(); ++i) {
        const bool boundary = given_.segments[segmentOf_[i]].role == SegmentRole::Boundary;
        for (std::uint32_t k = joined_.starts[i]; k < joined_.starts[i + 1]; ++k) {
            const PlaneEdge &ends = joined_.edges[joined_.ways[k] / 2];
            Edge &edge = edges_[joined_.ways[k] / 2];
            if (edge.source != kNoIndex) {
                changes_.add(ChangeKind::RepeatedSegments, midpoint(joined_.nodes[ends.a], joined_.nodes[ends.b]), 0.0,
                             segmentOf_[i]);
            }
            if (edge.source == kNoIndex || (boundary && edge.boundaries == 0)) {
                edge.source = segmentOf_[i];
                edge.line = i;
            }
            edge.boundaries += boundary ? 1 : 0;
        }
    }
}

/// Decides the role of boundary segments that coincide an even number of times. If the boundary is closed when each is
/// kept once, a loop or segment was given twice. If it is closed only when all of them count, they do not separate
/// inside from outside: neighbours share that boundary. Connected runs of such segments are treated alike.
void Repairer::resolveRepeats() {
    if (given_.insideRule != InsideRule::EvenOdd) {
        return;
    }
    const std::size_t nodeCount = joined_.nodes.size();
    std::vector<std::uint32_t> root(nodeCount);
    std::iota(root.begin(), root.end(), 0U);
    const auto rootOf = [&](std::uint32_t n) {
        while (root[n] != n) {
            n = root[n] = root[root[n]];
        }
        return n;
    };
    const auto repeated = [](const Edge &edge) { return edge.boundaries > 0 && edge.boundaries % 2 == 0; };
    std::vector<std::uint8_t> oddOnce(nodeCount, 0), oddCounted(nodeCount, 0);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        const PlaneEdge &ends = joined_.edges[e];
        for (const std::uint32_t end : {ends.a, ends.b}) {
            oddOnce[end] = (oddOnce[end] != 0) != (edges_[e].boundaries > 0);
            oddCounted[end] = (oddCounted[end] != 0) != (edges_[e].boundaries % 2 != 0);
        }
        if (repeated(edges_[e])) {
            root[rootOf(ends.a)] = rootOf(ends.b);
        }
    }
    std::vector<std::uint8_t> brokenOnce(nodeCount, 0), brokenCounted(nodeCount, 0);
    for (std::uint32_t n = 0; n < nodeCount; ++n) {
        brokenOnce[rootOf(n)] = std::max(brokenOnce[rootOf(n)], oddOnce[n]);
        brokenCounted[rootOf(n)] = std::max(brokenCounted[rootOf(n)], oddCounted[n]);
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        const std::uint32_t run = rootOf(joined_.edges[e].a);
        if (repeated(edges_[e]) && brokenOnce[run] != 0 && brokenCounted[run] == 0) {
            edges_[e].boundaries = 0;
            edges_[e].shared = true;
        }
    }
}

Result<Repaired> repair(const Domain &domain, double tolerance, std::stop_token stop) {
    return orOutOfMemory("to repair the domain", [&] { return Repairer(domain).run(tolerance, stop); });
}

bool repairable(const Diagnostic &fault) {
    static constexpr std::array<std::string_view, 9> kCodes{
        "zero-length",       "unreferenced-node",    "duplicate-node",  "duplicate-segment", "crossing-segments",
        "touching-segments", "overlapping-segments", "segment-outside", "point-outside"};
    return std::find(kCodes.begin(), kCodes.end(), fault.code) != kCodes.end();
}

bool anyRepairable(const Diagnostics &faults) {
    return std::any_of(faults.begin(), faults.end(), repairable);
}

} // namespace forefront
