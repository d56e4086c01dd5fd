#include "core/engine/spacing/parts/paint/painted_part.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace forefront {
namespace {

using Key = std::pair<std::int32_t, std::int32_t>;
constexpr std::int32_t kTileSpan = PaintedSpacing::kTileSpan;
constexpr std::int32_t kFarthestTile = 100'000'000; ///< keeps node numbers within 32 bits
constexpr double kMaxDirectory = 4'000'000.0;       ///< tiles

Diagnostics badPaint(std::string message, std::optional<Vec2> at = {}) {
    Diagnostics faults = error("bad-paint", std::move(message), "erase the paint, or paint again");
    faults.front().at = at;
    return faults;
}

std::optional<Diagnostics> faultOf(const PaintedSpacing &paint) {
    if (!isFinite(paint.origin) || !std::isfinite(paint.pitch) || paint.pitch <= 0.0) {
        return badPaint("invalid origin or pitch of the painted spacing; expected finite numbers, and a pitch above 0");
    }
    if (paint.tiles.size() > PaintedPart::kMaxTiles) {
        return badPaint("the painted spacing has " + std::to_string(paint.tiles.size()) + " tiles; expected at most " +
                        std::to_string(PaintedPart::kMaxTiles));
    }
    for (const auto &[key, tile] : paint.tiles) {
        if (std::abs(static_cast<double>(key.first)) > kFarthestTile ||
            std::abs(static_cast<double>(key.second)) > kFarthestTile) {
            return badPaint("a tile of the painted spacing is too far from its origin");
        }
        for (std::size_t n = 0; tile && n < tile->size(); ++n) {
            if (!((*tile)[n] >= 0.0F) || !std::isfinite((*tile)[n])) {
                const std::size_t column = n % kTileSpan, row = n / kTileSpan;
                const Vec2 node{static_cast<double>(key.first) * kTileSpan + static_cast<double>(column),
                                static_cast<double>(key.second) * kTileSpan + static_cast<double>(row)};
                return badPaint("invalid painted spacing; expected finite numbers above 0",
                                paint.origin + paint.pitch * node);
            }
        }
    }
    return std::nullopt;
}

/// The nodes (−1..16)² of a tile: its own and the nearest ones of its eight neighbours.
class TileSurroundings {
  public:
    TileSurroundings(const PaintedSpacing &paint, Key key, double minimum) {
        for (std::int32_t dj = -1; dj <= 1; ++dj) {
            for (std::int32_t di = -1; di <= 1; ++di) {
                const auto found = paint.tiles.find({key.first + di, key.second + dj});
                if (found != paint.tiles.end() && found->second) {
                    copy(*found->second, di, dj, static_cast<float>(minimum));
                }
            }
        }
    }
    /// Returns the value at a node; 0 if unpainted.
    float at(std::int32_t i, std::int32_t j) const {
        return values_[static_cast<std::size_t>((i + 1) + (j + 1) * kWidth)];
    }
    bool painted() const { return painted_; }

  private:
    static constexpr std::int32_t kWidth = kTileSpan + 2;

    void copy(const PaintedSpacing::Tile &tile, std::int32_t di, std::int32_t dj, float minimum) {
        const auto first = [](std::int32_t d) { return d < 0 ? -1 : d * kTileSpan; };
        const auto last = [](std::int32_t d) { return d < 0 ? -1 : (d == 0 ? kTileSpan - 1 : kTileSpan); };
        for (std::int32_t j = first(dj); j <= last(dj); ++j) {
            for (std::int32_t i = first(di); i <= last(di); ++i) {
                const float value =
                    tile[static_cast<std::size_t>((i - di * kTileSpan) + (j - dj * kTileSpan) * kTileSpan)];
                values_[static_cast<std::size_t>((i + 1) + (j + 1) * kWidth)] =
                    value > 0.0F ? std::max(value, minimum) : 0.0F;
                painted_ = painted_ || value > 0.0F;
            }
        }
    }

