#include "core/mesh/mesh.hpp"

#include "core/base/hash.hpp"

namespace forefront {

namespace {

std::uint64_t pair(std::uint32_t low, std::uint32_t high) {
    return std::uint64_t{low} | (std::uint64_t{high} << 32U);
}

std::uint64_t pair(NodeId a, NodeId b) {
    return pair(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
}

} // namespace

Box2 Mesh::bounds() const {
    Box2 box;
    for (const Vec2 p : nodes) {
        box.add(p);
    }
    return box;
}

std::uint64_t meshHash(const Mesh &mesh) {
    Hash64 hash;
    hash.add(static_cast<std::uint64_t>(mesh.nodes.size()));
    for (const Vec2 p : mesh.nodes) {
        hash.add(p.x);
        hash.add(p.y);
    }
    hash.add(static_cast<std::uint64_t>(mesh.elements.size()));
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const Element &element = mesh.elements[e];
        hash.add(pair(element[0], element[1]));
        hash.add(pair(static_cast<std::uint32_t>(element[2]), static_cast<std::uint32_t>(mesh.region(e))));
    }
    hash.add(static_cast<std::uint64_t>(mesh.edges.size()));
    for (const TaggedEdge &edge : mesh.edges) {
        hash.add(pair(edge.a, edge.b));
        hash.add(static_cast<std::uint64_t>(static_cast<std::uint32_t>(edge.tag)));
    }
    hash.add(static_cast<std::uint64_t>(mesh.points.size()));
    for (const TaggedNode &point : mesh.points) {
        hash.add(pair(static_cast<std::uint32_t>(point.node), static_cast<std::uint32_t>(point.tag)));
    }
    return hash.value();
}

} // namespace forefront
