#include "core/engine/quads/quad_workspace.hpp"

#include "core/engine/base/key_order.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace forefront {

namespace {

std::uint64_t edgeKey(std::uint32_t a, std::uint32_t b) {
    return pairKey(NodeId{std::min(a, b)}, NodeId{std::max(a, b)});
}

/// Returns the number of elements that divide an angle into about right angles. Slightly fewer in the middle between
/// two numbers: an obtuse corner is better than two acute ones.
std::uint8_t elementsFor(double angle) {
    constexpr double kFewer = 0.05;
    return static_cast<std::uint8_t>(std::max(1.0, std::round(angle / (0.5 * std::numbers::pi) - kFewer)));
}

} // namespace

void NodeCells::add(std::uint32_t node, std::uint32_t cell) {
    Row &row = rows_[node];
    if (row.count < kInline) {
        row.cells[row.count] = cell;
    } else {
        if (row.count == kInline) {
            long_.emplace_back(row.cells.begin(), row.cells.end());
            row.cells[0] = static_cast<std::uint32_t>(long_.size() - 1);
        }
        long_[row.cells[0]].push_back(cell);
    }
    ++row.count;
}

void NodeCells::remove(std::uint32_t node, std::uint32_t cell) {
    Row &row = rows_[node];
    if (row.count <= kInline) {
        const auto end = row.cells.begin() + row.count;
        *std::find(row.cells.begin(), end, cell) = *(end - 1);
        --row.count;
        return;
    }
    std::vector<std::uint32_t> &all = long_[row.cells[0]];
    *std::find(all.begin(), all.end(), cell) = all.back();
    all.pop_back();
    if (--row.count == kInline) {
        std::vector<std::uint32_t> few = std::move(all);
        std::copy(few.begin(), few.end(), row.cells.begin());
    }
}

QuadWorkspace::QuadWorkspace(std::vector<Vec2> places, std::vector<QuadCell> elements,
                             std::vector<std::uint32_t> elementFaces,
                             std::span<const std::array<std::uint32_t, 2>> tagged,
                             std::span<const std::uint32_t> fixedNodes, const SpacingField &field)
    : nodes(std::move(places)), cells(std::move(elements)), faces(std::move(elementFaces)) {
    around.assign(nodes.size());
    fixed_.assign(nodes.size(), 0);
    target_.assign(nodes.size(), 4);
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
        for (unsigned k = 0; k < cornersOf(cells[c]); ++k) {
            around.add(cells[c][k], c);
        }
    }
    for (const std::uint32_t n : fixedNodes) {
        fixed_[n] = 1;
    }
    renewSpacing(field);
    findSectors(tagged);
}

/// Finds the sectors of the nodes of tagged edges, which are fixed.
void QuadWorkspace::findSectors(std::span<const std::array<std::uint32_t, 2>> tagged) {
    sectorOf_.assign(nodes.size(), kNoIndex);
    struct Ray {
        std::uint32_t node, end;
        double direction;
    };
    std::vector<Ray> rays;
    rays.reserve(2 * tagged.size());
    for (const auto &[a, b] : tagged) {
        tagged_.push_back(edgeKey(a, b));
        for (const auto &[from, to] : {std::pair{a, b}, std::pair{b, a}}) {
            const Vec2 d = nodes[to] - nodes[from];
            rays.push_back({from, to, std::atan2(d.y, d.x)});
            fixed_[from] = 1;
        }
    }
    std::sort(tagged_.begin(), tagged_.end());
    std::sort(rays.begin(), rays.end(), [](const Ray &p, const Ray &q) {
        return p.node != q.node             ? p.node < q.node
               : p.direction != q.direction ? p.direction < q.direction
                                            : p.end < q.end;
    });
    for (std::size_t first = 0, end = 0; first < rays.size(); first = end) {
        const std::uint32_t node = rays[first].node;
        for (end = first + 1; end < rays.size() && rays[end].node == node;) {
            ++end;
        }
        const auto begin = static_cast<std::uint32_t>(sectors_.size());
        for (std::size_t r = first; r < end; ++r) {
            if (cellWith(node, rays[r].end) == kNoIndex) {
                continue; // the outside
            }
            const Ray &next = rays[r + 1 < end ? r + 1 : first];
            double angle = next.direction - rays[r].direction;
            angle += angle <= 0.0 ? 2.0 * std::numbers::pi : 0.0;
            sectors_.push_back({rays[r].end, elementsFor(angle)});
            ownerOf_.push_back(node);
        }
        std::uint32_t sum = 0;
        for (std::size_t s = begin; s < sectors_.size(); ++s) {
            sum += sectors_[s].target;
        }
        target_[node] = static_cast<std::uint8_t>(std::min(sum, 255U));
        if (sectors_.size() == begin + 1U) { // the common case: all elements of the node
            sectors_.pop_back();
            ownerOf_.pop_back();
        } else if (sectors_.size() > begin) {
            sectorOf_[node] = begin;
        }
    }
}

