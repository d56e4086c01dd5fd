#include "core/engine/boundary/estimate.hpp"

#include "core/engine/boundary/coverage_cell.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <queue>
#include <vector>

namespace forefront {

namespace {

constexpr double kFirstCells = 400.0;
constexpr std::size_t kMaxCells = 4000;
constexpr std::size_t kPiecesProbed = 4;
constexpr double kTolerance = 0.03;
constexpr double kMaxElements = 1e18;

/// Computes the mean of (ρ₀/ρ)² over a domain by cells that are quartered where this reduces the error most. Works in
/// the unit square, on which the box of the domain (a little larger, so that nothing lines up) is mapped.
class MeanDensity {
  public:
    MeanDensity(const DiscreteDomain &domain, const SpacingField &spacing, double rhoUnit)
        : spacing_(spacing), rhoUnit_(rhoUnit) {
        const Box2 box = domain.bounds();
        low_ = box.min - 0.00317 * box.size();
        size_ = 1.00731 * box.size();
        for (const DiscreteSegment &s : domain.segments) {
            const bool left = s.leftRegion != kOutside, right = s.rightRegion != kOutside;
            if (left != right) {
                const Vec2 a = toUnit(domain.nodes[s.a]), b = toUnit(domain.nodes[s.b]);
                pieces_.push_back(left ? BoundaryPiece{a, b} : BoundaryPiece{b, a});
            }
        }
    }

    double value() {
        layOutCells();
        while (!queue_.empty() && error_ > kTolerance * sum_ && cells_.size() + 4 <= kMaxCells) {
            const std::uint32_t worst = queue_.top().cell;
            queue_.pop();
            const Cell parent = std::move(cells_[worst]);
            sum_ -= parent.value;
            error_ -= parent.error;
            area_ -= parent.covered;
            std::array<CoverageCell, 4> quarters = parent.coverage.quarters(pieces_);
            for (unsigned k = 0; k < 4; ++k) {
                add(std::move(quarters[k]), parent.densities[k]);
            }
        }
        return area_ > 0.0 ? sum_ / area_ : 1.0;
    }

  private:
    struct Cell {
        CoverageCell coverage;
        std::array<double, 4> densities{}; ///< in the middle of the quarters
        double covered = 0.0;
        double value = 0.0; ///< covered area times density
        double error = 0.0;
    };
    struct Candidate {
        double error;
        std::uint32_t cell;
        bool operator<(const Candidate &other) const {
            return error != other.error ? error < other.error : cell > other.cell;
        }
    };

    Vec2 toUnit(Vec2 p) const { return {(p.x - low_.x) / size_.x, (p.y - low_.y) / size_.y}; }

    Vec2 fromUnit(Vec2 p) const { return {low_.x + p.x * size_.x, low_.y + p.y * size_.y}; }

    double densityOf(double rho) const {
        const double ratio = rhoUnit_ / rho;
        return std::min(ratio * ratio, 1e100);
    }
    double density(Vec2 unit) const { return densityOf(spacing_.at(fromUnit(unit))); }

    /// Lays out a lattice of cells as square as the box allows.
    void layOutCells() {
        const double columns = std::clamp(std::round(std::sqrt(kFirstCells * size_.x / size_.y)), 1.0, kFirstCells);
        columns_ = static_cast<std::size_t>(columns);
        rows_ = static_cast<std::size_t>(std::max(1.0, std::round(kFirstCells / columns)));
        std::vector<CoverageCell> lattice(columns_ * rows_);
        for (std::size_t i = 0; i < lattice.size(); ++i) {
            lattice[i].box = latticeBox(i % columns_, i / columns_);
        }
        distributePieces(lattice);
        markCentres(lattice);
        for (CoverageCell &cell : lattice) {
            const Vec2 centre = cell.box.centre();
            if (cell.centreInside || !cell.pieces.empty()) {
                add(std::move(cell), density(centre));
            }
        }
    }

    Box2 latticeBox(std::size_t column, std::size_t row) const {
        const auto part = [](std::size_t i, std::size_t n) { return static_cast<double>(i) / static_cast<double>(n); };
        return {{part(column, columns_), part(row, rows_)}, {part(column + 1, columns_), part(row + 1, rows_)}};
    }

    void distributePieces(std::vector<CoverageCell> &lattice) const {
        const auto index = [](double at, std::size_t n) {
            return std::min(n - 1, static_cast<std::size_t>(std::clamp(at, 0.0, 1.0) * static_cast<double>(n)));
        };
        for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
            const Box2 box = boxOf(pieces_[i].a, pieces_[i].b);
            const std::size_t column0 = index(box.min.x, columns_), column1 = index(box.max.x, columns_);
            const std::size_t row0 = index(box.min.y, rows_), row1 = index(box.max.y, rows_);
            for (std::size_t row = row0; row <= row1; ++row) {
                for (std::size_t column = column0; column <= column1; ++column) {
                    CoverageCell &cell = lattice[row * columns_ + column];
                    if ((row0 == row1 && column0 == column1) || meetsBox(pieces_[i], cell.box)) {
                        cell.pieces.push_back(i);
                    }
                }
            }
        }
    }

