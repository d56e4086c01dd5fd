#include "core/engine/spacing/parts/background/background_part.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/paced_progress.hpp"
#include "core/engine/geometry/predicates.hpp"

#include <algorithm>

namespace forefront {
namespace {

Diagnostics badBackground(std::string message, std::optional<Vec2> at = {}, std::optional<std::uint32_t> id = {}) {
    Diagnostics faults = error("bad-background", "the background mesh " + message, "choose another background mesh");
    faults.front().at = at;
    if (id) {
        faults.front().ids = {*id};
    }
    return faults;
}

std::optional<Diagnostics> faultOf(const BackgroundMesh &mesh, const Progress &progress) {
    if (mesh.elements.empty()) {
        return badBackground("has no triangles");
    }
    if (mesh.values.size() != mesh.nodes.size()) {
        return badBackground("has " + std::to_string(mesh.values.size()) + " values for " +
                             std::to_string(mesh.nodes.size()) + " nodes; expected one per node");
    }
    if (mesh.elements.size() > 0x3fffffffU || mesh.nodes.size() > 0xfffffffeU) {
        return badBackground("is too large; expected fewer than 2^30 triangles");
    }
    for (std::uint32_t i = 0; i < mesh.nodes.size(); ++i) {
        const Vec2 node = mesh.nodes[i];
        if (!isFinite(node) || std::fabs(node.x) > 1e150 || std::fabs(node.y) > 1e150) {
            return badBackground("has a coordinate that is not finite at node " + std::to_string(i), {}, i);
        }
        if (!std::isfinite(mesh.values[i]) || mesh.values[i] <= 0.0) {
            return badBackground("has an invalid spacing at node " + std::to_string(i) + "; expected a number above 0",
                                 node, i);
        }
    }
    PacedProgress pace(progress, "checking the background mesh", mesh.elements.size());
    for (std::uint32_t e = 0; e < mesh.elements.size(); ++e) {
        if (!pace.next()) {
            return cancelled("preparing the background mesh");
        }
        const auto &[a, b, c] = mesh.elements[e];
        if (std::max({a, b, c}) >= mesh.nodes.size()) {
            return badBackground("has a node index out of range in triangle " + std::to_string(e), {}, e);
        }
        if (const int sign = orientation(mesh.nodes[a], mesh.nodes[b], mesh.nodes[c]); sign <= 0) {
            return badBackground(std::string("has ") +
                                     (sign < 0 ? "an inverted triangle, number " : "a degenerate triangle, number ") +
                                     std::to_string(e),
                                 mesh.nodes[a], e);
        }
    }
    return std::nullopt;
}

bool separated(const std::array<Vec2, 3> &triangle, const Box2 &box) {
    for (int side = 0; side < 3; ++side) {
        const Vec2 a = triangle[static_cast<std::size_t>(side)];
        const Vec2 outward = -1.0 * leftNormal(triangle[static_cast<std::size_t>((side + 1) % 3)] - a);
        const Vec2 nearest{outward.x > 0.0 ? box.min.x : box.max.x, outward.y > 0.0 ? box.min.y : box.max.y};
        if (dot(outward, nearest - a) > 0.0) {
            return true;
        }
    }
    return false;
}

} // namespace

/// Builds the cells level by level.
class BackgroundBuilder {
  public:
    BackgroundBuilder(const BackgroundMesh &mesh, double minimum) : mesh_(mesh), minimum_(minimum) {}

    std::optional<BackgroundPart> run(const Progress &progress) {
        if (!addTriangles(progress)) {
            return std::nullopt;
        }
        layOutTable();
        if (!fillTable(progress)) {
            return std::nullopt;
        }
        while (!cells_.empty()) {
            nextCells_.clear();
            nextLists_.clear();
            PacedProgress pace(progress, "dividing the background mesh", cells_.size());
            for (const Cell &cell : cells_) {
                if (!pace.next()) {
                    return std::nullopt;
                }
                treat(cell);
            }
            cells_.swap(nextCells_);
            work_.swap(nextLists_);
        }
        return std::move(part_);
    }

