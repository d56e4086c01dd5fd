#include "core/files/gmsh/msh_model.hpp"

#include "core/engine/base/key_order.hpp"

#include <algorithm>
#include <numeric>

namespace forefront {

MshModel::MshModel(const TriMesh &mesh, const MshGroups &groups)
    : mesh_(mesh), groups_(groups), owner_(mesh.nodes.size(), kNoIndex) {
    const std::int32_t firstPoint = groups.unusedNumbers(mesh.points.size());
    for (std::uint32_t p = 0; p < mesh.points.size(); ++p) {
        MshEntity &entity = entities_.emplace_back();
        entity.tag = firstPoint + static_cast<std::int32_t>(p);
        entity.physical = groups.number(0, mesh.points[p].tag);
        add(entities_.size() - 1, p);
    }
    for (std::uint32_t e = 0; e < mesh.edges.size(); ++e) {
        add(entityOf(1, mesh.edges[e].tag), e);
    }
    addElements();
    findBounds();
    for (std::uint32_t n = 0; n < owner_.size(); ++n) {
        if (owner_[n] == kNoIndex && !entities_.empty()) {
            owner_[n] = static_cast<std::uint32_t>(entities_.size() - 1);
        }
        if (owner_[n] != kNoIndex) {
            entities_[owner_[n]].nodes.push_back(n);
        }
    }
}

std::size_t MshModel::count(int dimension) const {
    return static_cast<std::size_t>(std::count_if(
        entities_.begin(), entities_.end(), [=](const MshEntity &entity) { return entity.dimension == dimension; }));
}

std::size_t MshModel::nodeBlocks() const {
    return static_cast<std::size_t>(std::count_if(entities_.begin(), entities_.end(),
                                                  [](const MshEntity &entity) { return !entity.nodes.empty(); }));
}

std::size_t MshModel::entityOf(int dimension, std::int32_t tag) {
    const auto [entry, added] = numbers_.emplace(std::pair(dimension, tag), entities_.size());
    if (added) {
        MshEntity &entity = entities_.emplace_back();
        entity.dimension = dimension;
        entity.tag = entity.physical = groups_.number(dimension, tag);
    }
    return entry->second;
}

void MshModel::add(std::size_t number, std::uint32_t part) {
    MshEntity &entity = entities_[number];
    entity.parts.push_back(part);
    const Element nodes = nodesOf(entity.dimension, part);
    for (std::size_t k = 0; k < entity.cornerCount(); ++k) {
        entity.box.add(mesh_.nodes[index(nodes[k])]);
        std::uint32_t &owner = owner_[index(nodes[k])];
        owner = owner == kNoIndex ? static_cast<std::uint32_t>(number) : owner;
    }
}

/// Elements come in long runs of one region, and most of their nodes have already been seen in that region.
void MshModel::addElements() {
    for (std::uint32_t begin = 0, end = 0; begin < mesh_.elements.size(); begin = end) {
        const std::int32_t region = mesh_.region(begin);
        for (end = begin + 1; end < mesh_.elements.size() && mesh_.region(end) == region;) {
            ++end;
        }
        const auto number = static_cast<std::uint32_t>(entityOf(2, region));
        MshEntity &entity = entities_[number];
        const std::size_t before = entity.parts.size();
        entity.parts.resize(before + (end - begin));
        std::iota(entity.parts.begin() + static_cast<std::ptrdiff_t>(before), entity.parts.end(), begin);
        for (std::uint32_t e = begin; e < end; ++e) {
            for (const NodeId node : mesh_.elements[e]) {
                std::uint32_t &owner = owner_[index(node)];
                if (owner != number) {
                    entity.box.add(mesh_.nodes[index(node)]);
                    owner = owner == kNoIndex ? number : owner;
                }
            }
        }
    }
}

/// The elements along tagged edges; few sides of elements have both ends on one, and only those are looked up.
void MshModel::findBounds() {
    using Side = std::pair<std::uint64_t, std::int32_t>; // key of both nodes, tag
    std::vector<Side> tagged;
    std::vector<std::uint8_t> onEdge(mesh_.nodes.size(), 0);
    tagged.reserve(mesh_.edges.size());
    for (const TaggedEdge &edge : mesh_.edges) {
        tagged.emplace_back(pairKey(std::min(edge.a, edge.b), std::max(edge.a, edge.b)), edge.tag);
        onEdge[index(edge.a)] = onEdge[index(edge.b)] = 1;
    }
    std::sort(tagged.begin(), tagged.end());
    for (std::uint32_t e = 0; e < mesh_.elements.size(); ++e) {
        const Element &nodes = mesh_.elements[e];
        for (std::size_t k = 0; k < 3; ++k) {
            const NodeId a = nodes[k], b = nodes[(k + 1) % 3];
            if (onEdge[index(a)] == 0 || onEdge[index(b)] == 0) {
                continue;
            }
            const std::uint64_t side = pairKey(std::min(a, b), std::max(a, b));
            auto found = std::lower_bound(tagged.begin(), tagged.end(), Side{side, 0});
            for (; found != tagged.end() && found->first == side; ++found) {
                entities_[entityOf(2, mesh_.region(e))].bounds.insert(groups_.number(1, found->second));
            }
        }
    }
}

} // namespace forefront