    /// Decides whether centres are inside, from the pieces to their left.
    void markCentres(std::vector<CoverageCell> &lattice) const {
        std::vector<std::uint8_t> odd(lattice.size(), 0);
        for (const BoundaryPiece &piece : pieces_) {
            const double low = std::min(piece.a.y, piece.b.y), high = std::max(piece.a.y, piece.b.y);
            const auto rowAt = [&](double y) { // the first whose centre is not below y
                return static_cast<std::size_t>(std::max(0.0, std::ceil(y * static_cast<double>(rows_) - 0.5)));
            };
            for (std::size_t row = rowAt(low); row < rows_ && row < rowAt(high); ++row) {
                const double y = latticeBox(0, row).centre().y;
                const double x = piece.a.x + (piece.b.x - piece.a.x) * ((y - piece.a.y) / (piece.b.y - piece.a.y));
                const double column = std::ceil(x * static_cast<double>(columns_) - 0.5);
                if (column < static_cast<double>(columns_)) {
                    odd[row * columns_ + static_cast<std::size_t>(std::max(0.0, column))] ^= 1U;
                }
            }
        }
        for (std::size_t i = 0; i < lattice.size(); ++i) {
            lattice[i].centreInside = (odd[i] != 0) != (i % columns_ != 0 && lattice[i - 1].centreInside);
        }
    }

    /// Evaluates the spacing in the middle of the quarters of a cell, then along the boundary in it.
    void sample(const CoverageCell &coverage) {
        const Vec2 low = coverage.box.min, size = coverage.box.size();
        places_.clear();
        for (unsigned k = 0; k < 4; ++k) {
            places_.push_back(
                fromUnit({low.x + (k % 2 != 0 ? 0.75 : 0.25) * size.x, low.y + (k / 2 != 0 ? 0.75 : 0.25) * size.y}));
        }
        // Where the boundary cuts the cell, the part inside may be anywhere in it. Sample along the boundary, where the
        // spacing tends to be smallest.
        BoundaryPiece last;
        for (std::size_t i = 0; i < std::min(coverage.pieces.size(), kPiecesProbed); ++i) {
            const BoundaryPiece part = partWithin(pieces_[coverage.pieces[i]], coverage.box);
            for (const Vec2 end : {part.a, part.b}) {
                if (i == 0 || (end != last.a && end != last.b)) { // neighbours share it
                    places_.push_back(fromUnit(end));
                }
            }
            last = part;
        }
        rho_.resize(places_.size());
        spacing_.atMany(places_, rho_);
    }

    void add(CoverageCell coverage, double centreDensity) {
        const bool cut = !coverage.pieces.empty();
        const Vec2 size = coverage.box.size();
        Cell cell;
        cell.covered = cut ? coverage.coveredArea(pieces_) : coverage.centreInside ? size.x * size.y : 0.0;
        if (cell.covered <= 0.0) {
            return;
        }
        sample(coverage);
        double mean = 0.0, minimum = centreDensity, maximum = centreDensity;
        for (std::size_t k = 0; k < rho_.size(); ++k) {
            const double there = densityOf(rho_[k]);
            if (k < 4) {
                cell.densities[k] = there;
                mean += 0.25 * there;
            }
            minimum = std::min(minimum, there);
            maximum = std::max(maximum, there);
        }
        cell.value = cell.covered * mean;
        cell.error = cell.covered * std::max(std::fabs(mean - centreDensity), cut ? 0.3 * (maximum - minimum) : 0.0);
        cell.coverage = std::move(coverage);
        sum_ += cell.value;
        error_ += cell.error;
        area_ += cell.covered;
        if (cell.error > 0.0) {
            queue_.push({cell.error, static_cast<std::uint32_t>(cells_.size())});
            cells_.push_back(std::move(cell));
        }
    }

    const SpacingField &spacing_;
    double rhoUnit_;
    Vec2 low_, size_;
    std::vector<BoundaryPiece> pieces_;
    std::size_t columns_ = 1, rows_ = 1;
    std::vector<Vec2> places_; // sample points of a cell
    std::vector<double> rho_;  // spacing there
    std::vector<Cell> cells_;  // cells that may be quartered
    std::priority_queue<Candidate> queue_;
    double sum_ = 0.0, error_ = 0.0, area_ = 0.0;
};

} // namespace

double estimateElements(const DiscreteDomain &domain, const SpacingField &spacing) {
    const Vec2 size = domain.bounds().size();
    if (!(size.x > 0.0 && size.y > 0.0)) {
        return 1.0;
    }
    const double rhoUnit = spacing.at(domain.bounds().centre());
    const double mean = spacing.minimum() < spacing.maximum() ? MeanDensity(domain, spacing, rhoUnit).value() : 1.0;
    const double side = std::sqrt(domain.area()) / rhoUnit;
    const double elements = mean * side * side * 4.0 / std::numbers::sqrt3;
    return elements < kMaxElements ? std::max(1.0, elements) : kMaxElements;
}

} // namespace forefront
