#include "core/engine/base/assert.hpp"
#include "core/engine/spacing/sites/site_tree_builders.hpp"
#include "core/engine/spacing/sites/site_tree_writer.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

/// Builds level by level, so that when memory runs short, the tree is equally deep everywhere.
class SiteTreeBuilder : SiteTreeWriter {
  public:
    SiteTreeBuilder(std::vector<SizeSite> sites, const Box2 &box) : SiteTreeWriter(std::move(sites), box) {
        aims_ = tree_.sites_.size() > kManySites ? kAimsOfMany : kAims;
        maxCells_ = std::max(kMaxCells, kMaxCellsPerSite * tree_.sites_.size());
        maxEntries_ = std::max(kMaxEntries, kMaxEntriesPerSite * tree_.sites_.size());
    }

    std::optional<SiteTree> run(const Progress &progress) {
        startAtRoot();
        for (int level = kTopLevel; !cells_.empty(); --level) {
            full_ = tree_.cells_.size() + 4 * cells_.size() > maxCells_ || tree_.lists_.size() > maxEntries_;
            nextCells_.clear();
            nextLists_.clear();
            for (std::size_t i = 0; i < cells_.size(); ++i) {
                if ((i & 255U) == 0 && progress.cancelled()) {
                    return std::nullopt;
                }
                treat(cells_[i], level);
            }
            cells_.swap(nextCells_);
            lists_.swap(nextLists_);
        }
        return take();
    }

  private:
    /// The aims of building: `shortList` sites in a list, `thinning` per level and `tolerance` relative to the value.
    /// Longer lists make fewer leaves, and values are looked up for longer; with 16 sites, both together took least
    /// time on maps of 700 to 5,000 points, two thirds of that with 5.
    struct Aims {
        std::size_t shortList;
        double thinning, tolerance;
    };
    static constexpr Aims kAims{16, 1e-3, SiteTree::kTolerance};
    /// With many sites, building would take several times as long as meshing.
    static constexpr Aims kAimsOfMany{12, 6.4e-3, 2.0 * SiteTree::kTolerance};
    static constexpr std::size_t kLongestList = 64;
    static constexpr std::size_t kMaxCells = 2'000'000;
    static constexpr std::size_t kMaxEntries = 4'000'000;
    static constexpr std::size_t kMaxCellsPerSite = 8;
    static constexpr std::size_t kMaxEntriesPerSite = 24;

    struct Cell {
        std::uint32_t slot = 0; ///< where its entry is; unused above the table
        std::uint32_t x = 0;    ///< lower left corner, in units
        std::uint32_t y = 0;
        std::uint32_t first = 0; ///< candidates of its parent
        std::uint32_t count = 0;
    };

    void startAtRoot() {
        lists_.resize(tree_.sites_.size());
        for (std::size_t i = 0; i < lists_.size(); ++i) {
            lists_[i] = static_cast<std::uint32_t>(i);
        }
        cells_ = {Cell{0, 0, 0, 0, static_cast<std::uint32_t>(lists_.size())}};
    }

    /// Keeps the sites that may win somewhere within `reach` of the centre: a site changes by at most growth·reach.
    void compete(const Cell &cell, Vec2 centre, double reach) {
        competitors_.clear();
        double bound = std::numeric_limits<double>::infinity();
        for (std::uint32_t i = 0; i < cell.count; ++i) {
            const std::uint32_t index = lists_[cell.first + i];
            const SizeSite &candidate = tree_.sites_[index];
            const double value = candidate.at(centre);
            bound = std::min(bound, value + candidate.growth * reach);
            if (value - candidate.growth * reach <= bound) {
                competitors_.push_back({index, value});
            }
        }
        std::erase_if(competitors_, [&](const Competitor &c) { return c.value - site(c).growth * reach > bound; });
        if (competitors_.size() > kLongestTested) {
            thin(centre, reach);
        }
        if (competitors_.size() > 2) {
            dropParallel(centre, reach);
        }
        FOREFRONT_ASSERT(!competitors_.empty());
    }

