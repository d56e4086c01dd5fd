#include "core/domain/estimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace forefront {

namespace {

/// Which part of the bounding box is domain, as a picture of kPixels² pixels.
class Raster {
  public:
    static constexpr int kPixels = 256;

    explicit Raster(const DiscreteDomain &domain) : box_(domain.bounds()), inside_(kPixels * kPixels, 0) {
        std::vector<std::vector<double>> crossings(kPixels);
        const Vec2 size = box_.size();
        for (const DiscreteSegment &s : domain.segments) {
            if ((s.leftRegion == kOutside) == (s.rightRegion == kOutside)) {
                continue;
            }
            const Vec2 a = domain.nodes[s.a];
            const Vec2 b = domain.nodes[s.b];
            const double low = (std::min(a.y, b.y) - box_.min.y) / size.y * kPixels - 0.5;
            const double high = (std::max(a.y, b.y) - box_.min.y) / size.y * kPixels - 0.5;
            for (int row = std::max(0, static_cast<int>(std::ceil(low))); row < kPixels && row < high; ++row) {
                const double y = box_.min.y + (row + 0.5) / kPixels * size.y;
                const double x = a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
                crossings[static_cast<std::size_t>(row)].push_back((x - box_.min.x) / size.x * kPixels - 0.5);
            }
        }
        for (int row = 0; row < kPixels; ++row) {
            fillRow(row, crossings[static_cast<std::size_t>(row)]);
        }
    }

    /// Part of a box (inside the bounding box) that is domain.
    double fraction(const Box2 &cell) const {
        const Vec2 size = box_.size();
        const auto pixel = [](double t) { return std::clamp(static_cast<int>(t * kPixels), 0, kPixels - 1); };
        const int i0 = pixel((cell.min.x - box_.min.x) / size.x);
        const int i1 = std::max(i0, pixel((cell.max.x - box_.min.x) / size.x - 0.5 / kPixels));
        const int j0 = pixel((cell.min.y - box_.min.y) / size.y);
        const int j1 = std::max(j0, pixel((cell.max.y - box_.min.y) / size.y - 0.5 / kPixels));
        int count = 0;
        for (int j = j0; j <= j1; ++j) {
            for (int i = i0; i <= i1; ++i) {
                count += inside_[static_cast<std::size_t>(j * kPixels + i)];
            }
        }
        return static_cast<double>(count) / ((i1 - i0 + 1) * (j1 - j0 + 1));
    }

  private:
    void fillRow(int row, std::vector<double> &crossings) {
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
            const int from = std::max(0, static_cast<int>(std::ceil(crossings[k])));
            for (int i = from; i < kPixels && i < crossings[k + 1]; ++i) {
                inside_[static_cast<std::size_t>(row * kPixels + i)] = 1;
            }
        }
    }

    Box2 box_;
    std::vector<std::uint8_t> inside_;
};

/// A box with the mean of 1/ρ² over it, from its centre and from those of its quarters.
struct Cell {
    Box2 box;
    double coarse = 0.0;
    double fine = 0.0;
};

std::array<Box2, 4> quarters(const Box2 &box) {
    const Vec2 c = box.centre();
    return {Box2{box.min, c}, Box2{{c.x, box.min.y}, {box.max.x, c.y}}, Box2{{box.min.x, c.y}, {c.x, box.max.y}},
            Box2{c, box.max}};
}

Cell sample(const Box2 &box, const SpacingField &spacing) {
    const auto density = [&](Vec2 p) {
        const double rho = spacing.at(p);
        return 1.0 / (rho * rho);
    };
    Cell cell{box, density(box.centre()), 0.0};
    for (const Box2 &quarter : quarters(box)) {
        cell.fine += 0.25 * density(quarter.centre());
    }
    return cell;
}

constexpr int kFirstCells = 24;
constexpr std::size_t kMostCells = 40'000;

} // namespace

double estimateElements(const DiscreteDomain &domain, const SpacingField &spacing) {
    const Box2 box = domain.bounds();
    const Vec2 size = box.size();
    if (!(size.x > 0.0 && size.y > 0.0)) {
        return 1.0;
    }
    const Raster raster(domain);
    std::vector<Cell> cells;
    for (int j = 0; j < kFirstCells; ++j) {
        for (int i = 0; i < kFirstCells; ++i) {
            const Vec2 low{box.min.x + size.x * i / kFirstCells, box.min.y + size.y * j / kFirstCells};
            cells.push_back(sample({low, low + (1.0 / kFirstCells) * size}, spacing));
        }
    }
    double integral = 0.0;
    double area = 0.0;
    std::size_t used = cells.size();
    const auto settle = [&](const Cell &cell) {
        const double inside = raster.fraction(cell.box) * cell.box.size().x * cell.box.size().y;
        integral += inside * cell.fine;
        area += inside;
    };
    // Level by level: split where the quarters disagree with the whole, as long as there are cells to spend.
    while (!cells.empty()) {
        std::vector<Cell> next;
        for (const Cell &cell : cells) {
            if (std::abs(cell.fine - cell.coarse) > 0.1 * cell.fine && used + 4 <= kMostCells) {
                used += 4;
                for (const Box2 &quarter : quarters(cell.box)) {
                    next.push_back(sample(quarter, spacing));
                }
            } else {
                settle(cell);
            }
        }
        cells.swap(next);
    }
    // A domain thinner than a pixel escapes the picture; its area does not.
    const double mean = area > 0.0 ? integral / area : 1.0 / (spacing.least() * spacing.least());
    return std::max(1.0, mean * domain.area() * 4.0 / std::numbers::sqrt3);
}

} // namespace forefront