  private:
    static constexpr std::size_t kShortList = 6;
    static constexpr int kDeepest = 20;
    static constexpr std::size_t kMaxCells = 6'000'000;

    /// Returns false when cancelled.
    bool addTriangles(const Progress &progress) {
        part_.minimum_ = std::numeric_limits<double>::infinity();
        const auto value = [&](std::uint32_t node) { return std::max(mesh_.values[node], minimum_); };
        part_.triangles_.reserve(mesh_.elements.size());
        PacedProgress pace(progress, "preparing the background mesh", mesh_.elements.size());
        for (const auto &[a, b, c] : mesh_.elements) {
            if (!pace.next()) {
                return false;
            }
            const Vec2 ab = mesh_.nodes[b] - mesh_.nodes[a];
            const Vec2 ac = mesh_.nodes[c] - mesh_.nodes[a];
            const double inverse = 1.0 / cross(ab, ac);
            part_.triangles_.push_back({mesh_.nodes[a],
                                        {ac.y * inverse, -ac.x * inverse},
                                        {-ab.y * inverse, ab.x * inverse},
                                        value(a),
                                        value(b) - value(a),
                                        value(c) - value(a)});
            for (const std::uint32_t node : {a, b, c}) {
                box_.add(mesh_.nodes[node]);
                part_.minimum_ = std::min(part_.minimum_, value(node));
                part_.maximum_ = std::max(part_.maximum_, value(node));
            }
        }
        return true;
    }

    void layOutTable() {
        const double cells = std::clamp(std::sqrt(static_cast<double>(mesh_.elements.size())), 1.0, 512.0);
        const double extent = std::max(box_.size().x, box_.size().y);
        part_.corner_ = box_.min;
        part_.toCells_ = cells / extent * (1.0 - 1e-12);
        const auto across = [&](double size) { return static_cast<std::uint32_t>(size * part_.toCells_) + 1U; };
        part_.columns_ = across(box_.size().x);
        part_.rows_ = across(box_.size().y);
        part_.cells_.assign(static_cast<std::size_t>(part_.columns_) * part_.rows_, 0);
    }

    struct Cell {
        std::uint32_t slot = 0;
        int depth = 0;
        Box2 box;
        std::size_t first = 0;
        std::size_t count = 0;
    };

