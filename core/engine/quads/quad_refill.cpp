#include "core/engine/quads/quad_refill.hpp"

#include "core/engine/geometry/predicates.hpp"
#include "core/engine/quads/polygon_fill.hpp"
#include "core/engine/quads/quad_pocket.hpp"
#include "core/engine/quads/quad_smooth.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

namespace forefront {

namespace {

constexpr unsigned kRings = 3;          ///< around an element, among which the best fill is taken
constexpr double kGoodFill = 0.1;       ///< minimum scaled Jacobian with which the smallest pocket is taken
constexpr double kTriangleCost = 1e5;   ///< where quadrilaterals alone are asked for: more than any number of them
constexpr double kMixedTriangles = 1.0; ///< where triangles are allowed
constexpr unsigned kMeanSweeps = 10, kPolishSweeps = 4;
constexpr unsigned kRounds = 3;         ///< a pocket may end where another one begins
constexpr double kPolishedShape = 0.75; ///< minimum scaled Jacobian that polishing aims at

// An element that is flat at a corner within rounding is less of a fault than one that is reflex there.
constexpr std::size_t kFlatFault = 1, kReflexFault = 3;

std::size_t faultsOfShape(const QuadCell &cell, std::span<const Vec2> nodes) {
    if (isClearlyConvex(cell, nodes)) {
        return 0;
    }
    for (unsigned k = 0; k < cornersOf(cell); ++k) {
        if (orientation(nodes[previousCorner(cell, k)], nodes[cell[k]], nodes[nextCorner(cell, k)]) <= 0) {
            return kReflexFault;
        }
    }
    return kFlatFault;
}

class PocketRefill {
  public:
    PocketRefill(QuadWorkspace &mesh, Elements elements, QuadWatch *watch)
        : mesh_(mesh), mixed_(elements == Elements::Mixed), watch_(watch) {}

    std::vector<Vec2> run(const Progress &progress) {
        for (unsigned round = 0; round < kRounds; ++round) {
            bad_.clear();
            for (std::uint32_t cell = 0; cell < mesh_.cells.size(); ++cell) {
                if (faultsOf(cell) > 0) {
                    bad_.push_back(cell);
                }
            }
            bool filled = false;
            for (const std::uint32_t cell : bad_) {
                if (progress.cancelled()) {
                    return std::move(trianglesAt_);
                }
                filled = (faultsOf(cell) > 0 && mend(cell)) || filled;
            }
            if (!filled) {
                break;
            }
            polish();
        }
        return std::move(trianglesAt_);
    }

  private:
    /// A pocket with its fill.
    struct Candidate {
        QuadPocket pocket;
        PolygonFill fill;
        std::size_t faults = 0; ///< of the fill
        std::size_t excess = 0; ///< triangles beyond those that were there
    };

    std::size_t faultsOf(std::uint32_t cell) const {
        return isAlive(mesh_.cells[cell]) ? faultsOfShape(mesh_.cells[cell], mesh_.nodes) : 0;
    }

    /// Fills a pocket. Returns nothing unless that leaves fewer faults than there are.
    std::optional<Candidate> fill(const QuadPocket &pocket) const {
        const std::span<const std::uint32_t> outline = pocket.outline();
        std::vector<Vec2> places;
        for (const std::uint32_t node : outline) {
            places.push_back(mesh_.nodes[node]);
        }
        std::optional<PolygonFill> found = fillPolygon(
            places, {[&](std::size_t i, std::size_t j) { return pocket.joinedOutside(outline[i], outline[j]); },
                     mixed_ ? kMixedTriangles : kTriangleCost});
        if (!found) {
            return std::nullopt;
        }
        std::size_t before = 0, after = 0;
        for (const std::uint32_t cell : pocket.cells()) {
            before += faultsOf(cell);
        }
        for (const QuadCell &cell : found->cells) {
            after += faultsOfShape(cell, places);
        }
        if (after >= before) {
            return std::nullopt;
        }
        const std::size_t had = pocket.triangles();
        const std::size_t excess = mixed_ || found->triangles <= had ? 0 : found->triangles - had;
        return Candidate{pocket, std::move(*found), after, excess};
    }

    static bool isBetter(const Candidate &a, const Candidate &b) {
        return a.faults != b.faults   ? a.faults < b.faults
               : a.excess != b.excess ? a.excess < b.excess
                                      : a.fill.leastShape > b.fill.leastShape;
    }

    /// Moves the nodes inside a pocket so that its elements are convex. Returns false if none of their places is found;
    /// they are then where they were.
    bool straighten(const QuadPocket &pocket) {
        nodes_.clear();
        for (const std::uint32_t cell : pocket.cells()) {
            const QuadCell &corners = mesh_.cells[cell];
            std::copy_if(
                corners.begin(), corners.begin() + cornersOf(corners), std::back_inserter(nodes_),
                [&](std::uint32_t n) { return std::ranges::find(pocket.outline(), n) == pocket.outline().end(); });
        }
        std::ranges::sort(nodes_);
        nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
        std::vector<Vec2> before;
        for (const std::uint32_t node : nodes_) {
            before.push_back(mesh_.nodes[node]);
        }
        const auto isStraight = [&] {
            return std::ranges::all_of(pocket.cells(), [&](std::uint32_t cell) { return faultsOf(cell) == 0; });
        };
        // Means of neighbours first, since they untangle what no small step could.
        for (unsigned sweep = 0; sweep < kMeanSweeps; ++sweep) {
            for (const std::uint32_t node : nodes_) {
                mesh_.nodes[node] = meanOfNeighbours(node);
            }
        }
        for (unsigned sweep = 0; sweep < kPolishSweeps; ++sweep) {
            for (const std::uint32_t node : nodes_) {
                polishNode(mesh_, node, kPolishedShape);
            }
        }
        if (!nodes_.empty() && isStraight()) {
            if (watch_ != nullptr) {
                watch_->changed(ImproveChange::Refill, mesh_, {false, nodes_, {}});
            }
            return true;
        }
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            mesh_.nodes[nodes_[i]] = before[i];
        }
        return false;
    }

