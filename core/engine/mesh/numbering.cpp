#include "core/engine/mesh/numbering.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace forefront {

namespace {

/// The elements at each node: those of node n are list[begin[n]] to list[begin[n + 1]], in their order.
class ElementsAtNodes {
  public:
    explicit ElementsAtNodes(const MeshView &mesh) : begin_(mesh.nodes.size() + 1, 0) {
        const auto eachNode = [&](auto &&visit) {
            for (const MeshView::Block &block : mesh.blocks()) {
                for (std::size_t k = 0; k < block.size(); ++k) {
                    for (const NodeId node : block.nodesOf(k)) {
                        visit(index(node), block.first + k);
                    }
                }
            }
        };
        eachNode([&](std::size_t node, std::size_t) { ++begin_[node + 1]; });
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
        list_.resize(begin_.back());
        std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
        eachNode(
            [&](std::size_t node, std::size_t element) { list_[next[node]++] = static_cast<std::uint32_t>(element); });
    }
    std::span<const std::uint32_t> at(std::size_t node) const {
        return std::span(list_).subspan(begin_[node], count(node));
    }
    std::size_t count(std::size_t node) const { return begin_[node + 1] - begin_[node]; }

  private:
    std::vector<std::uint32_t> begin_, list_;
};

/// Breadth-first searches over the nodes of a mesh, where two nodes are neighbours if an element has both.
class NodeSearch {
  public:
    explicit NodeSearch(const MeshView &mesh)
        : mesh_(mesh), elements_(mesh), stamp_(mesh.nodes.size(), 0), elementStamp_(mesh.elementCount(), 0) {}

    bool hasElements(std::size_t node) const { return elements_.count(node) > 0; }

    /// Appends all nodes that can be reached from `start` to `order`: level by level, the nodes that one node adds by
    /// the number of their elements, ties by number. Returns the number of levels.
    std::size_t append(std::uint32_t start, std::vector<std::uint32_t> &order) {
        ++now_;
        std::size_t levels = 0, done = order.size(), levelEnd = done;
        stamp_[start] = now_;
        order.push_back(start);
        for (; done < order.size(); ++done) {
            const std::size_t first = order.size();
            if (done == levelEnd) {
                levelEnd = first;
                ++levels;
            }
            for (const std::uint32_t element : elements_.at(order[done])) {
                addNodesOf(element, order);
            }
            std::sort(order.begin() + static_cast<std::ptrdiff_t>(first), order.end(),
                      [&](std::uint32_t a, std::uint32_t b) {
                          return std::pair(elements_.count(a), a) < std::pair(elements_.count(b), b);
                      });
        }
        return levels;
    }

  private:
    void addNodesOf(std::uint32_t element, std::vector<std::uint32_t> &order) {
        if (std::exchange(elementStamp_[element], now_) == now_) {
            return; // an earlier node has added all of its nodes
        }
        for (const NodeId id : mesh_.nodesOf(element)) {
            const auto node = static_cast<std::uint32_t>(index(id));
            if (std::exchange(stamp_[node], now_) != now_) {
                order.push_back(node);
            }
        }
    }

    const MeshView &mesh_;
    ElementsAtNodes elements_;
    std::vector<std::uint32_t> stamp_, elementStamp_; ///< the search that reached each last
    std::uint32_t now_ = 0;
};

/// Appends the part of the mesh with this node to `order`, from an end of it: searches start anew from the last node of
/// the one before as long as that makes them longer by an eighth; less is not worth a search.
void appendPart(std::uint32_t node, NodeSearch &search, std::vector<std::uint32_t> &order) {
    const std::size_t first = order.size();
    for (std::size_t levels = 0, found = search.append(node, order); 8 * found > 9 * levels;) {
        levels = found;
        node = order.back();
        order.resize(first);
        found = search.append(node, order);
    }
}

} // namespace

std::size_t bandwidth(const MeshView &mesh) {
    std::size_t widest = 0;
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size(); ++k) {
            const auto [least, greatest] = std::ranges::minmax(block.nodesOf(k), {}, [](NodeId n) { return index(n); });
            widest = std::max(widest, index(greatest) - index(least));
        }
    }
    return widest;
}