    Box2 tableCell(std::uint32_t i, std::uint32_t j) const {
        const double size = 1.0 / part_.toCells_;
        const Vec2 low = part_.corner_ + size * Vec2{static_cast<double>(i), static_cast<double>(j)};
        return {low, low + Vec2{size, size}};
    }
    std::array<Vec2, 3> cornersOf(std::uint32_t e) const {
        const auto &[a, b, c] = mesh_.elements[e];
        return {mesh_.nodes[a], mesh_.nodes[b], mesh_.nodes[c]};
    }
    bool touches(std::uint32_t e, const Box2 &box) const {
        const auto corners = cornersOf(e);
        Box2 bounds = boxOf(corners[0], corners[1]);
        bounds.add(corners[2]);
        const Box2 wide = box.grown((box.max.x - box.min.x) * 1e-9); // rounding must not lose a triangle
        return bounds.overlaps(wide) && !separated(corners, wide);
    }
    /// Counts, then fills, so that every table cell has a contiguous part of the work list. Returns false when
    /// cancelled.
    bool fillTable(const Progress &progress) {
        std::vector<std::size_t> begins(part_.cells_.size() + 1, 0);
        const auto visit = [&](auto use) {
            PacedProgress pace(progress, "indexing the background mesh", mesh_.elements.size());
            for (std::uint32_t e = 0; e < mesh_.elements.size(); ++e) {
                if (!pace.next()) {
                    return false;
                }
                const auto corners = cornersOf(e);
                Box2 bounds = boxOf(corners[0], corners[1]);
                bounds.add(corners[2]);
                const auto cellOf = [&](double at, std::uint32_t count) {
                    return static_cast<std::uint32_t>(std::clamp(at * part_.toCells_, 0.0, count - 1.0));
                };
                const std::uint32_t lastJ = cellOf(bounds.max.y - part_.corner_.y, part_.rows_);
                const std::uint32_t lastI = cellOf(bounds.max.x - part_.corner_.x, part_.columns_);
                for (std::uint32_t j = cellOf(bounds.min.y - part_.corner_.y, part_.rows_); j <= lastJ; ++j) {
                    for (std::uint32_t i = cellOf(bounds.min.x - part_.corner_.x, part_.columns_); i <= lastI; ++i) {
                        if (touches(e, tableCell(i, j))) {
                            use(j * part_.columns_ + i, e);
                        }
                    }
                }
            }
            return true;
        };
        if (!visit([&](std::uint32_t cell, std::uint32_t) { ++begins[cell + 1]; })) {
            return false;
        }
        for (std::size_t i = 1; i < begins.size(); ++i) {
            begins[i] += begins[i - 1];
        }
        work_.resize(begins.back());
        std::vector<std::size_t> next(begins.begin(), begins.end() - 1);
        if (!visit([&](std::uint32_t cell, std::uint32_t e) { work_[next[cell]++] = e; })) {
            return false;
        }
        for (std::uint32_t cell = 0; cell < part_.cells_.size(); ++cell) {
            cells_.push_back({cell, 0, tableCell(cell % part_.columns_, cell / part_.columns_), begins[cell],
                              begins[cell + 1] - begins[cell]});
        }
        return true;
    }
    void treat(const Cell &cell) {
        if (cell.count <= kShortList || cell.depth == kDeepest || part_.cells_.size() > kMaxCells) {
            store(cell);
            return;
        }
        const std::size_t mark = nextCells_.size();
        const std::size_t listMark = nextLists_.size();
        const Vec2 middle = cell.box.centre();
        std::size_t fullest = 0;
        for (std::uint32_t child = 0; child < 4; ++child) {
            Cell next{child, cell.depth + 1, cell.box, nextLists_.size(), 0};
            ((child & 1U) != 0 ? next.box.min.x : next.box.max.x) = middle.x;
            ((child & 2U) != 0 ? next.box.min.y : next.box.max.y) = middle.y;
            for (std::size_t i = 0; i < cell.count; ++i) {
                if (touches(work_[cell.first + i], next.box)) {
                    nextLists_.push_back(work_[cell.first + i]);
                }
            }
            next.count = nextLists_.size() - next.first;
            fullest = std::max(fullest, next.count);
            nextCells_.push_back(next);
        }
        if (fullest == cell.count) { // a common node of many triangles: dividing does not help
            nextCells_.resize(mark);
            nextLists_.resize(listMark);
            store(cell);
            return;
        }
        const auto group = static_cast<std::uint32_t>(part_.cells_.size());
        part_.cells_.resize(group + 4, 0);
        part_.cells_[cell.slot] = group | BackgroundPart::kSplit;
        for (std::uint32_t child = 0; child < 4; ++child) {
            nextCells_[mark + child].slot = group + child;
        }
    }
    void store(const Cell &cell) {
        part_.cells_[cell.slot] = static_cast<std::uint32_t>(part_.lists_.size());
        part_.lists_.push_back(static_cast<std::uint32_t>(cell.count));
        for (std::size_t i = 0; i < cell.count; ++i) {
            part_.lists_.push_back(work_[cell.first + i]);
        }
    }

    const BackgroundMesh &mesh_;
    double minimum_;
    BackgroundPart part_;
    Box2 box_;
    std::vector<Cell> cells_;
    std::vector<Cell> nextCells_;
    std::vector<std::uint32_t> work_;
    std::vector<std::uint32_t> nextLists_;
};

Result<BackgroundPart> BackgroundPart::build(const BackgroundMesh &mesh, double minimum, const Progress &progress) {
    if (auto fault = faultOf(mesh, progress)) {
        return *std::move(fault);
    }
    auto part = BackgroundBuilder(mesh, minimum).run(progress);
    if (!part) {
        return cancelled("preparing the background mesh");
    }
    return *std::move(part);
}

} // namespace forefront
