#include "core/engine/mesh/triangulated.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace forefront {

namespace {

/// A triangle within an element, by the places of its nodes there, and which of its edges are those of the element.
struct PartTriangle {
    std::array<std::uint8_t, 3> nodes;
    std::uint8_t realEdges;
};

constexpr std::array<PartTriangle, 1> kWhole = {{{{0, 1, 2}, 0b111}}};
constexpr std::array<PartTriangle, 4> kOfTriangle6 = {
    {{{0, 3, 5}, 0b101}, {{3, 1, 4}, 0b011}, {{5, 4, 2}, 0b110}, {{3, 4, 5}, 0b000}}};
constexpr std::array<PartTriangle, 2> kAlong02 = {{{{0, 1, 2}, 0b011}, {{0, 2, 3}, 0b110}}};
constexpr std::array<PartTriangle, 2> kAlong13 = {{{{0, 1, 3}, 0b101}, {{1, 2, 3}, 0b011}}};
constexpr std::array<PartTriangle, 4> kCornersOf8 = {
    {{{0, 4, 7}, 0b101}, {{1, 5, 4}, 0b101}, {{2, 6, 5}, 0b101}, {{3, 7, 6}, 0b101}}};
constexpr std::array<PartTriangle, 2> kAlong46 = {{{{4, 5, 6}, 0b000}, {{4, 6, 7}, 0b000}}};
constexpr std::array<PartTriangle, 2> kAlong57 = {{{{4, 5, 7}, 0b000}, {{5, 6, 7}, 0b000}}};
constexpr std::array<PartTriangle, 8> kOfQuadrilateral9 = {{{{0, 4, 8}, 0b001},
                                                            {{4, 1, 8}, 0b001},
                                                            {{1, 5, 8}, 0b001},
                                                            {{5, 2, 8}, 0b001},
                                                            {{2, 6, 8}, 0b001},
                                                            {{6, 3, 8}, 0b001},
                                                            {{3, 7, 8}, 0b001},
                                                            {{7, 0, 8}, 0b001}}};

class ElementSplitter {
  public:
    explicit ElementSplitter(MeshView mesh) : mesh_(std::move(mesh)) {}

    void run(Triangulated &parts) {
        std::size_t count = 0;
        for (const MeshView::Block &block : mesh_.blocks()) {
            count += block.size() * trianglesOf(block.kind);
        }
        parts.mesh.elements.reserve(count);
        parts.mesh.regions.reserve(count);
        parts.elementOf.reserve(count);
        parts.realEdges.reserve(count);
        for (const MeshView::Block &block : mesh_.blocks()) {
            for (std::size_t k = 0; k < block.size(); ++k) {
                split(block, k, parts);
            }
        }
    }

  private:
    static std::size_t trianglesOf(CellKind kind) {
        switch (kind) {
        case CellKind::Triangle6:
            return 4;
        case CellKind::Quadrilateral4:
            return 2;
        case CellKind::Quadrilateral8:
            return 6;
        case CellKind::Quadrilateral9:
            return 8;
        default:
            return 1;
        }
    }

    void split(const MeshView::Block &block, std::size_t k, Triangulated &parts) const {
        const std::span<const NodeId> nodes = block.nodesOf(k);
        const auto add = [&](std::span<const PartTriangle> triangles) {
            for (const PartTriangle &part : triangles) {
                parts.mesh.elements.push_back({nodes[part.nodes[0]], nodes[part.nodes[1]], nodes[part.nodes[2]]});
                parts.mesh.regions.push_back(block.region(k));
                parts.elementOf.push_back(static_cast<std::uint32_t>(block.first + k));
                parts.realEdges.push_back(part.realEdges);
            }
        };
        switch (block.kind) {
        case CellKind::Triangle6:
            return add(kOfTriangle6);
        case CellKind::Quadrilateral4:
            return add(better(nodes, kAlong02, kAlong13));
        case CellKind::Quadrilateral8:
            add(kCornersOf8);
            return add(better(nodes, kAlong46, kAlong57));
        case CellKind::Quadrilateral9:
            return add(kOfQuadrilateral9);
        default:
            return add(kWhole);
        }
    }

