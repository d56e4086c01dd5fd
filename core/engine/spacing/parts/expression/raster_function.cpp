#include "core/engine/spacing/parts/expression/raster_function.hpp"

#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/inside_test.hpp"
#include "core/engine/spacing/parts/expression/expression_program.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace forefront {
namespace {

constexpr std::uint32_t kUnfilled = std::numeric_limits<std::uint32_t>::max();

/// Calls visit(cell) for the up to eight cells around a cell.
template <class Visit>
void forNeighbours(const Raster &raster, std::size_t cell, Visit &&visit) {
    const std::size_t column = cell % raster.columns, row = cell / raster.columns;
    for (std::size_t k = row > 0 ? row - 1 : 0; k <= std::min(row + 1, raster.rows - 1); ++k) {
        for (std::size_t i = column > 0 ? column - 1 : 0; i <= std::min(column + 1, raster.columns - 1); ++i) {
            if (i != column || k != row) {
                visit(k * raster.columns + i);
            }
        }
    }
}

/// Returns the missing cells beside a ring, each once.
std::vector<std::size_t> nextRing(const Raster &raster, const std::vector<std::size_t> &ring,
                                  const std::vector<std::uint32_t> &rings) {
    std::vector<std::size_t> next;
    for (const std::size_t cell : ring) {
        forNeighbours(raster, cell, [&](std::size_t neighbour) {
            if (rings[neighbour] == kUnfilled) {
                next.push_back(neighbour);
            }
        });
    }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    return next;
}

double meanAround(const Raster &raster, std::size_t cell, const std::vector<std::uint32_t> &rings) {
    double sum = 0.0, count = 0.0;
    forNeighbours(raster, cell, [&](std::size_t neighbour) {
        if (rings[neighbour] != kUnfilled) {
            sum += raster.values[neighbour];
            count += 1.0;
        }
    });
    return sum / count;
}

/// The cells that count for places between two coordinates, along one axis.
struct CellSpan {
    std::size_t first = 0, last = 0;
    bool flat = false; ///< some places are in the outer halves of outer cells, or beyond
};
CellSpan cellsBetween(double low, double high, double origin, double pitch, std::size_t count) {
    const double end = static_cast<double>(count - 1);
    const double from = (low - origin) / pitch, to = (high - origin) / pitch;
    const auto whole = [end](double place) { return static_cast<std::size_t>(std::clamp(place, 0.0, end)); };
    // One cell more on either side covers the rounding of the places.
    return {whole(std::floor(from) - 1.0), whole(std::ceil(to) + 1.0), from <= 0.5 || to >= end - 0.5};
}

Diagnostics gapAt(const std::string &name, Vec2 place) {
    Diagnostics faults =
        error("raster-gap",
              "the raster '" + name + "' has no value in or near a part of the domain; expected values everywhere, " +
                  std::to_string(kMaxRasterReach) + " cells from the domain at most",
              "give a raster that covers the whole domain");
    faults.front().at = place;
    return faults;
}

} // namespace

FilledRaster::FilledRaster(const Raster &given, std::string rasterName)
    : raster(given), rings(given.values.size(), kUnfilled), name(std::move(rasterName)) {
    std::vector<std::size_t> ring;
    for (std::size_t cell = 0; cell < raster.values.size(); ++cell) {
        if (std::isfinite(raster.values[cell])) {
            rings[cell] = 0;
            ring.push_back(cell);
        }
    }
    for (std::uint32_t distance = 1; !ring.empty(); ++distance) {
        ring = nextRing(raster, ring, rings);
        for (const std::size_t cell : ring) { // from the earlier rings alone, so that the order does not matter
            raster.values[cell] = meanAround(raster, cell, rings);
        }
        for (const std::size_t cell : ring) {
            rings[cell] = distance;
        }
    }
}

Box2 FilledRaster::box() const {
    const Vec2 half = 0.5 * raster.pitch;
    const Vec2 last{raster.origin.x + raster.pitch.x * static_cast<double>(raster.columns - 1),
                    raster.origin.y + raster.pitch.y * static_cast<double>(raster.rows - 1)};
    return {raster.origin - half, last + half};
}

