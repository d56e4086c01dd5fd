#include "core/engine/mapped/strip_rows.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/mapped/row_grid.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace forefront {

namespace {

Diagnostics stripRowFault(const char *code, const char *what, const char *advice, const StripFace &strip,
                          const DiscreteDomain &boundary, Vec2 at) {
    Diagnostics faults = error(code, "strip " + boundaryName(boundary.boundaryNames, strip.tag) + ": " + what, advice);
    faults.front().at = at;
    return faults;
}

/// Follows the outline of a face from corner to corner.
class StripOutlineWalk {
  public:
    StripOutlineWalk(const Domain &domain, const DiscreteDomain &boundary, const NextNodes &next)
        : domain_(domain), boundary_(boundary), next_(next) {}

    /// Begins at a node of the domain.
    void begin(std::uint32_t corner) {
        const Vec2 place = domain_.nodes[corner];
        node_ = std::find_if(next_.begin(), next_.end(), [&](const auto &step) {
                    return boundary_.nodes[step.first] == place;
                })->first;
    }
    /// Returns the nodes from here to a node of the domain, both included.
    std::vector<std::uint32_t> to(std::uint32_t corner) {
        const Vec2 place = domain_.nodes[corner];
        std::vector<std::uint32_t> nodes{node_};
        do {
            node_ = next_.at(node_);
            nodes.push_back(node_);
        } while (boundary_.nodes[node_] != place);
        return nodes;
    }

  private:
    const Domain &domain_;
    const DiscreteDomain &boundary_;
    const NextNodes &next_;
    std::uint32_t node_ = 0;
};

} // namespace

std::vector<std::uint32_t> StripOutline::around() const {
    std::vector<std::uint32_t> nodes = right;
    if (!last.empty()) {
        nodes.insert(nodes.end(), last.begin() + 1, last.end() - 1);
    }
    nodes.insert(nodes.end(), left.rbegin(), left.rend());
    if (!first.empty()) {
        nodes.insert(nodes.end(), first.rbegin() + 1, first.rend() - 1);
    }
    return nodes;
}

Result<StripOutline> stripOutline(const StripFace &strip, const Domain &domain, const DiscreteDomain &boundary,
                                  const NextNodes &next) {
    StripOutline outline;
    StripOutlineWalk walk(domain, boundary, next);
    const auto &[firstRight, firstLeft, lastRight, lastLeft] = strip.corners;
    walk.begin(firstRight);
    outline.right = walk.to(lastRight);
    if (strip.closed) {
        walk.begin(firstLeft);
        outline.left = walk.to(firstLeft);
    } else {
        outline.last = walk.to(lastLeft);
        outline.left = walk.to(firstLeft);
        outline.first = walk.to(firstRight);
        std::reverse(outline.first.begin(), outline.first.end());
    }
    std::reverse(outline.left.begin(), outline.left.end());
    const std::size_t across = std::size_t{strip.rows} + 1;
    if (outline.left.size() != outline.right.size() ||
        (!strip.closed && (outline.first.size() != across || outline.last.size() != across))) {
        return stripRowFault("mapped-sides",
                             "its sides, or its ends, cannot have the numbers of elements that it needs",
                             "end the strip inside the domain, or choose another number of rows", strip, boundary,
                             boundary.nodes[outline.right.front()]);
    }
    return outline;
}

Status fillStrip(const StripFace &strip, const StripOutline &outline, const DiscreteDomain &boundary,
                 BoundaryLayers &rows, const Progress &progress) {
    const std::size_t along = outline.right.size() - 1, across = strip.rows;
    const bool triangles = strip.cells == LayerCells::Triangles;
    std::vector<std::uint32_t> ids((along + 1) * (across + 1), kNoIndex);
    RowGrid grid(along, across);
    const auto set = [&](std::size_t i, std::size_t j, std::uint32_t node) {
        ids[i * (across + 1) + j] = node;
        grid.at(i, j) = boundary.nodes[node];
    };
    for (std::size_t i = 0; i <= along; ++i) {
        set(i, 0, outline.right[i]);
        set(i, across, outline.left[i]);
        for (std::size_t j = 1; j < across; ++j) {
            grid.at(i, j) =
                lerp(grid.at(i, 0), grid.at(i, across), static_cast<double>(j) / static_cast<double>(across));
        }
    }
    for (std::size_t j = 1; j < across && !strip.closed; ++j) {
        set(0, j, outline.first[j]);
        set(along, j, outline.last[j]);
    }
    const bool valid = !grid.invertedCell(triangles) || (!strip.closed && grid.smoothUntilValid(triangles, progress));
    if (progress.cancelled()) {
        return cancelled("filling strips");
    }
    if (!valid) {
        return stripRowFault("mapped-inverted", "an element would be inverted",
                             "choose a smaller width, or end the strip more nearly square to the line", strip, boundary,
                             grid.cellCentre(*grid.invertedCell(triangles)));
    }
    for (std::size_t i = 0; i <= along; ++i) {
        for (std::size_t j = 1; j < across; ++j) {
            std::uint32_t &id = ids[i * (across + 1) + j];
            if (strip.closed && i == along) {
                id = ids[j];
            } else if (id == kNoIndex) {
                id = static_cast<std::uint32_t>(boundary.nodes.size() + rows.inner.size());
                rows.inner.push_back(grid.at(i, j));
            }
        }
    }
    addRowCells(grid, ids, !triangles, strip.region, rows);
    return {};
}

void addRowCells(const RowGrid &grid, const std::vector<std::uint32_t> &ids, bool quads, std::uint32_t region,
                 BoundaryLayers &rows) {
    const auto id = [&](std::size_t i, std::size_t j) { return ids[i * (grid.across() + 1) + j]; };
    for (std::size_t i = 0; i < grid.along(); ++i) {
        for (std::size_t j = 0; j < grid.across(); ++j) {
            const std::uint32_t a = id(i, j), b = id(i + 1, j), c = id(i + 1, j + 1), d = id(i, j + 1);
            if (a == d) {
                rows.cells.push_back({{a, b, c, kNoIndex}, region});
            } else if (quads) {
                rows.cells.push_back({{a, b, c, d}, region});
            } else if (grid.firstDiagonal(i, j)) {
                rows.cells.push_back({{a, b, c, kNoIndex}, region});
                rows.cells.push_back({{a, c, d, kNoIndex}, region});
            } else {
                rows.cells.push_back({{a, b, d, kNoIndex}, region});
                rows.cells.push_back({{b, c, d, kNoIndex}, region});
            }
        }
    }
}

} // namespace forefront
