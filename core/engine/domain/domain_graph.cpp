#include "core/engine/domain/domain_graph.hpp"

#include "core/engine/base/rows.hpp"

#include <algorithm>

namespace forefront {

namespace {

/// Adds a marker to the points and returns its index, or kNoIndex if it is not finite.
std::uint32_t addMarker(DomainGraph &graph, Vec2 at) {
    if (!isFinite(at)) {
        return kNoIndex;
    }
    graph.points.push_back(at);
    return static_cast<std::uint32_t>(graph.points.size() - 1);
}

/// Returns, per face, the parity of the boundary segments crossed on a way from the unbounded face.
std::vector<std::uint8_t> crossedOddly(const Domain &domain, const DomainGraph &graph, const Faces &faces) {
    const Rows<std::uint32_t> around(faces.count, [&](const auto &add) {
        for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
            add(faces.left[e], e);
            add(faces.right[e], e);
        }
    });
    std::vector<std::uint8_t> odd(faces.count, 0), known(faces.count, 0);
    std::vector<std::uint32_t> queue{0};
    known[0] = 1;
    for (std::size_t head = 0; head < queue.size(); ++head) {
        const std::uint32_t face = queue[head];
        for (const std::uint32_t e : around[face]) {
            const std::uint32_t other = faces.left[e] == face ? faces.right[e] : faces.left[e];
            if (known[other] == 0) {
                known[other] = 1;
                const bool flips = domain.segments[graph.segment[e]].role == SegmentRole::Boundary;
                odd[other] = flips ? 1 - odd[face] : odd[face];
                queue.push_back(other);
            }
        }
    }
    return odd;
}

} // namespace

DomainGraph graphOf(const Domain &domain, std::span<const Vec2> places) {
    DomainGraph graph;
    const std::size_t nodeCount = domain.nodes.size();
    std::vector<std::uint8_t> used(nodeCount, 0);
    for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
        const DomainSegment &segment = domain.segments[s];
        if (segment.a >= nodeCount || segment.b >= nodeCount) {
            continue;
        }
        const Vec2 a = domain.nodes[segment.a], b = domain.nodes[segment.b];
        if (isFinite(a) && isFinite(b) && a != b) {
            used[segment.a] = used[segment.b] = 1;
            graph.segment.push_back(s);
        }
    }
    for (const ConstraintPoint &point : domain.points) {
        if (point.node < nodeCount && isFinite(domain.nodes[point.node])) {
            used[point.node] = 1;
        }
    }
    graph.pointOfNode.assign(nodeCount, kNoIndex);
    for (std::uint32_t n = 0; n < nodeCount; ++n) {
        if (used[n] != 0) {
            graph.pointOfNode[n] = static_cast<std::uint32_t>(graph.points.size());
            graph.points.push_back(domain.nodes[n]);
            graph.node.push_back(n);
        }
    }
    graph.edges.reserve(graph.segment.size());
    for (const std::uint32_t s : graph.segment) {
        graph.edges.push_back({graph.pointOfNode[domain.segments[s].a], graph.pointOfNode[domain.segments[s].b]});
    }
    for (const Vec2 at : domain.holeMarkers) {
        graph.holeMarker.push_back(addMarker(graph, at));
    }
    for (const RegionMarker &marker : domain.regionMarkers) {
        graph.regionMarker.push_back(addMarker(graph, marker.at));
    }
    for (std::size_t k = 0; k < places.size(); ++k) {
        const std::uint32_t marker = regionMarkerAt(domain, places[k], k);
        graph.place.push_back(marker != kNoIndex ? graph.regionMarker[marker] : addMarker(graph, places[k]));
    }
    return graph;
}

std::uint32_t regionMarkerAt(const Domain &domain, Vec2 place, std::size_t guess) {
    const std::vector<RegionMarker> &markers = domain.regionMarkers;
    if (guess < markers.size() && markers[guess].at == place) {
        return static_cast<std::uint32_t>(guess);
    }
    const auto found = std::ranges::find(markers, place, &RegionMarker::at);
    return found != markers.end() ? static_cast<std::uint32_t>(found - markers.begin()) : kNoIndex;
}

FaceLabels labelFaces(const Domain &domain, const DomainGraph &graph, const Faces &faces) {
    FaceLabels labels;
    if (domain.insideRule == InsideRule::EvenOdd) {
        labels.inside = crossedOddly(domain, graph, faces);
    } else {
        labels.inside.assign(faces.count, 1);
        labels.inside[0] = 0;
        for (const std::uint32_t point : graph.holeMarker) {
            if (point != kNoIndex && faces.ofPoint[point] != kNoIndex) {
                labels.inside[faces.ofPoint[point]] = 0;
            }
        }
    }
    labels.tag.assign(faces.count, 1);
    labels.marker.assign(faces.count, kNoIndex);
    for (std::uint32_t m = 0; m < graph.regionMarker.size(); ++m) {
        const std::uint32_t point = graph.regionMarker[m];
        const std::uint32_t face = point != kNoIndex ? faces.ofPoint[point] : kNoIndex;
        if (face != kNoIndex && labels.marker[face] == kNoIndex) {
            labels.marker[face] = m;
            labels.tag[face] = domain.regionMarkers[m].tag;
        }
    }
    return labels;
}

} // namespace forefront