    /// Returns the pair of triangles whose worse one is better, the first if they are equal. The area of a triangle
    /// beside a diagonal outside the quadrilateral is negative.
    std::span<const PartTriangle> better(std::span<const NodeId> nodes, const std::array<PartTriangle, 2> &first,
                                         const std::array<PartTriangle, 2> &second) const {
        const auto worst = [&](const std::array<PartTriangle, 2> &pair) {
            return std::min(shapeOf(nodes, pair[0]), shapeOf(nodes, pair[1]));
        };
        return worst(second) > worst(first) ? second : first;
    }

    /// Returns a measure of the shape of a triangle: its area over the sum of the squares of its edges.
    double shapeOf(std::span<const NodeId> nodes, const PartTriangle &part) const {
        const Vec2 a = mesh_.nodes[index(nodes[part.nodes[0]])], b = mesh_.nodes[index(nodes[part.nodes[1]])],
                   c = mesh_.nodes[index(nodes[part.nodes[2]])];
        const double squares = dot(b - a, b - a) + dot(c - b, c - b) + dot(a - c, a - c);
        return squares > 0.0 ? cross(b - a, c - a) / squares : 0.0;
    }

    MeshView mesh_;
};

/// Puts two edges in place of each tagged edge of 3 nodes.
void splitEdges(std::vector<TaggedEdge> &edges, std::vector<CurveStretch> &stretches) {
    const bool any = std::any_of(edges.begin(), edges.end(), [](const TaggedEdge &e) { return e.middle != kNoNode; });
    if (!any) {
        return;
    }
    std::vector<TaggedEdge> halves;
    std::vector<CurveStretch> ofHalves;
    for (std::size_t k = 0; k < edges.size(); ++k) {
        const TaggedEdge &edge = edges[k];
        const CurveStretch whole = stretches.empty() ? CurveStretch{} : stretches[k];
        if (edge.middle == kNoNode) {
            halves.push_back(edge);
            ofHalves.push_back(whole);
            continue;
        }
        halves.push_back({edge.a, edge.middle, edge.tag});
        halves.push_back({edge.middle, edge.b, edge.tag});
        const double middle = 0.5 * (whole.t0 + whole.t1);
        ofHalves.push_back({whole.curve, whole.t0, middle});
        ofHalves.push_back({whole.curve, middle, whole.t1});
    }
    edges = std::move(halves);
    stretches = stretches.empty() ? std::vector<CurveStretch>() : std::move(ofHalves);
}

bool areTriangles(const MeshView &mesh) {
    return std::all_of(mesh.blocks().begin(), mesh.blocks().end(),
                       [](const MeshView::Block &block) { return block.kind == CellKind::Triangle3; });
}

} // namespace

Triangulated triangulated(const MeshView &mesh) {
    if (areTriangles(mesh)) {
        return takeTriangulated(copyOf(mesh));
    }
    Triangulated parts;
    ElementSplitter(mesh).run(parts);
    parts.mesh.nodes.assign(mesh.nodes.begin(), mesh.nodes.end());
    parts.mesh.edges.assign(mesh.edges.begin(), mesh.edges.end());
    parts.mesh.points.assign(mesh.points.begin(), mesh.points.end());
    parts.mesh.curves.assign(mesh.curves.begin(), mesh.curves.end());
    parts.mesh.edgeStretches.assign(mesh.edgeStretches.begin(), mesh.edgeStretches.end());
    parts.mesh.boundaryNames = mesh.boundaryNames;
    parts.mesh.regionNames = mesh.regionNames;
    splitEdges(parts.mesh.edges, parts.mesh.edgeStretches);
    return parts;
}

Triangulated takeTriangulated(Mesh mesh) {
    Triangulated parts;
    if (!mesh.isTriangular()) {
        ElementSplitter(mesh).run(parts);
        std::vector<Element> elements = std::move(parts.mesh.elements);
        mesh.blocks.clear();
        mesh.blocks.emplace_back(std::move(elements), std::move(parts.mesh.regions));
    }
    parts.mesh = takeTriMesh(std::move(mesh));
    splitEdges(parts.mesh.edges, parts.mesh.edgeStretches);
    return parts;
}

} // namespace forefront