    Vec2 meanOfNeighbours(std::uint32_t node) const {
        Vec2 sum;
        for (const std::uint32_t cell : mesh_.around[node]) {
            const unsigned k = cornerAt(mesh_.cells[cell], node);
            sum += mesh_.nodes[nextCorner(mesh_.cells[cell], k)] + mesh_.nodes[previousCorner(mesh_.cells[cell], k)];
        }
        return (0.5 / mesh_.valence(node)) * sum;
    }

    /// Straightens the elements of the first pocket around an element for which that is possible.
    bool straightenAround(std::uint32_t cell) {
        QuadPocket pocket(mesh_, cell);
        for (unsigned ring = 1; ring <= kRings && pocket.grow(kMaxFillNodes, bad_); ++ring) {
            if (straighten(pocket)) {
                return true;
            }
        }
        return false;
    }

    /// Finds the pocket around an element with the best fill among those of a few rings. An element that is clockwise
    /// or not convex gets the first larger one if none of them can be filled.
    std::optional<Candidate> bestPocket(std::uint32_t cell) const {
        const bool flat = faultsOf(cell) == kFlatFault;
        std::optional<Candidate> best;
        QuadPocket pocket(mesh_, cell);
        bool grows = true;
        for (unsigned ring = 0; grows && (ring <= kRings || (!best && !flat)); ++ring) {
            if (std::optional<Candidate> here = fill(pocket)) {
                const bool good = here->faults == 0 && here->excess == 0 && here->fill.leastShape > kGoodFill;
                if (!best || isBetter(*here, *best)) {
                    best.emplace(std::move(*here));
                }
                if (good) {
                    break;
                }
            }
            grows = pocket.grow(kMaxFillNodes, bad_);
        }
        return best;
    }

    bool mend(std::uint32_t cell) {
        if (straightenAround(cell)) {
            return true;
        }
        std::optional<Candidate> best = bestPocket(cell);
        if (!best) {
            return false;
        }
        replace(best->pocket, best->fill);
        if (best->excess > 0) {
            trianglesAt_.push_back(placeOfTriangle());
        }
        return true;
    }

    /// Puts the fill of a pocket in the place of its elements.
    void replace(const QuadPocket &pocket, const PolygonFill &fill) {
        changed_.assign(pocket.cells().begin(), pocket.cells().end());
        nodes_.clear();
        const std::uint32_t face = mesh_.faceOf(changed_.front());
        for (const std::uint32_t cell : changed_) {
            const QuadCell corners = mesh_.cells[cell];
            nodes_.insert(nodes_.end(), corners.begin(), corners.begin() + cornersOf(corners));
            mesh_.take(cell);
        }
        for (std::size_t i = 0; i < fill.cells.size(); ++i) {
            QuadCell corners = fill.cells[i];
            for (unsigned k = 0; k < cornersOf(fill.cells[i]); ++k) {
                corners[k] = pocket.outline()[corners[k]];
            }
            if (i == changed_.size()) {
                changed_.push_back(mesh_.newCell());
            }
            mesh_.put(changed_[i], corners, face);
        }
        for (std::size_t i = fill.cells.size(); i < changed_.size(); ++i) {
            mesh_.release(changed_[i]);
        }
        releaseNodes();
        outlines_.insert(outlines_.end(), pocket.outline().begin(), pocket.outline().end());
        if (watch_ != nullptr) {
            watch_->changed(ImproveChange::Refill, mesh_, {false, nodes_, changed_});
        }
    }

    void releaseNodes() {
        std::ranges::sort(nodes_);
        nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
        for (const std::uint32_t node : nodes_) {
            if (mesh_.valence(node) == 0) {
                mesh_.releaseNode(node);
            }
        }
    }

    /// Returns the middle of the first triangle of the fill made last.
    Vec2 placeOfTriangle() const {
        for (const std::uint32_t cell : changed_) {
            const QuadCell &t = mesh_.cells[cell];
            if (isAlive(t) && isTriangle(t)) {
                return (1.0 / 3.0) * (mesh_.nodes[t[0]] + mesh_.nodes[t[1]] + mesh_.nodes[t[2]]);
            }
        }
        return {};
    }

    /// Moves the nodes around the pockets to better places, which cannot turn an element that is convex.
    void polish() {
        std::ranges::sort(outlines_);
        outlines_.erase(std::unique(outlines_.begin(), outlines_.end()), outlines_.end());
        bool moved = false;
        for (const std::uint32_t node : outlines_) {
            if (mesh_.valence(node) > 0 && mesh_.leastAround(node) > 0.0) {
                moved = polishNode(mesh_, node, kPolishedShape) || moved;
            }
        }
        if (moved && watch_ != nullptr) {
            watch_->changed(ImproveChange::Polish, mesh_, {});
        }
        outlines_.clear();
    }

    QuadWorkspace &mesh_;
    bool mixed_;
    QuadWatch *watch_;
    std::vector<std::uint32_t> bad_;
    std::vector<std::uint32_t> changed_, nodes_; ///< of the fill made last
    std::vector<std::uint32_t> outlines_;        ///< nodes of the pockets of this round
    std::vector<Vec2> trianglesAt_;
};

} // namespace

std::vector<Vec2> refillPockets(QuadWorkspace &mesh, Elements elements, const Progress &progress, QuadWatch *watch) {
    return PocketRefill(mesh, elements, watch).run(progress);
}

} // namespace forefront
