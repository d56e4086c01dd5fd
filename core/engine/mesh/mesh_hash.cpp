#include "core/engine/base/hash.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace forefront {

namespace {

/// The kind of a hashed part, so that an edge never counts as a node, for example. Elements other than triangles of 3
/// nodes, and edges of 3 nodes, follow with their kind added.
enum class HashedPart : std::uint64_t { Node = 1, Point, Edge, Triangle, Cell = 16 };

std::uint64_t hashOf(std::uint64_t part, std::span<const std::uint64_t> words) {
    Hash64 hash;
    hash.add(part);
    for (const std::uint64_t word : words) {
        hash.add(word);
    }
    return hash.value();
}

std::uint64_t tagWord(std::int32_t tag) {
    return static_cast<std::uint32_t>(tag);
}

/// Returns the hash of each node, which depends on its coordinates alone.
std::vector<std::uint64_t> nodeHashes(std::span<const Vec2> nodes) {
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

std::uint64_t partOf(CellKind kind) {
    if (kind == CellKind::Triangle3) {
        return static_cast<std::uint64_t>(HashedPart::Triangle);
    }
    if (kind == CellKind::Edge2) {
        return static_cast<std::uint64_t>(HashedPart::Edge);
    }
    return static_cast<std::uint64_t>(HashedPart::Cell) + static_cast<std::uint64_t>(kind);
}

/// Adds up hashes of parts, so that their order does not count.
class PartSum {
  public:
    explicit PartSum(std::span<const Vec2> nodes)
        : node_(nodeHashes(nodes)), sum_(std::accumulate(node_.begin(), node_.end(), std::uint64_t{0})) {}

    void addElement(CellKind kind, std::span<const NodeId> nodes, std::int32_t region) {
        std::array<std::uint64_t, kMaxCellNodes + 1> words{};
        std::transform(nodes.begin(), nodes.end(), words.begin(), [&](NodeId id) { return at(id); });
        // Whichever corner is first, the order of the corners counts; so for the middles of the edges.
        const auto corners = std::span(words).first(traitsOf(kind).corners);
        const auto first = std::min_element(corners.begin(), corners.end()) - corners.begin();
        std::rotate(corners.begin(), corners.begin() + first, corners.end());
        if (traitsOf(kind).order == 2) {
            const auto middles = std::span(words).subspan(corners.size(), corners.size());
            std::rotate(middles.begin(), middles.begin() + first, middles.end());
        }
        add(partOf(kind), words, nodes.size(), region);
    }
    void addEdge(const TaggedEdge &edge) {
        const bool second = edge.middle != kNoNode;
        std::array<std::uint64_t, 4> words = {at(edge.a), at(edge.b), second ? at(edge.middle) : 0};
        add(partOf(second ? CellKind::Edge3 : CellKind::Edge2), words, second ? 3 : 2, edge.tag);
    }
    void addPoint(const TaggedNode &point) {
        std::array<std::uint64_t, 2> words = {at(point.node)};
        add(static_cast<std::uint64_t>(HashedPart::Point), words, 1, point.tag);
    }
    std::uint64_t value() const { return sum_; }

  private:
    /// Meshes of files may refer to nodes that do not exist.
    std::uint64_t at(NodeId id) const { return index(id) < node_.size() ? node_[index(id)] : 0; }
    /// Adds a part with `count` nodes; there is room for one more word.
    void add(std::uint64_t part, std::span<std::uint64_t> words, std::size_t count, std::int32_t tag) {
        words[count] = tagWord(tag);
        sum_ += hashOf(part, words.first(count + 1));
    }

    std::vector<std::uint64_t> node_;
    std::uint64_t sum_;
};

} // namespace

std::uint64_t meshHash(const MeshView &mesh) {
    PartSum sum(mesh.nodes);
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size(); ++k) {
            sum.addElement(block.kind, block.nodesOf(k), block.region(k));
        }
    }
    for (const TaggedEdge &edge : mesh.edges) {
        sum.addEdge(edge);
    }
    for (const TaggedNode &point : mesh.points) {
        sum.addPoint(point);
    }
    Hash64 hash;
    for (const std::uint64_t word :
         {std::uint64_t{mesh.nodes.size()}, std::uint64_t{mesh.elementCount()}, std::uint64_t{mesh.edges.size()},
          std::uint64_t{mesh.points.size()}, sum.value()}) {
        hash.add(word);
    }
    return hash.value();
}

} // namespace forefront