    /// A far competitor as seen from the centre of a cell.
    struct Sight {
        Vec2 nearest;
        double distance = 0.0; ///< to the axis of the site
        double length = 0.0;   ///< of the site
        std::int32_t sector = -1;
    };
    /// Keeps only the best of many distant sites in the same direction. Of two sites whose nearest points lie e apart
    /// at distances of at least d, the difference changes within reach by at most reach·growth·e / (d − reach). The
    /// worse one can be dropped if that exceeds the difference at the centre by no more than a small part of the
    /// spacing.
    void thin(Vec2 centre, double reach) {
        double low = std::numeric_limits<double>::infinity();
        double growth = 0.0;
        for (const Competitor &c : competitors_) {
            low = std::min(low, std::max(site(c).size, c.value - site(c).growth * reach));
            growth = std::max(growth, site(c).growth);
        }
        const double allowance = aims_.thinning * low;
        const double perTurn = 4.0 * growth * reach / allowance;
        const auto sectors = static_cast<std::int32_t>(std::clamp(perTurn, 8.0, 4096.0));
        sights_.clear();
        bestOfSector_.assign(static_cast<std::size_t>(sectors), -1);
        for (std::size_t i = 0; i < competitors_.size(); ++i) {
            sights_.push_back(sightOf(site(competitors_[i]), centre, reach, sectors));
            const std::int32_t sector = sights_.back().sector;
            if (sector >= 0) {
                std::int32_t &best = bestOfSector_[static_cast<std::size_t>(sector)];
                if (best < 0 || competitors_[i].value < competitors_[static_cast<std::size_t>(best)].value) {
                    best = static_cast<std::int32_t>(i);
                }
            }
        }
        crowd_.swap(competitors_);
        competitors_.clear();
        for (std::size_t i = 0; i < crowd_.size(); ++i) {
            if (!replaceable(i, reach, allowance)) {
                competitors_.push_back(crowd_[i]);
            }
        }
    }
    static Sight sightOf(const SizeSite &s, Vec2 centre, double reach, std::int32_t sectors) {
        Sight sight{s.nearest(centre), 0.0, length(s.ab), -1};
        const Vec2 to = sight.nearest - centre;
        sight.distance = length(to);
        if (sight.distance > 2.0 * reach + s.radius) {
            // The "diamond angle" in [0, 4): as good as an angle for distinguishing directions.
            const double slant = to.y / (std::fabs(to.x) + std::fabs(to.y));
            const double angle = to.x >= 0.0 ? 1.0 + slant : 3.0 - slant;
            sight.sector = std::min(static_cast<std::int32_t>(angle * 0.25 * sectors), sectors - 1);
        }
        return sight;
    }
    bool replaceable(std::size_t i, double reach, double allowance) const {
        const Sight &own = sights_[i];
        if (own.sector < 0) {
            return false;
        }
        const auto best = static_cast<std::size_t>(bestOfSector_[static_cast<std::size_t>(own.sector)]);
        if (best == i) {
            return false;
        }
        const Sight &other = sights_[best];
        const SizeSite &mine = site(crowd_[i]);
        const SizeSite &theirs = site(crowd_[best]);
        const double apart = distance(own.nearest, other.nearest) + own.length + other.length;
        const double growth = std::max(mine.growth, theirs.growth);
        const double change =
            growth * apart / (std::min(own.distance, other.distance) - reach) + std::fabs(mine.growth - theirs.growth);
        return crowd_[i].value - crowd_[best].value + allowance >= reach * change;
    }

    void treat(const Cell &cell, int level) {
        const double span = static_cast<double>(1U << level);
        const double size = span * tree_.unit_;
        const Vec2 centre = placeOf(cell.x + 0.5 * span, cell.y + 0.5 * span);
        const double reach = 0.70711 * size;
        compete(cell, centre, reach);
        if (level > SiteTree::kBits) {
            descendToTable(cell, level);
            return;
        }
        const bool last = level == 0 || full_;
        if (competitors_.size() <= aims_.shortList || (last && competitors_.size() <= kLongestList)) {
            storeList(cell.slot, cell.x, cell.y, span);
        } else if (last) {
            storeSmooth(cell.slot, minimaAtCorners(cell.x, cell.y, span));
        } else if (isSmooth(cell.x, cell.y, span, aims_.tolerance)) {
            storeSmooth(cell.slot, corners_);
        } else {
            split(cell, level);
        }
    }

    void descendToTable(const Cell &cell, int level) {
        const std::uint32_t half = 1U << (level - 1);
        const std::uint32_t first = pushCompetitors();
        for (std::uint32_t child = 0; child < 4; ++child) {
            Cell next{0, cell.x + (child & 1U) * half, cell.y + (child >> 1) * half, first, 0};
            next.count = static_cast<std::uint32_t>(competitors_.size());
            const std::uint32_t column = next.x >> SiteTree::kBits;
            const std::uint32_t row = next.y >> SiteTree::kBits;
            if (column < tree_.columns_ && row < rows_) {
                next.slot = row * tree_.columns_ + column;
                nextCells_.push_back(next);
            }
        }
    }
    void split(const Cell &cell, int level) {
        const std::uint32_t half = 1U << (level - 1);
        const std::uint32_t first = pushCompetitors();
        const auto group = static_cast<std::uint32_t>(tree_.cells_.size());
        tree_.cells_.resize(group + 4, 0);
        tree_.cells_[cell.slot] = group | SiteTree::kSplit;
        for (std::uint32_t child = 0; child < 4; ++child) {
            nextCells_.push_back({group + child, cell.x + (child & 1U) * half, cell.y + (child >> 1) * half, first,
                                  static_cast<std::uint32_t>(competitors_.size())});
        }
    }
    std::uint32_t pushCompetitors() {
        const auto first = static_cast<std::uint32_t>(nextLists_.size());
        for (const Competitor &competitor : competitors_) {
            nextLists_.push_back(competitor.site);
        }
        return first;
    }

    bool full_ = false;
    Aims aims_ = kAims;
    std::size_t maxCells_ = kMaxCells, maxEntries_ = kMaxEntries;
    std::vector<Cell> cells_; ///< cells of the current level, and their candidates
    std::vector<std::uint32_t> lists_;
    std::vector<Cell> nextCells_;
    std::vector<std::uint32_t> nextLists_;
    std::vector<Competitor> crowd_; ///< the competitors before thinning, in step with sights_
    std::vector<Sight> sights_;
    std::vector<std::int32_t> bestOfSector_;
};

std::optional<SiteTree> buildTreeFromRoot(std::vector<SizeSite> sites, const Box2 &box, const Progress &progress) {
    return SiteTreeBuilder(std::move(sites), box).run(progress);
}

} // namespace forefront