std::vector<NodeId> reverseCuthillMcKee(const MeshView &mesh) {
    NodeSearch search(mesh);
    std::vector<std::uint32_t> order;
    order.reserve(mesh.nodes.size());
    std::vector<char> numbered(mesh.nodes.size(), 0);
    for (std::uint32_t node = 0; node < numbered.size(); ++node) {
        if (numbered[node] == 0 && search.hasElements(node)) {
            const std::size_t first = order.size();
            appendPart(node, search, order);
            for (std::size_t k = first; k < order.size(); ++k) {
                numbered[order[k]] = 1;
            }
        }
    }
    std::vector<NodeId> numbers(mesh.nodes.size());
    const std::size_t withElements = order.size();
    std::size_t alone = withElements;
    for (std::size_t k = 0; k < withElements; ++k) {
        numbers[order[k]] = static_cast<NodeId>(withElements - 1 - k);
    }
    for (std::size_t n = 0; n < numbered.size(); ++n) {
        if (numbered[n] == 0) {
            numbers[n] = static_cast<NodeId>(alone++);
        }
    }
    return numbers;
}

namespace {

/// Returns the elements of a block ordered by the least new number of their nodes, ties as before.
std::vector<std::uint32_t> byLeastNode(const MeshView::Block &block, std::span<const NodeId> numbers) {
    std::vector<std::uint32_t> least(block.size());
    std::vector<std::uint32_t> begin(numbers.size() + 1, 0);
    for (std::size_t k = 0; k < block.size(); ++k) {
        std::size_t smallest = numbers.size();
        for (const NodeId node : block.nodesOf(k)) {
            smallest = std::min(smallest, index(numbers[index(node)]));
        }
        least[k] = static_cast<std::uint32_t>(smallest);
        ++begin[smallest + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::uint32_t> order(block.size());
    for (std::uint32_t k = 0; k < block.size(); ++k) {
        order[begin[least[k]]++] = k;
    }
    return order;
}

/// Copies the elements of a block with new node numbers, ordered by their least node.
CellBlock renumberedBlock(const MeshView::Block &from, std::span<const NodeId> numbers) {
    CellBlock block(from.kind);
    block.reserve(from.size());
    if (!from.regions.empty()) {
        block.regions.reserve(from.size());
    }
    std::array<NodeId, kMaxCellNodes> nodes{};
    for (const std::uint32_t k : byLeastNode(from, numbers)) {
        const std::span<const NodeId> old = from.nodesOf(k);
        std::ranges::transform(old, nodes.begin(), [&](NodeId node) { return numbers[index(node)]; });
        block.add(std::span(nodes).first(old.size()));
        if (!from.regions.empty()) {
            block.regions.push_back(from.regions[k]);
        }
    }
    return block;
}

} // namespace

Mesh renumbered(const MeshView &mesh, std::span<const NodeId> numbers) {
    Mesh result;
    result.nodes.resize(mesh.nodes.size());
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        result.nodes[index(numbers[n])] = mesh.nodes[n];
    }
    for (const MeshView::Block &block : mesh.blocks()) {
        result.blocks.push_back(renumberedBlock(block, numbers));
    }
    const auto change = [&](NodeId &node) { node = node == kNoNode ? kNoNode : numbers[index(node)]; };
    result.edges.assign(mesh.edges.begin(), mesh.edges.end());
    for (TaggedEdge &edge : result.edges) {
        change(edge.a);
        change(edge.b);
        change(edge.middle);
    }
    result.points.assign(mesh.points.begin(), mesh.points.end());
    for (TaggedNode &point : result.points) {
        change(point.node);
    }
    result.curves.assign(mesh.curves.begin(), mesh.curves.end());
    result.edgeStretches.assign(mesh.edgeStretches.begin(), mesh.edgeStretches.end());
    result.periodic.assign(mesh.periodic.begin(), mesh.periodic.end());
    result.boundaryNames = mesh.boundaryNames;
    result.regionNames = mesh.regionNames;
    return result;
}

} // namespace forefront