Vec2 FilledRaster::clamped(Vec2 p) const {
    // To the centres of the outer cells: beyond them the value is the same, and no rounding leads outside.
    const Vec2 half = 0.5 * raster.pitch;
    const Box2 cells = box();
    return {std::clamp(p.x, cells.min.x + half.x, std::max(cells.min.x + half.x, cells.max.x - half.x)),
            std::clamp(p.y, cells.min.y + half.y, std::max(cells.min.y + half.y, cells.max.y - half.y))};
}

double RasterFunction::at(Vec2 p) const {
    const Vec2 place = filled_->clamped(p);
    switch (value_) {
    case RasterValue::AlongX:
        return place.x == p.x ? filled_->raster.gradient(place).x : 0.0;
    case RasterValue::AlongY:
        return place.y == p.y ? filled_->raster.gradient(place).y : 0.0;
    case RasterValue::Value:
        break;
    }
    return filled_->raster.at(place);
}

ValueRange RasterFunction::range(const Box2 &box) const {
    const Raster &raster = filled_->raster;
    if (!std::isfinite(box.size().x) || !std::isfinite(box.size().y)) {
        const double infinite = std::numeric_limits<double>::infinity();
        return {-infinite, infinite, true};
    }
    const CellSpan x = cellsBetween(box.min.x, box.max.x, raster.origin.x, raster.pitch.x, raster.columns);
    const CellSpan y = cellsBetween(box.min.y, box.max.y, raster.origin.y, raster.pitch.y, raster.rows);
    ValueRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), false};
    const auto include = [&range](double value) {
        range.low = std::min(range.low, value);
        range.high = std::max(range.high, value);
    };
    const std::size_t stepX = value_ == RasterValue::AlongX ? 1 : 0, stepY = value_ == RasterValue::AlongY ? 1 : 0;
    const double length = stepX != 0 ? raster.pitch.x : raster.pitch.y;
    for (std::size_t row = y.first; row + stepY <= y.last; ++row) {
        for (std::size_t column = x.first; column + stepX <= x.last; ++column) {
            const double value = raster.values[row * raster.columns + column];
            include(value_ == RasterValue::Value
                        ? value
                        : (raster.values[(row + stepY) * raster.columns + column + stepX] - value) / length);
        }
    }
    if ((stepX != 0 && x.flat) || (stepY != 0 && y.flat)) {
        include(0.0);
    }
    const double margin = 1e-12 * std::max(std::fabs(range.low), std::fabs(range.high)); // of rounding
    return {range.low - margin, range.high + margin, !(range.low <= range.high)};
}

Diagnostics RasterFunction::gaps(const Domain &domain, const InsideTest *inside) const {
    const Raster &raster = filled_->raster;
    const Vec2 reach = static_cast<double>(kMaxRasterReach) * raster.pitch;
    const Box2 box = filled_->box();
    const Box2 reached{box.min - reach, box.max + reach};
    for (const DomainSegment &segment : domain.segments) {
        // The box is convex: it holds the domain if it holds the ends of its segments.
        for (const std::uint32_t node : {segment.a, segment.b}) {
            if (node < domain.nodes.size() && !reached.contains(domain.nodes[node])) {
                return gapAt(filled_->name, domain.nodes[node]);
            }
        }
    }
    const Box2 bounds = domain.bounds();
    for (std::size_t cell = 0; inside != nullptr && cell < raster.values.size(); ++cell) {
        if (filled_->rings[cell] <= kMaxRasterReach) {
            continue;
        }
        const Vec2 centre{raster.origin.x + raster.pitch.x * static_cast<double>(cell % raster.columns),
                          raster.origin.y + raster.pitch.y * static_cast<double>(cell / raster.columns)};
        const Box2 square{centre - 0.5 * raster.pitch, centre + 0.5 * raster.pitch};
        if (square.overlaps(bounds) && inside->meets(square)) {
            return gapAt(filled_->name, centre);
        }
    }
    return {};
}

} // namespace forefront
