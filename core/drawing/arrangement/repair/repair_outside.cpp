#include "core/drawing/arrangement/repair/repairer.hpp"

#include <algorithm>
#include <numeric>

namespace forefront {

namespace {

/// The connected parts of the segments of a domain.
class OpenLines {
  public:
    explicit OpenLines(const Domain &domain) : root_(domain.nodes.size()), parts_(domain.nodes.size()) {
        std::iota(root_.begin(), root_.end(), 0U);
        std::vector<std::uint32_t> degree(domain.nodes.size(), 0);
        for (const DomainSegment &segment : domain.segments) {
            root_[rootOf(segment.a)] = rootOf(segment.b);
            ++degree[segment.a];
            ++degree[segment.b];
        }
        for (std::uint32_t node = 0; node < root_.size(); ++node) {
            root_[node] = rootOf(node);
        }
        for (const DomainSegment &segment : domain.segments) {
            parts_[root_[segment.a]].length += distance(domain.nodes[segment.a], domain.nodes[segment.b]);
        }
        for (std::uint32_t node = 0; node < root_.size(); ++node) {
            Part &part = parts_[root_[node]];
            part.branches = part.branches || degree[node] > 2;
            if (degree[node] == 1) {
                (part.ends == 0 ? part.first : part.last) = domain.nodes[node];
                ++part.ends;
            }
        }
    }

    /// Returns true if the part with this node is a line whose ends are nearer to each other than half its length: it
    /// may be meant as an outline.
    bool nearlyCloses(std::uint32_t node) const {
        const Part &part = parts_[root_[node]];
        return part.ends == 2 && !part.branches && distance(part.first, part.last) < 0.5 * part.length;
    }

  private:
    struct Part {
        double length = 0.0;
        std::uint32_t ends = 0;
        Vec2 first, last;
        bool branches = false;
    };

    std::uint32_t rootOf(std::uint32_t node) {
        while (root_[node] != node) {
            node = root_[node] = root_[root_[node]];
        }
        return node;
    }

    std::vector<std::uint32_t> root_; ///< per node
    std::vector<Part> parts_;         ///< by root
};

} // namespace

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

/// Drops all parts outside the domain. If the boundary is open or has invalid segments, the outside is not defined, and
/// no part is dropped.
void Repairer::dropOutside(const std::stop_token &stop) {
    pointDropped_.assign(given_.points.size(), 0);
    markerDropped_.assign(given_.holeMarkers.size(), 0);
    const Domain joined = joinedDomain();
    const DomainGraph graph = graphOf(joined);
    const PlaneSweepResult sweep = sweepPlane(graph.points, graph.edges, stop);
    if (stop.stop_requested()) {
        return;
    }
    const Faces faces = findFaces(graph.points, graph.edges, sweep);
    FaceLabels labels = labelFaces(joined, graph, faces);
    const bool anyInside = std::any_of(labels.inside.begin(), labels.inside.end(), [](auto in) { return in != 0; });
    const auto opened = openHoles(graph, faces, labels);
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
        for (const auto &[place, marker] : opened) {
            changes_.add(ChangeKind::HolesBeyond, place, 0.0, marker);
        }
        dropPoints(graph, faces, labels);
        dropHoleMarkers(graph, faces);
    }
}

/// Returns, per edge, true if it can be dropped: both sides are outside. With HoleMarkers an outline with a gap is a
/// line outside, too; there a line that nearly closes stays, and validation reports it.
std::vector<std::uint8_t> Repairer::outsideEdges(const Domain &joined, const Faces &faces,
                                                 const FaceLabels &labels) const {
    std::vector<std::uint8_t> outside(edges_.size(), 0);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        outside[e] = labels.inside[faces.left[e]] == 0 && labels.inside[faces.right[e]] == 0 ? 1 : 0;
    }
    if (given_.insideRule == InsideRule::HoleMarkers) {
        const OpenLines lines(joined);
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            outside[e] = outside[e] != 0 && !lines.nearlyCloses(joined.segments[e].a) ? 1 : 0;
        }
    }
    return outside;
}

/// Returns true if the boundary has no open ends: with EvenOdd, an even number of its segments meet at every node; with
/// HoleMarkers, no boundary segment with the outside on both sides has a free end.
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