    std::array<float, static_cast<std::size_t>(kWidth *kWidth)> values_{};
    bool painted_ = false;
};

/// Returns the tiles with paint in or next to them.
std::set<Key> tilesTouched(const PaintedSpacing &paint) {
    std::set<Key> keys;
    for (const auto &[key, tile] : paint.tiles) {
        for (std::int32_t dj = -1; tile && dj <= 1; ++dj) {
            for (std::int32_t di = -1; di <= 1; ++di) {
                keys.insert({key.first + di, key.second + dj});
            }
        }
    }
    return keys;
}

/// Finds the places of one tile from which its spacing spreads.
class SiteFinder {
  public:
    SiteFinder(const TileSurroundings &nodes, Vec2 corner, double pitch, double gradation, SiteSet &sites)
        : nodes_(nodes), corner_(corner), pitch_(pitch), gradation_(gradation), sites_(sites) {}

    void run() {
        for (std::int32_t j = 0; j < kTileSpan; ++j) {
            addEdges({0, j}, {1, 0}, {0, -1}); // lower edges of the cells of row j
            addEdges({j, 0}, {0, 1}, {-1, 0}); // left edges of the cells of column j
            for (std::int32_t i = 0; i < kTileSpan; ++i) {
                addNode(i, j);
            }
        }
    }

  private:
    struct Step {
        std::int32_t i = 0;
        std::int32_t j = 0;
    };
    /// Returns the smallest value of the painted nodes of a partly painted cell; 0 if it is unpainted or fully painted.
    float partValue(std::int32_t i, std::int32_t j) const {
        float minimum = 0.0F;
        int painted = 0;
        for (const float value : {nodes_.at(i, j), nodes_.at(i + 1, j), nodes_.at(i, j + 1), nodes_.at(i + 1, j + 1)}) {
            if (value > 0.0F) {
                minimum = painted == 0 ? value : std::min(minimum, value);
                ++painted;
            }
        }
        return painted < 4 ? minimum : 0.0F;
    }
    bool unpainted(std::int32_t i, std::int32_t j) const {
        return nodes_.at(i, j) == 0.0F && nodes_.at(i + 1, j) == 0.0F && nodes_.at(i, j + 1) == 0.0F &&
               nodes_.at(i + 1, j + 1) == 0.0F;
    }
    /// Returns the minimum value just beyond an edge of a cell; infinity if unpainted.
    float beyond(Step cell, Step edge, Step along) const {
        if (unpainted(cell.i, cell.j)) {
            return std::numeric_limits<float>::infinity();
        }
        const float part = partValue(cell.i, cell.j);
        return part > 0.0F ? part : std::min(nodes_.at(edge.i, edge.j), nodes_.at(edge.i + along.i, edge.j + along.j));
    }
    /// Returns the spacing that spreads from an edge between two cells: that of a partly painted cell beside a coarser
    /// or unpainted one.
    float edgeValue(Step near, Step far, Step along) const {
        const float here = partValue(near.i, near.j);
        const float there = partValue(far.i, far.j);
        const float low = here > 0.0F && (there == 0.0F || here <= there) ? here : there;
        if (low == 0.0F) {
            return 0.0F;
        }
        const float other = low == here ? beyond(far, near, along) : beyond(near, near, along);
        return low < other * 0.999F ? low : 0.0F;
    }
    /// Adds the edges of a row of 16 cells, with runs of equal ones joined.
    void addEdges(Step cell, Step along, Step across) {
        float run = 0.0F;
        Step begin = cell;
        for (std::int32_t n = 0; n <= kTileSpan; ++n, cell.i += along.i, cell.j += along.j) {
            const float value = n < kTileSpan ? edgeValue(cell, {cell.i + across.i, cell.j + across.j}, along) : 0.0F;
            if (value == run) {
                continue;
            }
            if (run > 0.0F) {
                sites_.add(SizeSite::segment(place(begin), place(cell), run, gradation_), kLabel);
            }
            run = value;
            begin = cell;
        }
    }
    void addNode(std::int32_t i, std::int32_t j) {
        const double value = nodes_.at(i, j);
        bool lower = false;
        for (std::int32_t dj = -1; value > 0.0 && dj <= 1; ++dj) {
            for (std::int32_t di = -1; di <= 1; ++di) {
                const double other = nodes_.at(i + di, j + dj);
                const double growth = gradation_ * pitch_ * std::sqrt(static_cast<double>(di * di + dj * dj));
                if (other > 0.0 && other + growth <= 0.999 * value) {
                    return; // that one demands a smaller spacing here
                }
                lower = lower || value + growth < 0.999 * other;
            }
        }
        if (lower) {
            sites_.add(SizeSite::point(place({i, j}), value, gradation_), kLabel);
        }
    }
    Vec2 place(Step node) const {
        return corner_ + pitch_ * Vec2{static_cast<double>(node.i), static_cast<double>(node.j)};
    }

