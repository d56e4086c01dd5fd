#include "core/drawing/arrangement/curves/snap_report.hpp"
#include "core/drawing/arrangement/repair/repairer.hpp"
#include "core/drawing/arrangement/snapping/stretch_part.hpp"

namespace forefront {

/// Assembles the repaired domain.
void Repairer::build() {
    mapNodes();
    number_.assign(joined_.nodes.size(), kNoIndex);
    ownNumber_.assign(given_.nodes.size(), kNoIndex);
    Domain &domain = result_.domain;
    domain = given_;
    domain.nodes.clear();
    domain.segments.clear();
    domain.points.clear();
    domain.holeMarkers.clear();
    addNodes();
    addSegments();
    for (std::size_t i = 0; i < given_.points.size(); ++i) {
        if (pointDropped_[i] == 0) {
            domain.points.push_back({renumbered(given_.points[i].node), given_.points[i].tag});
            result_.pointSource.push_back(static_cast<std::uint32_t>(i));
        }
    }
    for (std::size_t i = 0; i < given_.holeMarkers.size(); ++i) {
        if (markerDropped_[i] == 0) {
            domain.holeMarkers.push_back(given_.holeMarkers[i]);
            result_.holeMarkerSource.push_back(static_cast<std::uint32_t>(i));
        }
    }
    result_.nodeSource.assign(domain.nodes.size(), kNoIndex);
    result_.nodeResult.assign(given_.nodes.size(), kNoIndex);
    for (auto n = static_cast<std::uint32_t>(given_.nodes.size()); n-- > 0;) {
        if (const std::uint32_t number = renumbered(n); number != kNoIndex) {
            result_.nodeSource[number] = n;
            result_.nodeResult[n] = number;
        }
    }
    locateChanges();
}

/// Finds the joined node that each given node became.
void Repairer::mapNodes() {
    joinedNode_.assign(given_.nodes.size(), kNoIndex);
    for (std::uint32_t i = 0; i < segmentOf_.size(); ++i) {
        const DomainSegment &segment = given_.segments[segmentOf_[i]];
        if (i == 0 || segmentOf_[i] != segmentOf_[i - 1]) {
            joinedNode_[segment.a] = joined_.first[i];
        }
        if (i + 1 == segmentOf_.size() || segmentOf_[i] != segmentOf_[i + 1]) {
            joinedNode_[segment.b] = lastNode(joined_, i);
        }
    }
    for (std::size_t i = 0; i < pointOf_.size(); ++i) {
        joinedNode_[given_.points[pointOf_[i]].node] = joined_.first[segmentOf_.size() + i];
    }
}

/// Adds the nodes that stay, in the given order. Nodes with invalid numbers and those of invalid segments stay too, so
/// that validation can report them.
void Repairer::addNodes() {
    std::vector<std::uint8_t> used(joined_.nodes.size(), 0), needed(given_.nodes.size(), 0);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        if (!edges_[e].dropped) {
            used[joined_.edges[e].a] = used[joined_.edges[e].b] = 1;
        }
    }
    for (std::size_t i = 0; i < pointOf_.size(); ++i) {
        if (pointDropped_[pointOf_[i]] == 0) {
            used[joined_.first[segmentOf_.size() + i]] = 1;
        }
    }
    for (const DomainSegment &segment : given_.segments) {
        for (const std::uint32_t end : {segment.a, segment.b}) {
            if (!valid(segment) && end < needed.size()) {
                needed[end] = 1;
            }
        }
    }
    std::vector<std::uint32_t> firstAt(joined_.nodes.size(), kNoIndex);
    for (std::uint32_t n = 0; n < given_.nodes.size(); ++n) {
        const Vec2 place = given_.nodes[n];
        const std::uint32_t node = joinedNode_[n];
        if (node != kNoIndex && (used[node] != 0 || needed[n] != 0)) {
            if (firstAt[node] != kNoIndex && given_.nodes[firstAt[node]] == place) {
                changes_.add(ChangeKind::RepeatedNodes, place, 0.0, n);
            }
            firstAt[node] = firstAt[node] == kNoIndex ? n : firstAt[node];
            static_cast<void>(nodeNumber(node));
        } else if (node == kNoIndex && (needed[n] != 0 || !isFinite(place))) {
            ownNumber_[n] = static_cast<std::uint32_t>(result_.domain.nodes.size());
            result_.domain.nodes.push_back(place);
        } else if (node == kNoIndex) {
            changes_.add(ChangeKind::UnusedNodes, place, 0.0, n);
        }
    }
}

