#include "core/files/mfem/mfem_nodes.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace forefront {

namespace {

std::size_t quadrilateralsOf(const ElementList &elements) {
    std::size_t count = 0;
    for (std::size_t e = 0; e < elements.size(); ++e) {
        count += elements.cornersOf(e).size() == 4 ? 1 : 0;
    }
    return count;
}

/// Returns the centre of a quadrilateral of 8 nodes: its shape functions at (0, 0).
Vec2 centreOf(const std::array<Vec2, 8> &nodes) {
    Vec2 corners{}, middles{};
    for (std::size_t k = 0; k < 4; ++k) {
        corners = corners + nodes[k];
        middles = middles + nodes[4 + k];
    }
    return middles * 0.5 - corners * 0.25;
}

} // namespace

std::size_t MfemEdges::add(std::size_t a, std::size_t b) {
    const std::uint64_t key = (static_cast<std::uint64_t>(std::min(a, b)) << 32U) | std::max(a, b);
    return numbers_.try_emplace(key, static_cast<std::uint32_t>(numbers_.size())).first->second;
}

MfemNodes mfemNodes(const MeshView &mesh) {
    MfemNodes result;
    result.vertexOf.assign(mesh.nodes.size(), kNoIndex);
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        for (const NodeId corner : mesh.cornersOf(e)) {
            result.vertexOf[index(corner)] = 0;
        }
    }
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        if (result.vertexOf[n] != kNoIndex) {
            result.vertexOf[n] = static_cast<std::uint32_t>(result.vertices++);
            result.places.push_back(mesh.nodes[n]);
        }
    }

    MfemEdges edges;
    std::vector<std::size_t> sides; // the places of the edges of each quadrilateral, four each
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const CellTraits &traits = traitsOf(mesh.kindOf(e));
        const std::span<const NodeId> nodes = mesh.nodesOf(e);
        for (std::size_t k = 0; k < traits.corners; ++k) {
            const NodeId a = nodes[k], b = nodes[(k + 1) % traits.corners];
            const std::size_t place = result.vertices + edges.add(index(a), index(b));
            if (place == result.places.size()) {
                result.places.push_back((mesh.nodes[index(a)] + mesh.nodes[index(b)]) * 0.5);
            }
            if (traits.order == 2) {
                result.places[place] = mesh.nodes[index(nodes[traits.corners + k])];
            }
            if (traits.corners == 4) {
                sides.push_back(place);
            }
        }
    }

    std::size_t quadrilateral = 0;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const std::span<const NodeId> nodes = mesh.nodesOf(e);
        if (traitsOf(mesh.kindOf(e)).corners != 4) {
            continue;
        }
        std::array<Vec2, 8> around{};
        for (std::size_t k = 0; k < 4; ++k) {
            around[k] = mesh.nodes[index(nodes[k])];
            around[4 + k] = result.places[sides[4 * quadrilateral + k]];
        }
        ++quadrilateral;
        result.places.push_back(nodes.size() == 9 ? mesh.nodes[index(nodes[8])] : centreOf(around));
    }
    return result;
}

ElementList curvedElements(const ElementList &elements, std::size_t vertices, std::span<const Vec2> places,
                           std::size_t quadNodes, std::vector<Vec2> &nodes, std::size_t &expected) {
    MfemEdges edges;
    for (std::size_t e = 0; e < elements.size(); ++e) {
        const std::span<const NodeId> corners = elements.cornersOf(e);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            edges.add(index(corners[k]), index(corners[(k + 1) % corners.size()]));
        }
    }
    std::size_t centre = vertices + edges.size();
    expected = centre + quadrilateralsOf(elements);
    if (places.size() != expected) {
        return {};
    }
    ElementList curved;
    std::vector<NodeId> row;
    for (std::size_t e = 0; e < elements.size(); ++e) {
        const std::span<const NodeId> corners = elements.cornersOf(e);
        row.assign(corners.begin(), corners.end());
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const std::size_t edge = edges.add(index(corners[k]), index(corners[(k + 1) % corners.size()]));
            row.push_back(NodeId{static_cast<std::uint32_t>(vertices + edge)});
        }
        if (corners.size() == 4 && quadNodes == 9) {
            row.push_back(NodeId{static_cast<std::uint32_t>(centre++)});
        }
        curved.add(*elementOfNodes(static_cast<std::int64_t>(row.size())), row, elements.regions[e]);
    }
    const std::size_t kept = quadNodes == 9 ? expected : vertices + edges.size();
    nodes.insert(nodes.end(), places.begin() + static_cast<std::ptrdiff_t>(vertices),
                 places.begin() + static_cast<std::ptrdiff_t>(kept));
    return curved;
}

} // namespace forefront
