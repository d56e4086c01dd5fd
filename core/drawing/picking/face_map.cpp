#include "core/drawing/picking/face_map.hpp"

#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

} // namespace

FaceMap::FaceMap(std::shared_ptr<const Domain> domain, const DomainFaces &faces) : domain_(std::move(domain)) {
    std::vector<std::uint32_t> numbers(faces.faces.count, kNoIndex);
    for (std::uint32_t face = 0; face < faces.faces.count; ++face) {
        if (faces.labels.inside[face] != 0) {
            numbers[face] = static_cast<std::uint32_t>(faces_.size());
            faces_.push_back({0.0, {}, faces.labels.tag[face], faces.labels.marker[face]});
        }
    }
    addEdges(faces, numbers);
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
        edges_.push_back(edge);
    }
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
