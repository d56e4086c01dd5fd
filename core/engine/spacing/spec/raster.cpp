#include "core/engine/spacing/spec/raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace forefront {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Two neighbouring rows or columns around a coordinate.
struct Between {
    std::size_t low = 0, high = 0;
    double part = 0.0;   ///< from the lower one to the upper one, 0 to 1
    bool inside = false; ///< within the cells
    bool flat = false;   ///< in the outer half of an outer cell, where values do not change
};

Between between(double coordinate, double origin, double pitch, std::size_t count) {
    Between result;
    const double place = (coordinate - origin) / pitch;
    const double last = static_cast<double>(count - 1);
    result.inside = place >= -0.5 && place <= last + 0.5;
    if (!result.inside) {
        return result;
    }
    const double within = std::clamp(place, 0.0, last);
    result.flat = place < 0.0 || place > last || count == 1;
    result.low = static_cast<std::size_t>(std::min(std::floor(within), std::max(last - 1.0, 0.0)));
    result.high = std::min(result.low + 1, count - 1);
    result.part = within - static_cast<double>(result.low);
    return result;
}

/// Returns the mean of two values with weights; one without weight may be missing.
double mix(double a, double b, double part) {
    return part == 0.0 ? a : part == 1.0 ? b : a + part * (b - a);
}

} // namespace

bool operator==(const Raster &a, const Raster &b) {
    return a.origin == b.origin && a.pitch == b.pitch && a.columns == b.columns && a.rows == b.rows &&
           std::equal(a.values.begin(), a.values.end(), b.values.begin(), b.values.end(),
                      [](double v, double w) { return v == w || (std::isnan(v) && std::isnan(w)); });
}

bool sameRasters(const RasterMap &a, const RasterMap &b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto &one, const auto &other) {
        return one.first == other.first && (one.second == other.second || *one.second == *other.second);
    });
}

double Raster::at(Vec2 place) const {
    const Between x = between(place.x, origin.x, pitch.x, columns), y = between(place.y, origin.y, pitch.y, rows);
    if (!x.inside || !y.inside) {
        return kNone;
    }
    const auto row = [&](std::size_t k) {
        return mix(values[k * columns + x.low], values[k * columns + x.high], x.part);
    };
    return mix(row(y.low), row(y.high), y.part);
}

Vec2 Raster::gradient(Vec2 place) const {
    const Between x = between(place.x, origin.x, pitch.x, columns), y = between(place.y, origin.y, pitch.y, rows);
    if (!x.inside || !y.inside) {
        return {kNone, kNone};
    }
    const auto value = [&](std::size_t column, std::size_t row) { return values[row * columns + column]; };
    const double left = mix(value(x.low, y.low), value(x.low, y.high), y.part);
    const double right = mix(value(x.high, y.low), value(x.high, y.high), y.part);
    const double below = mix(value(x.low, y.low), value(x.high, y.low), x.part);
    const double above = mix(value(x.low, y.high), value(x.high, y.high), x.part);
    return {x.flat ? 0.0 * at(place) : (right - left) / pitch.x, y.flat ? 0.0 * at(place) : (above - below) / pitch.y};
}

} // namespace forefront
