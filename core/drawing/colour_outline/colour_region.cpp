#include "core/drawing/colour_outline/colour_region.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace forefront {
namespace {

/// Coordinates in CIELAB.
using Lab = std::array<double, 3>;
using Rgb = std::array<std::uint8_t, 3>;

double linearLight(double channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double labCurve(double t) {
    constexpr double kBend = 216.0 / 24389.0, kSlope = 24389.0 / 27.0;
    return t > kBend ? std::cbrt(t) : (kSlope * t + 16.0) / 116.0;
}

/// Converts colours of sRGB (IEC 61966-2-1) to CIELAB (CIE 15), white D65.
class LabTable {
  public:
    LabTable() {
        for (std::size_t k = 0; k < light_.size(); ++k) {
            light_[k] = linearLight(static_cast<double>(k));
        }
    }
    Lab operator()(const Rgb &colour) const {
        const double r = light_[colour[0]], g = light_[colour[1]], b = light_[colour[2]];
        const double x = labCurve((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
        const double y = labCurve(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
        const double z = labCurve((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
        return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
    }

  private:
    std::array<double, 256> light_{};
};

double distanceOf(const Lab &a, const Lab &b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Tells which pixels of a picture are close to a colour; each colour is compared once.
class SimilarColours {
  public:
    SimilarColours(const PixelView &picture, PixelPlace seed, double tolerance)
        : picture_(picture), tolerance_(tolerance), known_(std::size_t{1} << 24U, kUnknown) {
        const Lab exact = lab_(colourAt(seed.column, seed.row));
        Lab sum{};
        double weight = 0.0;
        for (int row = std::max(0, seed.row - 2); row <= std::min(picture.rows - 1, seed.row + 2); ++row) {
            for (int column = std::max(0, seed.column - 2); column <= std::min(picture.columns - 1, seed.column + 2);
                 ++column) {
                const Lab other = lab_(colourAt(column, row));
                if (distanceOf(exact, other) <= tolerance) {
                    for (std::size_t k = 0; k < sum.size(); ++k) {
                        sum[k] += other[k];
                    }
                    weight += 1.0;
                }
            }
        }
        for (std::size_t k = 0; k < sum.size(); ++k) {
            mean_[k] = sum[k] / weight;
        }
        // Its neighbours must not leave the seed itself outside.
        known_[keyOf(colourAt(seed.column, seed.row))] = kInside;
    }

    bool operator()(int column, int row) {
        const Rgb colour = colourAt(column, row);
        std::uint8_t &known = known_[keyOf(colour)];
        if (known == kUnknown) {
            known = distanceOf(lab_(colour), mean_) <= tolerance_ ? kInside : kOutside;
        }
        return known == kInside;
    }

  private:
    static constexpr std::uint8_t kUnknown = 0, kInside = 1, kOutside = 2;

    static std::size_t keyOf(const Rgb &colour) {
        return (static_cast<std::size_t>(colour[0]) << 16U) | (static_cast<std::size_t>(colour[1]) << 8U) | colour[2];
    }
    Rgb colourAt(int column, int row) const {
        const std::uint8_t *const pixel =
            picture_.rgba.data() + 4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(picture_.columns) +
                                        static_cast<std::size_t>(column));
        Rgb colour{pixel[0], pixel[1], pixel[2]};
        if (const unsigned alpha = pixel[3]; alpha < 255) {
            for (std::uint8_t &channel : colour) {
                channel = static_cast<std::uint8_t>((channel * alpha + 255U * (255U - alpha) + 127U) / 255U);
            }
        }
        return colour;
    }

    const PixelView &picture_;
    double tolerance_;
    LabTable lab_;
    Lab mean_{};
    std::vector<std::uint8_t> known_; ///< per colour
};

} // namespace

ColourRegion floodByColour(const PixelView &picture, PixelPlace seed, double tolerance, const Progress &progress) {
    constexpr std::size_t kBetweenReports = 1U << 14U;
    SimilarColours similar(picture, seed, tolerance);
    ColourRegion region{picture.columns, picture.rows, {}, 0};
    const auto columns = static_cast<std::size_t>(picture.columns), rows = static_cast<std::size_t>(picture.rows);
    region.inside.assign(columns * rows, 0);
    const auto rowOf = [&](int row) { return region.inside.data() + static_cast<std::size_t>(row) * columns; };
    std::vector<PixelPlace> open{seed}; // pixels of rows that are not filled yet
    for (std::size_t step = 0; !open.empty(); ++step) {
        if (step % kBetweenReports == 0) {
            if (progress.cancelled()) {
                return {};
            }
            progress("finding the colour", static_cast<double>(region.count) / static_cast<double>(columns * rows));
        }
        const PixelPlace at = open.back();
        open.pop_back();
        std::uint8_t *const filled = rowOf(at.row);
        if (filled[at.column] != 0) {
            continue;
        }
        int first = at.column, last = at.column;
        while (first > 0 && filled[first - 1] == 0 && similar(first - 1, at.row)) {
            --first;
        }
        while (last + 1 < picture.columns && filled[last + 1] == 0 && similar(last + 1, at.row)) {
            ++last;
        }
        std::fill(filled + first, filled + last + 1, std::uint8_t{1});
        region.count += static_cast<std::size_t>(last - first + 1);
        for (const int row : {at.row - 1, at.row + 1}) {
            if (row < 0 || row >= picture.rows) {
                continue;
            }
            const std::uint8_t *const beside = rowOf(row);
            bool inRun = false;
            for (int column = first; column <= last; ++column) {
                const bool opens = beside[column] == 0 && similar(column, row);
                if (opens && !inRun) {
                    open.push_back({column, row});
                }
                inRun = opens;
            }
        }
    }
    return region;
}

} // namespace forefront
