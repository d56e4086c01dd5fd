#include "core/engine/mesh/tri_mesh.hpp"

#include "core/engine/base/hash.hpp"

#include <algorithm>
#include <initializer_list>
#include <numeric>

namespace forefront {

Box2 TriMesh::bounds() const {
    Box2 box;
    for (const Vec2 p : nodes) {
        box.add(p);
    }
    return box;
}

namespace {

/// What a hashed part is, so that an edge never counts as a node, for example.
enum class HashedPart : std::uint64_t { Node = 1, Point, Edge, Triangle };

std::uint64_t hashOf(HashedPart part, std::initializer_list<std::uint64_t> words) {
    Hash64 hash;
    hash.add(static_cast<std::uint64_t>(part));
    for (const std::uint64_t word : words) {
        hash.add(word);
    }
    return hash.value();
}

std::uint64_t tagWord(std::int32_t tag) {
    return static_cast<std::uint32_t>(tag);
}

/// Returns the hash of each node, which depends on its coordinates alone.
std::vector<std::uint64_t> nodeHashes(const std::vector<Vec2> &nodes) {
    std::vector<std::uint64_t> hashes;
    hashes.reserve(nodes.size());
    for (const Vec2 p : nodes) {
        Hash64 hash;
        hash.add(static_cast<std::uint64_t>(HashedPart::Node));
        hash.add(p.x);
        hash.add(p.y);
        hashes.push_back(hash.value());
    }
    return hashes;
}

} // namespace

std::uint64_t meshHash(const TriMesh &mesh) {
    const std::vector<std::uint64_t> node = nodeHashes(mesh.nodes);
    // Meshes of files may refer to nodes that do not exist.
    const auto at = [&](NodeId id) { return index(id) < node.size() ? node[index(id)] : std::uint64_t{0}; };
    // Sums do not depend on the order of the parts.
    std::uint64_t sum = std::accumulate(node.begin(), node.end(), std::uint64_t{0});
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        std::array<std::uint64_t, 3> corners{};
        std::transform(mesh.elements[e].begin(), mesh.elements[e].end(), corners.begin(), at);
        // Whichever corner is first, the order of the corners counts.
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        sum += hashOf(HashedPart::Triangle, {corners[0], corners[1], corners[2], tagWord(mesh.region(e))});
    }
    for (const TaggedEdge &edge : mesh.edges) {
        sum += hashOf(HashedPart::Edge, {at(edge.a), at(edge.b), tagWord(edge.tag)});
    }
    for (const TaggedNode &point : mesh.points) {
        sum += hashOf(HashedPart::Point, {at(point.node), tagWord(point.tag)});
    }
    Hash64 hash;
    for (const std::uint64_t word : {std::uint64_t{mesh.nodes.size()}, std::uint64_t{mesh.elements.size()},
                                     std::uint64_t{mesh.edges.size()}, std::uint64_t{mesh.points.size()}, sum}) {
        hash.add(word);
    }
    return hash.value();
}

} // namespace forefront
