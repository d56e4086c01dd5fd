#include "core/arrangement/repairer.hpp"

#include <algorithm>
#include <numeric>

namespace forefront {

/// Returns the joined lines as a domain, edge by edge; nodes and edges have the same indices.
Domain Repairer::joinedDomain() const {
    Domain domain;
    domain.nodes = joined_.nodes;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        const SegmentRole role = edges_[e].boundaries > 0 ? SegmentRole::Boundary : SegmentRole::Constraint;
        domain.segments.push_back({joined_.edges[e].a, joined_.edges[e].b, 1, role});
    }
    for (std::size_t i = 0; i < pointOf_.size(); ++i) {
        domain.points.push_back({joined_.first[segmentOf_.size() + i], 1});
    }
    domain.insideRule = given_.insideRule;
    domain.holeMarkers = given_.holeMarkers;
    return domain;
}

/// Drops what lies outside the domain. A boundary that is open or has invalid segments does not say what is outside, so
/// then everything stays.
void Repairer::dropOutside() {
    pointDropped_.assign(given_.points.size(), 0);
    markerDropped_.assign(given_.holeMarkers.size(), 0);
    const Domain joined = joinedDomain();
    const DomainGraph graph = graphOf(joined);
    const Faces faces = findFaces(graph.points, graph.edges, sweepPlane(graph.points, graph.edges));
    const FaceLabels labels = labelFaces(joined, graph, faces);
    const bool anyInside = std::any_of(labels.inside.begin(), labels.inside.end(), [](auto in) { return in != 0; });
    const bool allValid = std::all_of(given_.segments.begin(), given_.segments.end(),
                                      [&](const DomainSegment &segment) { return valid(segment); });
    const bool drops = allValid && anyInside && closed(joined, faces, labels);
    const std::vector<std::uint8_t> outside = outsideEdges(joined, faces, labels);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
        if (drops && outside[e] != 0) {
            dropEdge(e);
        } else if (edges_[e].shared) {
            changes_.add(ChangeKind::SharedBoundaries,
                         midpoint(joined_.nodes[joined_.edges[e].a], joined_.nodes[joined_.edges[e].b]), 0.0,
                         edges_[e].source);
        }
    }
    if (drops) {
        dropPoints(graph, faces, labels);
        dropHoleMarkers(graph, faces);
    }
}

/// Returns, per edge, true if it can be dropped: both sides are outside. With HoleMarkers an outline with a gap cannot
/// be told from a line outside, so there what is not connected to the domain stays, and validation reports it.
std::vector<std::uint8_t> Repairer::outsideEdges(const Domain &joined, const Faces &faces,
                                                 const FaceLabels &labels) const {
    std::vector<std::uint8_t> outside(edges_.size(), 0);
    std::vector<std::uint32_t> root(joined.nodes.size());
    std::iota(root.begin(), root.end(), 0U);
    const auto rootOf = [&](std::uint32_t node) {
        while (root[node] != node) {
            node = root[node] = root[root[node]];
        }
        return node;
    };
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        outside[e] = labels.inside[faces.left[e]] == 0 && labels.inside[faces.right[e]] == 0 ? 1 : 0;
        root[rootOf(joined.segments[e].a)] = rootOf(joined.segments[e].b);
    }
    if (given_.insideRule == InsideRule::HoleMarkers) {
        std::vector<std::uint8_t> connected(joined.nodes.size(), 0);
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            if (outside[e] == 0) {
                connected[rootOf(joined.segments[e].a)] = 1;
            }
        }
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            outside[e] = outside[e] != 0 && connected[rootOf(joined.segments[e].a)] != 0 ? 1 : 0;
        }
    }
    return outside;
}

/// Returns true if the boundary has no open ends: with EvenOdd, an even number of its segments meets at every node;
/// with HoleMarkers, none of its segments that bound nothing ends freely.
bool Repairer::closed(const Domain &joined, const Faces &faces, const FaceLabels &labels) const {
    std::vector<std::uint32_t> degree(joined.nodes.size(), 0);
    std::vector<std::uint8_t> boundsNothing(joined.nodes.size(), 0);
    const bool evenOdd = given_.insideRule == InsideRule::EvenOdd;
    for (std::size_t e = 0; e < joined.segments.size(); ++e) {
        const DomainSegment &segment = joined.segments[e];
        const bool boundary = segment.role == SegmentRole::Boundary;
        const bool outside = labels.inside[faces.left[e]] == 0 && labels.inside[faces.right[e]] == 0;
        for (const std::uint32_t end : {segment.a, segment.b}) {
            degree[end] += boundary || !evenOdd ? 1 : 0;
            if (boundary && outside) {
                boundsNothing[end] = 1;
            }
        }
    }
    for (std::size_t n = 0; n < degree.size(); ++n) {
        if (evenOdd ? degree[n] % 2 != 0 : degree[n] == 1 && boundsNothing[n] != 0) {
            return false;
        }
    }
    return true;
}

void Repairer::dropEdge(std::uint32_t edge) {
    edges_[edge].dropped = true;
    const bool folded =
        given_.insideRule == InsideRule::EvenOdd && given_.segments[edges_[edge].source].role == SegmentRole::Boundary;
    changes_.add(folded ? ChangeKind::FoldedOutlines : ChangeKind::OutsideLines,
                 midpoint(joined_.nodes[joined_.edges[edge].a], joined_.nodes[joined_.edges[edge].b]), 0.0,
                 edges_[edge].source);
}

void Repairer::dropPoints(const DomainGraph &graph, const Faces &faces, const FaceLabels &labels) {
    std::vector<std::uint8_t> side(joined_.nodes.size(), 0); // 1: has edges, 2: has edges that stay
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        for (const std::uint32_t end : {joined_.edges[e].a, joined_.edges[e].b}) {
            side[end] = std::max<std::uint8_t>(side[end], edges_[e].dropped ? 1 : 2);
        }
    }
    for (std::size_t i = 0; i < pointOf_.size(); ++i) {
        const std::uint32_t node = joined_.first[segmentOf_.size() + i];
        const std::uint32_t face = side[node] == 0 ? faces.ofPoint[graph.pointOfNode[node]] : kNoIndex;
        const bool outside = face == kNoIndex ? side[node] == 1 : labels.inside[face] == 0;
        if (outside) {
            pointDropped_[pointOf_[i]] = 1;
            changes_.add(ChangeKind::OutsidePoints, joined_.nodes[node], 0.0, pointOf_[i]);
        }
    }
}

/// Drops the markers of holes that are part of the unbounded face now that some edges are gone.
void Repairer::dropHoleMarkers(const DomainGraph &graph, const Faces &faces) {
    std::vector<std::uint32_t> root(faces.count);
    std::iota(root.begin(), root.end(), 0U);
    const auto rootOf = [&](std::uint32_t face) {
        while (root[face] != face) {
            face = root[face] = root[root[face]];
        }
        return face;
    };
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        if (edges_[e].dropped) {
            const std::uint32_t left = rootOf(faces.left[e]), right = rootOf(faces.right[e]);
            root[std::max(left, right)] = std::min(left, right);
        }
    }
    for (std::uint32_t i = 0; i < given_.holeMarkers.size(); ++i) {
        const std::uint32_t point = graph.holeMarker[i];
        const std::uint32_t face = point != kNoIndex ? faces.ofPoint[point] : kNoIndex;
        if (face != kNoIndex && face != 0 && rootOf(face) == 0) {
            markerDropped_[i] = 1;
            changes_.add(ChangeKind::OutsideMarkers, given_.holeMarkers[i], 0.0, i);
        }
    }
}

} // namespace forefront