/// Returns the index in the result of a joined node, and adds it if it is new.
std::uint32_t Repairer::nodeNumber(std::uint32_t joinedNode) {
    std::uint32_t &number = number_[joinedNode];
    if (number == kNoIndex) {
        number = static_cast<std::uint32_t>(result_.domain.nodes.size());
        result_.domain.nodes.push_back(joined_.nodes[joinedNode]);
    }
    return number;
}

/// Returns the index in the result of a given node; kNoIndex if the given index is invalid.
std::uint32_t Repairer::renumbered(std::uint32_t node) const {
    if (node >= given_.nodes.size()) {
        return kNoIndex;
    }
    return joinedNode_[node] != kNoIndex ? number_[joinedNode_[node]] : ownNumber_[node];
}

/// Adds the joined edges in the order of the given segments, then the invalid segments.
void Repairer::addSegments() {
    Domain &domain = result_.domain;
    std::vector<std::uint8_t> added(edges_.size(), 0);
    for (std::uint32_t i = 0; i < segmentOf_.size(); ++i) {
        for (std::uint32_t k = joined_.starts[i]; k < joined_.starts[i + 1]; ++k) {
            const std::uint32_t e = joined_.ways[k] / 2;
            if (edges_[e].dropped || added[e] != 0) {
                continue;
            }
            added[e] = 1;
            const bool back = joined_.ways[k] % 2 != 0;
            DomainSegment segment = given_.segments[edges_[e].source];
            segment.a = nodeNumber(back ? joined_.edges[e].b : joined_.edges[e].a);
            segment.b = nodeNumber(back ? joined_.edges[e].a : joined_.edges[e].b);
            segment.role = edges_[e].boundaries > 0 ? SegmentRole::Boundary : SegmentRole::Constraint;
            const std::uint32_t line = edges_[e].line; // the part of the source segment
            segment.stretch = stretchAlong(lines_.stretches[line], given_.curves, lines_.lines[line],
                                           domain.nodes[segment.a], domain.nodes[segment.b]);
            domain.segments.push_back(segment);
            result_.segmentSource.push_back(edges_[e].source);
        }
    }
    for (std::uint32_t s = 0; s < given_.segments.size(); ++s) {
        if (!valid(given_.segments[s])) {
            DomainSegment segment = given_.segments[s];
            segment.a = renumbered(segment.a);
            segment.b = renumbered(segment.b);
            domain.segments.push_back(segment);
            result_.segmentSource.push_back(s);
        }
    }
}

/// Names the part of the given domain at the first place of each change.
void Repairer::locateChanges() {
    result_.changes = changes_.take();
    for (ArrangementChange &change : result_.changes) {
        switch (change.kind) {
        case ChangeKind::RepeatedNodes:
        case ChangeKind::UnusedNodes:
            change.part = aNode(change.piece);
            break;
        case ChangeKind::OutsidePoints:
            change.part = DomainPart{DomainPartKind::ConstraintPoint, change.piece};
            break;
        case ChangeKind::OutsideMarkers:
        case ChangeKind::HolesBeyond:
            change.part = DomainPart{DomainPartKind::HoleMarker, change.piece};
            break;
        case ChangeKind::WeldedNodes:
        case ChangeKind::ShortPieces:
        case ChangeKind::CrossingSegments:
        case ChangeKind::TouchingSegments:
        case ChangeKind::BentSegments:
            change.part = partOfLine(change.piece);
            break;
        default:
            change.part = aSegment(change.piece);
        }
    }
}

DomainPart Repairer::partOfLine(std::uint32_t line) const {
    if (line < segmentOf_.size()) {
        return aSegment(segmentOf_[line]);
    }
    return {DomainPartKind::ConstraintPoint, pointOf_[line - segmentOf_.size()]};
}

} // namespace forefront
