#include "ui/gl/face_raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace forefront {
namespace {

constexpr int kUnit = 8;      ///< distances to edges are stored in fractions of a pixel
constexpr int kDiagonal = 11; ///< of a pixel, in these units
constexpr int kReachPixels = 25;
constexpr int kReach = kReachPixels * kUnit; ///< greater distances are not told apart
constexpr std::uint16_t kBare = 0xffff;
constexpr double kCurveTolerance = 0.25; ///< pixels

/// Where a row meets an edge of a tinted face.
struct EdgeCrossing {
    int row = 0;
    double x = 0.0;
    std::uint32_t face = kNoIndex; ///< to the right

    friend bool operator<(const EdgeCrossing &a, const EdgeCrossing &b) {
        return a.row != b.row ? a.row < b.row : a.x < b.x;
    }
};

/// A picture of faces, row by row from the bottom.
class FacePicture {
  public:
    FacePicture(const FaceMap &map, std::span<const FaceTint> tints, const Camera &camera, double rimWidth)
        : map_(map), tints_(tints), camera_(camera), width_(static_cast<int>(camera.viewport.width)),
          height_(static_cast<int>(camera.viewport.height)), rim_(std::clamp(rimWidth, 1.0, 24.0)) {
        const auto size = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
        pixels_.resize(size);
        face_.assign(size, kBare);
        distance_.assign(size, 0);
        cover_.assign(size, 0);
    }

    std::vector<Colour> draw() {
        cross();
        std::sort(crossings_.begin(), crossings_.end());
        for (std::size_t k = 0; k + 1 < crossings_.size(); ++k) {
            const EdgeCrossing &from = crossings_[k], &to = crossings_[k + 1];
            if (from.row == to.row && from.face != kNoIndex && tints_[from.face].visible()) {
                fill(from.row, from.x, to.x, static_cast<std::uint16_t>(from.face));
            }
        }
        spreadDistances();
        paint();
        return std::move(pixels_);
    }

  private:
    std::size_t at(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
    }
    Vec2 toLocal(Vec2 p) const {
        return {(p.x - camera_.centre.x) * camera_.zoom + 0.5 * width_,
                (p.y - camera_.centre.y) * camera_.zoom + 0.5 * height_};
    }

    /// Finds where the rows meet the edges of tinted faces.
    void cross() {
        const auto tinted = [&](std::uint32_t face) { return face != kNoIndex && tints_[face].visible(); };
        const Box2 visible = camera_.visible();
        const Box2 around = visible.grown(visible.diagonal());
        for (const MappedEdge &edge : map_.edges()) {
            if (!tinted(edge.left) && !tinted(edge.right)) {
                continue;
            }
            Vec2 from = edge.a;
            if (edge.deviation * camera_.zoom > kCurveTolerance) {
                const Curve &curve = *map_.curveOf(edge);
                const std::vector<double> cuts =
                    curve.flattenWithin(around, kCurveTolerance / camera_.zoom, edge.stretch.t0, edge.stretch.t1);
                for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
                    const Vec2 to = curve.point(cuts[k]);
                    crossPiece(from, to, edge);
                    from = to;
                }
            }
            crossPiece(from, edge.b, edge);
        }
    }

    void crossPiece(Vec2 a, Vec2 b, const MappedEdge &edge) {
        Vec2 p = toLocal(a), q = toLocal(b);
        std::uint32_t right = edge.right;
        if (p.y > q.y) {
            std::swap(p, q);
            right = edge.left;
        }
        // Rows whose middle y + 0.5 lies in [p.y, q.y).
        const auto rowFrom = [&](double y) {
            return static_cast<int>(std::min(static_cast<double>(height_), std::max(0.0, std::ceil(y - 0.5))));
        };
        const int end = rowFrom(q.y);
        for (int row = rowFrom(p.y); row < end; ++row) {
            const double x = p.x + (row + 0.5 - p.y) / (q.y - p.y) * (q.x - p.x);
            crossings_.push_back({row, x, right});
        }
    }

    /// Fills a part of a row, and notes how far each pixel is from its ends.
    void fill(int row, double from, double to, std::uint16_t face) {
        const double low = std::clamp(from, 0.0, static_cast<double>(width_)),
                     high = std::clamp(to, 0.0, static_cast<double>(width_));
        if (!(low < high)) {
            return;
        }
        const int first = static_cast<int>(low), last = std::min(static_cast<int>(high), width_ - 1);
        const auto begin = static_cast<std::ptrdiff_t>(at(row, first)), count = std::ptrdiff_t{last - first + 1};
        std::fill_n(face_.begin() + begin, count, face);
        std::fill_n(distance_.begin() + begin, count, static_cast<std::int16_t>(kReach));
        std::fill_n(cover_.begin() + begin, count, std::uint8_t{255});
        const auto covered = [](double part) { return static_cast<std::uint8_t>(255.0 * std::clamp(part, 0.0, 1.0)); };
        cover_[at(row, last)] = covered(high - last);
        cover_[at(row, first)] = first == last ? covered(high - low) : covered(first + 1 - low);
        const auto reach = [&](int k, double pixels) {
            std::int16_t &distance = distance_[at(row, k)];
            distance = static_cast<std::int16_t>(std::clamp(kUnit * pixels, 0.0, static_cast<double>(distance)));
        };
        for (int k = first; k <= last && k - from < kReachPixels; ++k) {
            reach(k, k + 0.5 - from);
        }
        for (int k = last; k >= first && to - k < kReachPixels; --k) {
            reach(k, to - k - 0.5);
        }
    }

