#include "core/drawing/picking/face_map.hpp"

#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "core/engine/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Faulty domains with more segments are not repaired for a map, which must follow the pointer.
constexpr std::size_t kMaxRepaired = 20000;

/// Returns the height of a segment at x, between its ends.
double heightOf(const MappedEdge &edge, double x) {
    const bool forward = edge.a.x < edge.b.x;
    const Vec2 from = forward ? edge.a : edge.b, to = forward ? edge.b : edge.a;
    return from.y + (to.y - from.y) * ((x - from.x) / (to.x - from.x));
}

double slopeOf(const MappedEdge &edge) {
    return (edge.b.y - edge.a.y) / (edge.b.x - edge.a.x);
}

/// An edge with a face at its left.
struct DirectedEdge {
    Vec2 from, to;
    bool used = false;
};

/// Returns the edge that goes on along the face; where loops touch, the one that turns right most, so that a hole stays
/// apart from the outline that it touches. `edges` are in the order of their starts.
DirectedEdge *followingEdge(std::vector<DirectedEdge> &edges, const DirectedEdge &edge) {
    const auto before = [](const DirectedEdge &other, Vec2 p) { return comesBefore(other.from, p); };
    DirectedEdge *best = nullptr;
    double bestTurn = 0.0;
    for (auto k = std::lower_bound(edges.begin(), edges.end(), edge.to, before); k != edges.end() && k->from == edge.to;
         ++k) {
        const Vec2 in = edge.to - edge.from, out = k->to - k->from;
        const double turn = std::atan2(cross(in, out), dot(in, out));
        if (best == nullptr || turn < bestTurn) {
            best = &*k;
            bestTurn = turn;
        }
    }
    return best;
}

} // namespace

FaceMap::FaceMap(std::shared_ptr<const Domain> domain, const DomainFaces &faces) : domain_(std::move(domain)) {
    std::vector<std::uint32_t> numbers(faces.faces.count, kNoIndex);
    for (std::uint32_t face = 0; face < faces.faces.count; ++face) {
        if (faces.labels.inside[face] != 0) {
            numbers[face] = static_cast<std::uint32_t>(faces_.size());
            faces_.push_back({0.0, {}, faces.labels.tag[face], faces.labels.marker[face]});
        }
    }
    for (const std::uint32_t point : faces.graph.regionMarker) {
        const std::uint32_t face = point == kNoIndex ? kNoIndex : faces.faces.ofPoint[point];
        ofMarker_.push_back(face == kNoIndex ? kNoIndex : numbers[face]);
    }
    addEdges(faces, numbers);
    listEdges();
    measure();
    std::vector<Box2> boxes;
    boxes.reserve(edges_.size());
    for (const MappedEdge &edge : edges_) {
        boxes.push_back(boxOf(edge.a, edge.b));
    }
    tree_ = BoxTree(boxes);
}

void FaceMap::addEdges(const DomainFaces &found, std::span<const std::uint32_t> numbers) {
    for (std::size_t e = 0; e < found.graph.edges.size(); ++e) {
        const DomainSegment &segment = domain_->segments[found.graph.segment[e]];
        MappedEdge edge{domain_->nodes[segment.a], domain_->nodes[segment.b], segment.stretch,
                        numbers[found.faces.left[e]], numbers[found.faces.right[e]]};
        if (edge.left == edge.right) {
            continue;
        }
        if (const Curve *const curve = curveOf(edge)) {
            edge.deviation = curve->deviation(std::min(edge.stretch.t0, edge.stretch.t1),
                                              std::max(edge.stretch.t0, edge.stretch.t1));
        }
        edge.segment = found.graph.segment[e];
        edges_.push_back(edge);
    }
}

/// Lists the edges around each face.
void FaceMap::listEdges() {
    starts_.assign(faces_.size() + 1, 0);
    for (const MappedEdge &edge : edges_) {
        for (const std::uint32_t side : {edge.left, edge.right}) {
            if (side != kNoIndex) {
                ++starts_[side + 1];
            }
        }
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    around_.resize(starts_.back());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
        for (const std::uint32_t side : {edges_[e].left, edges_[e].right}) {
            if (side != kNoIndex) {
                around_[next[side]++] = e;
            }
        }
    }
}

std::span<const std::uint32_t> FaceMap::edgesOf(std::uint32_t face) const {
    return std::span(around_).subspan(starts_[face], starts_[face + 1] - starts_[face]);
}

