#include "core/engine/mesh/wall_loops.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

namespace forefront {
namespace {

constexpr double kBeyond = 4.0; // larger than any angle in radians

/// Marks the edges of a mesh that are walls.
std::vector<std::uint8_t> wallsOf(const MeshView &mesh, const MeshEdges &edges) {
    std::vector<std::uint8_t> isWall(edges.edges.size(), 0);
    for (std::size_t k = 0; k < isWall.size(); ++k) {
        const auto [first, second] = edges.edges[k].elements;
        isWall[k] = second == kNoElement || mesh.region(index(first)) != mesh.region(index(second)) ? 1 : 0;
    }
    const auto ends = [](const MeshEdge &edge) { return std::pair(index(edge.a), index(edge.b)); };
    for (const TaggedEdge &tagged : mesh.edges) {
        const std::pair<std::size_t, std::size_t> key = std::minmax(index(tagged.a), index(tagged.b));
        const auto found = std::ranges::lower_bound(edges.edges, key, {}, ends);
        if (found != edges.edges.end() && ends(*found) == key) {
            isWall[static_cast<std::size_t>(found - edges.edges.begin())] = 1;
        }
    }
    return isWall;
}

} // namespace

double WallLoops::directionOf(NodeId from, NodeId to) const {
    const Vec2 along = mesh_.nodes[index(to)] - mesh_.nodes[index(from)];
    return std::atan2(along.y, along.x);
}

WallLoops::WallLoops(const MeshView &mesh, const MeshEdges &edges) : mesh_(mesh) {
    std::vector<Side> sides = sidesOf(edges);
    join(sides);
    followAll(sides);
    sortPasses();
}

std::vector<WallLoops::Side> WallLoops::sidesOf(const MeshEdges &edges) const {
    const std::vector<std::uint8_t> isWall = wallsOf(mesh_, edges);
    std::vector<Side> sides;
    const HalfEdges halfEdges(mesh_);
    for (HalfEdge h = 0; h < halfEdges.count(); ++h) {
        if (isWall[edges.ofHalfEdge[h]] != 0) {
            sides.push_back({halfEdges.startOf(h), halfEdges.endOf(h)});
        }
    }
    return sides;
}

/// Finds the successor of each side. Where walls touch, it is the first side clockwise: the two bound
/// the same elements around the node.
void WallLoops::join(std::vector<Side> &sides) const {
    struct Leaving {
        NodeId node;
        double angle;
        std::uint32_t side;
    };
    const auto before = [](const Leaving &a, const Leaving &b) {
        return std::tuple(index(a.node), a.angle) < std::tuple(index(b.node), b.angle);
    };
    std::vector<Leaving> leaving(sides.size());
    for (std::uint32_t s = 0; s < sides.size(); ++s) {
        leaving[s] = {sides[s].from, directionOf(sides[s].from, sides[s].to), s};
    }
    std::stable_sort(leaving.begin(), leaving.end(), before);
    for (Side &side : sides) {
        const Leaving back{side.to, directionOf(side.to, side.from), 0};
        auto next = std::lower_bound(leaving.begin(), leaving.end(), back, before);
        if (next == leaving.begin() || std::prev(next)->node != side.to) { // the one with the largest angle
            next = std::upper_bound(next, leaving.end(), Leaving{side.to, kBeyond, 0}, before);
        }
        if (next != leaving.begin() && std::prev(next)->node == side.to) {
            side.next = std::prev(next)->side;
        }
    }
}

/// Follows open chains (found only in inconsistent meshes) from their starts, then closed loops.
void WallLoops::followAll(const std::vector<Side> &sides) {
    std::vector<char> hasPrevious(sides.size(), 0), visited(sides.size(), 0);
    for (const Side &side : sides) {
        if (side.next != kNoIndex) {
            hasPrevious[side.next] = 1;
        }
    }
    for (const bool open : {true, false}) {
        for (std::uint32_t s = 0; s < sides.size(); ++s) {
            if (visited[s] == 0 && !(open && hasPrevious[s] != 0)) {
                follow(sides, s, visited);
            }
        }
    }
}

void WallLoops::follow(const std::vector<Side> &sides, std::uint32_t start, std::vector<char> &visited) {
    const auto loop = static_cast<std::uint32_t>(lengths_.size());
    double length = 0.0;
    std::uint32_t last = start;
    for (std::uint32_t s = start; s != kNoIndex && visited[s] == 0; s = sides[s].next) {
        visited[s] = 1;
        found_.push_back({sides[s].from, loop, length});
        length += distance(mesh_.nodes[index(sides[s].from)], mesh_.nodes[index(sides[s].to)]);
        last = s;
    }
    const bool closed = sides[last].next == start;
    if (!closed) {
        found_.push_back({sides[last].to, loop, length});
    }
    lengths_.push_back(closed ? length : std::numeric_limits<double>::infinity());
}

void WallLoops::sortPasses() {
    passes_ = Rows<Pass>(mesh_.nodes.size(), [this](const auto &add) {
        for (const Pass &pass : found_) {
            add(index(pass.node), pass);
        }
    });
    found_ = {};
}

bool WallLoops::facing(NodeId a, NodeId b) const {
    constexpr double kDetour = 4.0;
    const double straight = distance(mesh_.nodes[index(a)], mesh_.nodes[index(b)]);
    for (const Pass &one : passes_[index(a)]) {
        for (const Pass &other : passes_[index(b)]) {
            const double apart = std::abs(one.along - other.along);
            if (one.loop == other.loop && std::min(apart, lengths_[one.loop] - apart) <= kDetour * straight) {
                return false;
            }
        }
    }
    return true;
}

} // namespace forefront
