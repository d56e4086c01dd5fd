#include "core/engine/spacing/parts/paint/paint.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace forefront {
namespace {

constexpr std::int32_t kSpan = PaintedSpacing::kTileSpan;
constexpr double kFarthest = 1e9; ///< lattice indices beyond this are refused: they must fit 32 bits

std::int32_t tileOf(std::int32_t node) {
    return node >= 0 ? node / kSpan : -((-node + kSpan - 1) / kSpan);
}
std::size_t placeIn(std::int32_t i, std::int32_t j) {
    return static_cast<std::size_t>((i - tileOf(i) * kSpan) + (j - tileOf(j) * kSpan) * kSpan);
}

struct NodeRange {
    std::int32_t first = 0;
    std::int32_t last = -1;
};

/// A disc in lattice units, and the nodes that may lie in it.
struct LatticeDisc {
    double x = 0.0;
    double y = 0.0;
    double radius = 0.0;
    NodeRange columns;
    NodeRange rows;
};

/// Returns the disc, which reaches at least the node nearest to its centre; std::nullopt if the numbers are unusable.
std::optional<LatticeDisc> latticeDisc(const PaintedSpacing &paint, Vec2 centre, double radius) {
    if (!isFinite(centre) || !isFinite(paint.origin) || !(radius > 0.0) || !std::isfinite(radius) ||
        !(paint.pitch > 0.0) || !std::isfinite(paint.pitch)) {
        return std::nullopt;
    }
    LatticeDisc disc;
    disc.x = (centre.x - paint.origin.x) / paint.pitch;
    disc.y = (centre.y - paint.origin.y) / paint.pitch;
    disc.radius = std::min(radius / paint.pitch, 0.5 * kWidestDab);
    if (!(std::fabs(disc.x) < kFarthest && std::fabs(disc.y) < kFarthest)) {
        return std::nullopt;
    }
    const double dx = disc.x - std::nearbyint(disc.x);
    const double dy = disc.y - std::nearbyint(disc.y);
    disc.radius = std::max(disc.radius, std::sqrt(dx * dx + dy * dy) * (1.0 + 1e-12));
    const auto range = [&](double at) {
        return NodeRange{static_cast<std::int32_t>(std::ceil(at - disc.radius)),
                         static_cast<std::int32_t>(std::floor(at + disc.radius))};
    };
    disc.columns = range(disc.x);
    disc.rows = range(disc.y);
    return disc;
}

/// Calls change(value, distance to the centre in pitches, column, row) for each node of the disc; it must return true
/// if it changed the value. Tiles are copied before their first change, and dropped once they hold no paint.
template <class Change>
void changeDisc(PaintedSpacing &paint, const LatticeDisc &disc, bool mayCreate, Change change) {
    for (std::int32_t tj = tileOf(disc.rows.first); tj <= tileOf(disc.rows.last); ++tj) {
        for (std::int32_t ti = tileOf(disc.columns.first); ti <= tileOf(disc.columns.last); ++ti) {
            const auto found = paint.tiles.find({ti, tj});
            if (found == paint.tiles.end() && !mayCreate) {
                continue;
            }
            PaintedSpacing::Tile tile{};
            if (found != paint.tiles.end() && found->second) {
                tile = *found->second;
            }
            bool changed = false;
            const std::int32_t lastJ = std::min(disc.rows.last, tj * kSpan + kSpan - 1);
            const std::int32_t lastI = std::min(disc.columns.last, ti * kSpan + kSpan - 1);
            for (std::int32_t j = std::max(disc.rows.first, tj * kSpan); j <= lastJ; ++j) {
                for (std::int32_t i = std::max(disc.columns.first, ti * kSpan); i <= lastI; ++i) {
                    const double d = std::sqrt((i - disc.x) * (i - disc.x) + (j - disc.y) * (j - disc.y));
                    if (d <= disc.radius) {
                        changed = change(tile[placeIn(i, j)], d, i, j) || changed;
                    }
                }
            }
            if (!changed) {
                continue;
            }
            bool any = false;
            for (const float value : tile) {
                any = any || value != 0.0F;
            }
            if (any) {
                paint.tiles[{ti, tj}] = std::make_shared<const PaintedSpacing::Tile>(tile);
            } else if (found != paint.tiles.end()) {
                paint.tiles.erase(found);
            }
        }
    }
}

Vec2 placeOf(const PaintedSpacing &paint, std::int32_t i, std::int32_t j) {
    return paint.origin + paint.pitch * Vec2{static_cast<double>(i), static_cast<double>(j)};
}

/// Returns the spacing from which a dab starts at a node: its paint, else that around the stroke; 0 if there is none.
double startingValue(float painted, const PaintedSpacing &paint, const Dab &dab, std::int32_t i, std::int32_t j) {
    if (painted > 0.0F || !dab.around) {
        return painted > 0.0F ? static_cast<double>(painted) : 0.0;
    }
    const double value = dab.around(placeOf(paint, i, j));
    return value > 0.0 && std::isfinite(value) ? value : 0.0;
}

/// The logarithms of the spacing from which a dab starts, at the nodes around it. Each is evaluated once, since a node
/// counts in nine means.
class StartingLogs {
  public:
    /// Covers the nodes of a disc and those up to `reach` nodes beside them.
    StartingLogs(const PaintedSpacing &paint, const Dab &dab, const LatticeDisc &disc, std::int32_t reach)
        : paint_(paint), dab_(dab), reach_(reach), left_(disc.columns.first - reach), low_(disc.rows.first - reach),
          width_(static_cast<std::size_t>(disc.columns.last + reach - left_ + 1)),
          logs_(width_ * static_cast<std::size_t>(disc.rows.last + reach - low_ + 1), kUnknown) {}

