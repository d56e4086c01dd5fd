#include "core/engine/quads/quad_pocket.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace forefront {

QuadPocket::QuadPocket(const QuadWorkspace &mesh, std::uint32_t cell) : mesh_(mesh), cells_{cell} {
    const QuadCell &corners = mesh.cells[cell];
    outline_.assign(corners.begin(), corners.begin() + cornersOf(corners));
}

std::size_t QuadPocket::triangles() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(cells_, [&](std::uint32_t cell) { return isTriangle(mesh_.cells[cell]); }));
}

bool QuadPocket::holds(std::uint32_t cell) const {
    return std::ranges::find(cells_, cell) != cells_.end();
}

/// Returns the outline of the elements; nothing unless it is one loop that all their fixed nodes lie on.
std::optional<std::vector<std::uint32_t>> QuadPocket::findOutline() const {
    std::vector<std::array<std::uint32_t, 2>> edges; // start and end
    std::vector<std::uint32_t> fixed;
    for (const std::uint32_t cell : cells_) {
        const QuadCell &corners = mesh_.cells[cell];
        for (unsigned k = 0; k < cornersOf(corners); ++k) {
            const std::uint32_t a = corners[k], b = nextCorner(corners, k), other = mesh_.cellWith(b, a);
            if (other == kNoIndex || mesh_.isTagged(a, b) || !holds(other)) {
                edges.push_back({a, b});
            }
            if (mesh_.isFixed(a)) {
                fixed.push_back(a);
            }
        }
    }
    std::ranges::sort(edges);
    std::vector<std::uint32_t> loop;
    for (std::uint32_t node = edges.front()[0]; loop.size() < edges.size();) {
        const auto from = std::ranges::lower_bound(edges, std::array{node, 0U});
        if (from == edges.end() || (*from)[0] != node || (from + 1 != edges.end() && (*(from + 1))[0] == node)) {
            return std::nullopt; // the elements touch at a node
        }
        loop.push_back(node);
        node = (*from)[1];
        if (node == loop.front() && loop.size() < edges.size()) {
            return std::nullopt; // there is another loop
        }
    }
    for (const std::uint32_t node : fixed) {
        if (std::ranges::find(loop, node) == loop.end()) {
            return std::nullopt;
        }
    }
    return loop;
}

bool QuadPocket::add(std::uint32_t cell, std::size_t limit) {
    cells_.push_back(cell);
    std::optional<std::vector<std::uint32_t>> outline = findOutline();
    if (!outline || outline->size() > limit) {
        cells_.pop_back();
        return false;
    }
    outline_ = std::move(*outline);
    return true;
}

bool QuadPocket::grow(std::size_t limit, std::span<const std::uint32_t> first) {
    std::vector<std::uint32_t> ring;
    for (std::size_t i = 0; i < outline_.size(); ++i) {
        const std::uint32_t a = outline_[i], b = outline_[(i + 1) % outline_.size()], other = mesh_.cellWith(b, a);
        if (other != kNoIndex && !mesh_.isTagged(a, b) && std::ranges::find(ring, other) == ring.end()) {
            ring.push_back(other);
        }
    }
    std::stable_partition(ring.begin(), ring.end(),
                          [&](std::uint32_t cell) { return std::ranges::find(first, cell) != first.end(); });
    bool grown = false;
    for (bool again = true; again;) { // a neighbour may fit once another one is there
        again = false;
        for (const std::uint32_t cell : ring) {
            again = (!holds(cell) && add(cell, limit)) || again;
        }
        grown = grown || again;
    }
    return grown;
}

bool QuadPocket::joinedOutside(std::uint32_t a, std::uint32_t b) const {
    for (const std::uint32_t cell : mesh_.around[a]) {
        const QuadCell &corners = mesh_.cells[cell];
        const unsigned k = cornerAt(corners, a);
        if (!holds(cell) && (nextCorner(corners, k) == b || previousCorner(corners, k) == b)) {
            return true;
        }
    }
    return false;
}

} // namespace forefront