    /// Carries the distances, which are exact along rows, from row to row, also diagonally.
    void spreadDistances() {
        for (int row = 1; row < height_; ++row) {
            spread(row, row - 1);
        }
        for (int row = height_ - 2; row >= 0; --row) {
            spread(row, row + 1);
        }
    }
    void spread(int row, int before) {
        spread(at(row, 0), at(before, 0), 0, std::min(1, width_ - 1));
        const std::size_t here = at(row, 0), other = at(before, 0);
        const std::uint16_t *const face = face_.data() + here, *const beside = face_.data() + other;
        std::int16_t *const distance = distance_.data() + here;
        const std::int16_t *const from = distance_.data() + other;
        for (int k = 1; k < width_ - 1; ++k) { // without branches, so that several pixels are done at once
            const auto step = [&](int side, std::int16_t length) {
                const auto along = static_cast<std::int16_t>(from[side] + length);
                return beside[side] == face[k] ? along : static_cast<std::int16_t>(length / 2);
            };
            const std::int16_t straight = std::min(distance[k], step(k, kUnit));
            distance[k] = std::min(straight, std::min(step(k - 1, kDiagonal), step(k + 1, kDiagonal)));
        }
        if (width_ > 1) {
            spread(here, other, width_ - 1, width_ - 2);
        }
    }
    /// The same at an end of a row, which has one pixel beside it.
    void spread(std::size_t here, std::size_t other, int end, int inner) {
        const std::size_t pixel = here + static_cast<std::size_t>(end);
        for (const int side : {end, inner}) {
            const std::size_t beside = other + static_cast<std::size_t>(side);
            const std::int16_t length = side == end ? kUnit : kDiagonal;
            const int along = face_[beside] == face_[pixel] ? distance_[beside] + length : length / 2;
            distance_[pixel] = static_cast<std::int16_t>(std::min<int>(distance_[pixel], along));
        }
    }

    void paint() {
        constexpr std::size_t kDistances = kReach + 1;
        std::array<double, kDistances> strength{}; // of the rim, by the distance
        for (std::size_t k = 0; k < kReach; ++k) {
            const double fade = std::max(0.0, 1.0 - static_cast<double>(k) / kUnit / rim_);
            strength[k] = fade * fade;
        }
        const auto colourAt = [&](const FaceTint &tint, std::size_t distance, double cover) {
            const double opacity = cover * std::min(1.0, tint.fill + tint.rim * strength[distance]);
            return Colour::rounded(opacity * glm::dvec4(tint.colour.r, tint.colour.g, tint.colour.b, 255.0));
        };
        std::vector<std::array<Colour, kDistances>>
            colours; // of pixels that one face covers, for each face that is seen
        std::vector<std::uint32_t> place(tints_.size(), kNoIndex); // in `colours`
        for (std::size_t k = 0; k < pixels_.size(); ++k) {
            if (face_[k] == kBare) {
                continue;
            }
            const FaceTint &tint = tints_[face_[k]];
            const auto distance = static_cast<std::size_t>(distance_[k]);
            if (cover_[k] < 255) {
                pixels_[k] = colourAt(tint, distance, cover_[k] / 255.0);
                continue;
            }
            std::uint32_t &known = place[face_[k]];
            if (known == kNoIndex) {
                known = static_cast<std::uint32_t>(colours.size());
                colours.emplace_back();
                for (std::size_t d = 0; d < kDistances; ++d) {
                    colours.back()[d] = colourAt(tint, d, 1.0);
                }
            }
            pixels_[k] = colours[known][distance];
        }
    }

    const FaceMap &map_;
    std::span<const FaceTint> tints_;
    const Camera &camera_;
    int width_, height_;
    double rim_;
    std::vector<EdgeCrossing> crossings_;
    std::vector<Colour> pixels_;
    std::vector<std::uint16_t> face_;    ///< kBare: none that is tinted
    std::vector<std::int16_t> distance_; ///< to the nearest edge of the face, in units of kUnit
    std::vector<std::uint8_t> cover_;    ///< part of the pixel that the face covers
};

} // namespace

std::vector<Colour> rasteriseFaces(const FaceMap &map, std::span<const FaceTint> tints, const Camera &camera,
                                   double rimWidth) {
    return FacePicture(map, tints, camera, rimWidth).draw();
}

} // namespace forefront