    /// Returns the geometric mean of the spacing at a node and at eight others around it, `reach` nodes away; unpainted
    /// ones count only if their spacing is known.
    double meanAround(std::int32_t i, std::int32_t j) {
        double sum = 0.0, count = 0.0;
        for (std::int32_t dj = -reach_; dj <= reach_; dj += reach_) {
            for (std::int32_t di = -reach_; di <= reach_; di += reach_) {
                const double value = at(i + di, j + dj);
                sum += std::isfinite(value) ? value : 0.0;
                count += std::isfinite(value) ? 1.0 : 0.0;
            }
        }
        return std::exp(sum / count);
    }

  private:
    static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

    /// Returns the logarithm at a node; minus infinity if there is no spacing.
    double at(std::int32_t i, std::int32_t j) {
        double &log = logs_[static_cast<std::size_t>(j - low_) * width_ + static_cast<std::size_t>(i - left_)];
        if (std::isnan(log)) {
            log = std::log(startingValue(paintedNode(paint_, i, j), paint_, dab_, i, j));
        }
        return log;
    }

    const PaintedSpacing &paint_;
    const Dab &dab_;
    std::int32_t reach_, left_, low_;
    std::size_t width_;
    std::vector<double> logs_;
};

/// Returns 1 in the core of a dab, falling smoothly to 0 at its radius.
double weightAt(double d, double core, double radius) {
    const double s = d > core ? (d - core) / (radius - core) : 0.0;
    return 1.0 - s * s * (3.0 - 2.0 * s);
}

/// Changes the painted spacing, or else the ambient one, by a factor or towards a mean.
PaintedSpacing adjusted(const PaintedSpacing &before, const Dab &dab) {
    constexpr double kDabsPerOctave = 8.0;
    PaintedSpacing after = before;
    const auto disc = latticeDisc(before, dab.centre, dab.radius);
    if (!disc || !(dab.strength > 0.0)) {
        return after;
    }
    const double strength = std::min(dab.strength, 1.0), core = std::clamp(dab.hardness, 0.0, 1.0) * disc->radius;
    const bool smooths = dab.mode == DabMode::Smooth;
    const bool extends = dab.mode == DabMode::Finer; // also changes unpainted nodes
    const double ambient = extends && dab.ambient > 0.0 && std::isfinite(dab.ambient) ? dab.ambient : 0.0;
    const double octaves = (dab.mode == DabMode::Finer ? -strength : strength) / kDabsPerOctave;
    constexpr double kReach = 1.0 / 3.0; // how far the nodes of a mean are apart, as a fraction of the radius
    const std::int32_t reach = std::max(1, static_cast<std::int32_t>(dab.around ? kReach * disc->radius : 1.0));
    const bool mayCreate = ambient > 0.0 || dab.around;
    std::optional<StartingLogs> logs;
    if (smooths) {
        logs.emplace(before, dab, *disc, reach);
    }
    changeDisc(after, *disc, mayCreate, [&](float &value, double d, std::int32_t i, std::int32_t j) {
        const double start = startingValue(value, before, dab, i, j);
        const double old = start > 0.0 ? start : ambient;
        if (!(old > 0.0)) {
            return false;
        }
        const double weight = weightAt(d, core, disc->radius);
        const double wanted = smooths ? old * std::pow(logs->meanAround(i, j) / old, strength * weight)
                                      : old * std::exp2(octaves * weight);
        const auto next = static_cast<float>(wanted);
        const bool changed = value != next && next > 0.0F && std::isfinite(next);
        value = changed ? next : value;
        return changed;
    });
    return after;
}

} // namespace

PaintedSpacing emptyPaint(const Box2 &domain) {
    PaintedSpacing paint;
    const double diagonal = domain.diagonal();
    if (!(diagonal > 0.0) || !std::isfinite(diagonal)) {
        paint.pitch = 1.0 / 512.0;
        return paint;
    }
    paint.pitch = std::ldexp(1.0, std::ilogb(diagonal / 512.0));
    // Count whole tiles from the origin of coordinates if possible, otherwise from the box.
    const double farthest =
        std::max({std::fabs(domain.min.x), std::fabs(domain.max.x), std::fabs(domain.min.y), std::fabs(domain.max.y)});
    if (farthest > 1e6 * paint.pitch) {
        paint.origin = domain.min;
    }
    return paint;
}