std::uint32_t QuadWorkspace::cellsInSector(std::uint32_t node, std::uint32_t from) const {
    const std::uint32_t most = valence(node);
    std::uint32_t count = 0;
    for (std::uint32_t end = from; count < most;) {
        const std::uint32_t cell = cellWith(node, end);
        if (cell == kNoIndex) {
            break;
        }
        ++count;
        end = previousCorner(cells[cell], cornerAt(cells[cell], node));
        if (isTagged(node, end)) {
            break;
        }
    }
    return count;
}

bool QuadWorkspace::isTagged(std::uint32_t a, std::uint32_t b) const {
    return isFixed(a) && isFixed(b) && std::binary_search(tagged_.begin(), tagged_.end(), edgeKey(a, b));
}

bool QuadWorkspace::isIrregular(std::uint32_t node) const {
    bool irregular = false;
    forEachSector(node, [&](std::uint32_t count, std::uint32_t target) { irregular = irregular || count != target; });
    return irregular;
}

void QuadWorkspace::put(std::uint32_t cell, const QuadCell &corners, std::uint32_t face) {
    cells[cell] = corners;
    if (!faces.empty()) {
        faces[cell] = face;
    }
    for (unsigned k = 0; k < cornersOf(corners); ++k) {
        around.add(corners[k], cell);
    }
}

void QuadWorkspace::take(std::uint32_t cell) {
    for (unsigned k = 0; k < cornersOf(cells[cell]); ++k) {
        around.remove(cells[cell][k], cell);
    }
    cells[cell] = kNoCell;
}

std::uint32_t QuadWorkspace::newCell() {
    if (!freeCells_.empty()) {
        const std::uint32_t cell = freeCells_.back();
        freeCells_.pop_back();
        return cell;
    }
    cells.push_back(kNoCell);
    if (!faces.empty()) {
        faces.push_back(0);
    }
    return static_cast<std::uint32_t>(cells.size() - 1);
}

std::uint32_t QuadWorkspace::newNode(Vec2 place, float spacing) {
    if (!freeNodes_.empty()) {
        const std::uint32_t node = freeNodes_.back();
        freeNodes_.pop_back();
        nodes[node] = place;
        rho[node] = spacing;
        return node;
    }
    nodes.push_back(place);
    rho.push_back(spacing);
    fixed_.push_back(0);
    target_.push_back(4);
    sectorOf_.push_back(kNoIndex);
    around.addNode();
    return static_cast<std::uint32_t>(nodes.size() - 1);
}

std::uint32_t QuadWorkspace::cellWith(std::uint32_t a, std::uint32_t b) const {
    for (const std::uint32_t cell : around[a]) {
        if (nextCorner(cells[cell], cornerAt(cells[cell], a)) == b) {
            return cell;
        }
    }
    return kNoIndex;
}

bool QuadWorkspace::areJoined(std::uint32_t a, std::uint32_t b) const {
    for (const std::uint32_t cell : around[a]) {
        const unsigned k = cornerAt(cells[cell], a);
        if (nextCorner(cells[cell], k) == b || previousCorner(cells[cell], k) == b) {
            return true;
        }
    }
    return false;
}

QuadWorkspace::Ring QuadWorkspace::ringOf(std::uint32_t node) const {
    Ring ring;
    const std::span<const std::uint32_t> all = around[node];
    if (all.empty() || all.size() > Ring::kMost) {
        return ring;
    }
    std::uint32_t cell = all[0];
    for (std::size_t i = 0; i < all.size(); ++i) {
        const unsigned k = cornerAt(cells[cell], node);
        ring.nodes[i] = nextCorner(cells[cell], k);
        ring.cells[i] = cell;
        cell = cellWith(node, previousCorner(cells[cell], k));
        if (cell == kNoIndex) {
            return ring;
        }
    }
    ring.count = cell == all[0] ? all.size() : 0;
    return ring;
}

void QuadWorkspace::renewSpacing(const SpacingField &field) {
    std::vector<double> values(nodes.size());
    field.atMany(nodes, values);
    rho.assign(values.begin(), values.end());
}

double QuadWorkspace::leastAround(std::uint32_t node) const {
    double minimum = 2.0;
    for (const std::uint32_t cell : around[node]) {
        minimum = std::min(minimum, shapeOf(cell));
    }
    return minimum;
}

} // namespace forefront