std::vector<Vec2> FaceMap::outlineOf(std::uint32_t face) const {
    std::vector<DirectedEdge> edges;
    for (const std::uint32_t e : edgesOf(face)) {
        const MappedEdge &edge = edges_[e];
        edges.push_back(edge.left == face ? DirectedEdge{edge.a, edge.b} : DirectedEdge{edge.b, edge.a});
    }
    std::sort(edges.begin(), edges.end(),
              [](const DirectedEdge &p, const DirectedEdge &q) { return comesBefore(p.from, q.from); });
    std::vector<Vec2> outer;
    double area = 0.0; // holes run clockwise
    for (DirectedEdge &first : edges) {
        std::vector<Vec2> loop;
        for (DirectedEdge *edge = &first; edge != nullptr && !edge->used; edge = followingEdge(edges, *edge)) {
            edge->used = true;
            loop.push_back(edge->from);
        }
        if (const double covered = loop.empty() ? 0.0 : signedArea(loop); covered > area) {
            area = covered;
            outer = std::move(loop);
        }
    }
    return outer;
}

/// Computes the areas and boxes of the faces.
void FaceMap::measure() {
    const Vec2 origin = domain_->bounds().centre(); // for accuracy far from the origin
    for (const MappedEdge &edge : edges_) {
        const Curve *const curve = curveOf(edge);
        const double area = curve != nullptr ? sectorArea(curve->part(edge.stretch.t0, edge.stretch.t1), origin)
                                             : 0.5 * cross(edge.a - origin, edge.b - origin);
        for (const std::uint32_t side : {edge.left, edge.right}) {
            if (side != kNoIndex) {
                faces_[side].area += side == edge.left ? area : -area;
                faces_[side].box.add(boxOf(edge.a, edge.b));
            }
        }
    }
}

std::uint32_t FaceMap::faceOf(const Document &document, std::uint32_t index) const {
    const Vec2 at = document.regionMarkers[index].at;
    const bool known = index < ofMarker_.size() && domain_->regionMarkers[index].at == at;
    return known ? ofMarker_[index] : faceAt(at);
}

/// Follows a ray from p upwards to the first edge.
std::uint32_t FaceMap::faceAt(Vec2 p) const {
    const MappedEdge *first = nullptr;
    double height = std::numeric_limits<double>::infinity();
    const auto meets = [&](const Box2 &box) {
        return box.min.x <= p.x && p.x <= box.max.x && box.max.y >= p.y && box.min.y <= height;
    };
    tree_.search(meets, [&](std::uint32_t item) {
        const MappedEdge &edge = edges_[item];
        const auto [low, high] = std::minmax(edge.a.x, edge.b.x);
        if (!(low <= p.x && p.x < high)) { // half-open, so that a chain of edges is met once
            return true;
        }
        const double y = heightOf(edge, p.x);
        // Edges that meet the ray in their common left end are distinguished by their slopes.
        if (y >= p.y && (y < height || (first != nullptr && y == height && slopeOf(edge) < slopeOf(*first)))) {
            first = &edge;
            height = y;
        }
        return true;
    });
    return first == nullptr ? kNoIndex : first->a.x < first->b.x ? first->right : first->left;
}

std::shared_ptr<const FaceMap> repairedFaceMap(const Domain &domain, std::stop_token stop) {
    if (domain.segments.size() > kMaxRepaired) {
        return std::make_shared<const FaceMap>();
    }
    Result<Repaired> repaired = repair(domain, 0.0, std::move(stop));
    if (!repaired) {
        return std::make_shared<const FaceMap>();
    }
    auto sound = std::make_shared<const Domain>(std::move(repaired->domain));
    DomainFaces faces;
    faces.graph = graphOf(*sound);
    faces.sweep = sweepPlane(faces.graph.points, faces.graph.edges);
    if (faces.sweep.droppedCount > 0) {
        return std::make_shared<const FaceMap>();
    }
    faces.faces = findFaces(faces.graph.points, faces.graph.edges, faces.sweep);
    faces.labels = labelFaces(*sound, faces.graph, faces.faces);
    return std::make_shared<const FaceMap>(std::move(sound), faces);
}

std::shared_ptr<const FaceMap> faceMapOf(std::shared_ptr<const Domain> domain) {
    DomainFaces faces;
    if (!validate(*domain, kMaxListedFaults, &faces).empty()) {
        return repairedFaceMap(*domain);
    }
    return std::make_shared<const FaceMap>(std::move(domain), faces);
}

} // namespace forefront