PaintedSpacing paint(const PaintedSpacing &before, const Dab &dab) {
    if (dab.mode == DabMode::Erase) {
        return erase(before, dab.centre, dab.radius);
    }
    if (dab.mode != DabMode::Set) {
        return adjusted(before, dab);
    }
    PaintedSpacing after = before;
    const auto disc = latticeDisc(before, dab.centre, dab.radius);
    const auto target = static_cast<float>(dab.spacing);
    if (!disc || !(target > 0.0F) || !std::isfinite(target) || !(dab.strength > 0.0)) {
        return after;
    }
    const double hardness = dab.hardness >= 0.0 ? std::min(dab.hardness, 1.0) : 0.0;
    const double core = std::max(hardness * disc->radius, std::min(disc->radius, 0.70711));
    const double rim = disc->radius - core;
    const auto ambient = dab.ambient > 0.0 && std::isfinite(dab.ambient) ? static_cast<float>(dab.ambient) : 0.0F;
    const double strength = std::min(dab.strength, 1.0);
    changeDisc(after, *disc, true, [&](float &value, double d, std::int32_t i, std::int32_t j) {
        const auto start = static_cast<float>(startingValue(value, before, dab, i, j));
        const float old = start > 0.0F ? start : ambient;
        float blended = target;
        if (d > core) {
            const double s = (d - core) / rim;
            const double fading = s * s * (3.0 - 2.0 * s); // 0 at the core, 1 at the radius
            if (old > 0.0F) {
                blended = static_cast<float>(target * std::pow(static_cast<double>(old) / target, fading));
            } else if (s > 0.5) {
                return false;
            }
        }
        if (strength < 1.0 && old > 0.0F) {
            blended = static_cast<float>(old * std::pow(static_cast<double>(blended) / old, strength));
        }
        const bool changed = value != blended;
        value = blended;
        return changed;
    });
    return after;
}

PaintedSpacing replacing(const PaintedSpacing &paint, const std::function<double(Vec2)> &spacing) {
    PaintedSpacing after = paint;
    if (paint.replaces) {
        return after;
    }
    after.replaces = true;
    for (auto &[key, tile] : after.tiles) {
        if (!tile) {
            continue;
        }
        auto limited = std::make_shared<PaintedSpacing::Tile>(*tile);
        for (std::int32_t k = 0; k < kSpan * kSpan; ++k) {
            float &value = (*limited)[static_cast<std::size_t>(k)];
            if (value > 0.0F) {
                const Vec2 place = placeOf(paint, key.first * kSpan + k % kSpan, key.second * kSpan + k / kSpan);
                value = std::min(value, static_cast<float>(spacing(place)));
            }
        }
        tile = std::move(limited);
    }
    return after;
}

PaintedSpacing fill(const PaintedSpacing &before, const Box2 &box, const std::function<double(Vec2)> &size) {
    constexpr double kMostNodes = 4e6;
    PaintedSpacing after = before;
    const Vec2 low = (1.0 / before.pitch) * (box.min - before.origin);
    const Vec2 high = (1.0 / before.pitch) * (box.max - before.origin);
    const bool usable =
        std::max({std::fabs(low.x), std::fabs(low.y), std::fabs(high.x), std::fabs(high.y)}) < kFarthest &&
        (high.x - low.x + 1.0) * (high.y - low.y + 1.0) <= kMostNodes;
    if (!usable) {
        return after;
    }
    std::map<std::pair<std::int32_t, std::int32_t>, std::shared_ptr<PaintedSpacing::Tile>> changed;
    for (auto j = static_cast<std::int32_t>(std::ceil(low.y)); j <= std::floor(high.y); ++j) {
        for (auto i = static_cast<std::int32_t>(std::ceil(low.x)); i <= std::floor(high.x); ++i) {
            const auto value = static_cast<float>(size(placeOf(before, i, j)));
            if (!(value > 0.0F) || !std::isfinite(value)) {
                continue;
            }
            const std::pair key(tileOf(i), tileOf(j));
            auto &tile = changed[key];
            if (!tile) {
                const auto found = before.tiles.find(key);
                const bool known = found != before.tiles.end() && found->second;
                tile = std::make_shared<PaintedSpacing::Tile>(known ? *found->second : PaintedSpacing::Tile{});
            }
            (*tile)[placeIn(i, j)] = value;
        }
    }
    for (auto &[key, tile] : changed) {
        after.tiles[key] = std::move(tile);
    }
    return after;
}

PaintedSpacing erase(const PaintedSpacing &before, Vec2 centre, double radius) {
    PaintedSpacing after = before;
    if (const auto disc = latticeDisc(before, centre, radius)) {
        changeDisc(after, *disc, false, [](float &value, double, std::int32_t, std::int32_t) {
            const bool changed = value != 0.0F;
            value = 0.0F;
            return changed;
        });
    }
    return after;
}

float paintedNode(const PaintedSpacing &paint, std::int32_t i, std::int32_t j) {
    const auto found = paint.tiles.find({tileOf(i), tileOf(j)});
    return found == paint.tiles.end() || !found->second ? 0.0F : (*found->second)[placeIn(i, j)];
}

} // namespace forefront