    static constexpr SiteLabel kLabel{SpacingOrigin::Paint, SiteReason::PaintEdge, 0};
    const TileSurroundings &nodes_;
    Vec2 corner_;
    double pitch_;
    double gradation_;
    SiteSet &sites_;
};

Vec2 tileCorner(const PaintedSpacing &paint, Key key) {
    return paint.origin +
           paint.pitch * kTileSpan * Vec2{static_cast<double>(key.first), static_cast<double>(key.second)};
}

} // namespace

Result<PaintedPart> PaintedPart::build(const PaintedSpacing &paint, const Box2 &box, double minimum) {
    if (auto fault = faultOf(paint)) {
        return *std::move(fault);
    }
    PaintedPart part;
    const double tile = paint.pitch * kTileSpan;
    const Vec2 first{std::floor((box.min.x - paint.origin.x) / tile), std::floor((box.min.y - paint.origin.y) / tile)};
    const Vec2 last{std::floor((box.max.x - paint.origin.x) / tile), std::floor((box.max.y - paint.origin.y) / tile)};
    const Vec2 count{last.x - first.x + 1.0, last.y - first.y + 1.0};
    if (!(count.x * count.y <= kMaxDirectory)) {
        return badPaint("the grid of the painted spacing is too fine for the domain");
    }
    part.columns_ = static_cast<std::uint32_t>(count.x);
    part.origin_ = paint.origin + tile * first;
    part.perPitch_ = 1.0 / paint.pitch;
    part.spanX_ = count.x * kTileSpan;
    part.spanY_ = count.y * kTileSpan;
    part.directory_.assign(static_cast<std::size_t>(count.x * count.y), kNoBlock);
    for (const Key &key : tilesTouched(paint)) {
        const double column = key.first - first.x;
        const double row = key.second - first.y;
        if (column < 0.0 || row < 0.0 || column >= count.x || row >= count.y) {
            continue;
        }
        const TileSurroundings nodes(paint, key, minimum);
        if (!nodes.painted()) {
            continue;
        }
        constexpr auto kEdge = static_cast<std::int32_t>(kTileSpan);
        Block block{};
        for (std::int32_t j = 0; j <= kEdge; ++j) {
            for (std::int32_t i = 0; i <= kEdge; ++i) {
                const float value = nodes.at(i, j);
                block[static_cast<std::size_t>(i) + static_cast<std::size_t>(j) * kWidth] = value;
                part.minimum_ = value > 0.0F ? std::min(part.minimum_, static_cast<double>(value)) : part.minimum_;
            }
        }
        part.directory_[static_cast<std::size_t>(row) * part.columns_ + static_cast<std::size_t>(column)] =
            static_cast<std::uint32_t>(part.blocks_.size());
        part.blocks_.push_back(block);
    }
    return part;
}

void PaintedPart::addSites(const PaintedSpacing &paint, double minimum, double gradation, SiteSet &sites) {
    for (const Key &key : tilesTouched(paint)) {
        const TileSurroundings nodes(paint, key, minimum);
        if (nodes.painted()) {
            SiteFinder(nodes, tileCorner(paint, key), paint.pitch, gradation, sites).run();
        }
    }
}

std::vector<PaintedPart::Border> PaintedPart::borderOf(const PaintedSpacing &paint) {
    std::vector<Border> border;
    for (const Key &key : tilesTouched(paint)) {
        const TileSurroundings nodes(paint, key, 0.0);
        const Vec2 corner = tileCorner(paint, key);
        for (std::int32_t k = 0; nodes.painted() && k < kTileSpan * kTileSpan; ++k) {
            const std::int32_t i = k % kTileSpan, j = k / kTileSpan;
            if (nodes.at(i, j) > 0.0F) {
                continue;
            }
            float beside = 0.0F;
            for (std::int32_t n = 0; n < 9; ++n) {
                beside = std::max(beside, nodes.at(i + n % 3 - 1, j + n / 3 - 1));
            }
            if (beside > 0.0F) {
                border.push_back({corner + paint.pitch * Vec2{static_cast<double>(i), static_cast<double>(j)},
                                  static_cast<double>(beside)});
            }
        }
    }
    return border;
}

} // namespace forefront
