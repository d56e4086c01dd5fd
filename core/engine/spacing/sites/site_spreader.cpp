#include "core/engine/spacing/sites/site_tree_builders.hpp"
#include "core/engine/spacing/sites/site_tree_writer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

namespace forefront {

/// Cells are as fine as the sites in them demand, and at most twice as large as those beside them. From the cells at
/// the sites, winners spread to the cells beside them until nothing changes: where all sites grow at the same rate, the
/// part of the plane that a site wins is star-shaped around it, so a path through that part leads to each of its cells.
/// Each leaf then chooses among the sites at it and the winners of the leaves beside it.
class SiteSpreader : SiteTreeWriter {
  public:
    SiteSpreader(std::vector<SizeSite> sites, const Box2 &box, double cellsPerSize)
        : SiteTreeWriter(std::move(sites), box), cellsPerSize_(cellsPerSize) {
        maxCells_ = std::max(kMaxCells, kMaxCellsPerSite * tree_.sites_.size());
    }

    std::optional<SiteTree> run(const Progress &progress) {
        if (!divide(progress)) {
            return std::nullopt;
        }
        listLeaves();
        findNeighbours();
        if (progress.cancelled()) {
            return std::nullopt;
        }
        listSites();
        spread();
        for (std::uint32_t i = 0; i < leaves_.size(); ++i) {
            if (i % 4096 == 0 && progress.cancelled()) {
                return std::nullopt;
            }
            fill(i);
        }
        return take();
    }

  private:
    static constexpr std::size_t kMaxCells = 2'000'000;
    static constexpr std::size_t kMaxCellsPerSite = 24;
    /// Up to this many sites, a cell lists them: testing whether their minimum is smooth costs more than it saves.
    static constexpr std::size_t kFew = 3;
    static constexpr std::size_t kLongestList = 12;
    static constexpr double kTolerance = 2.0 * SiteTree::kTolerance;

    struct Leaf {
        std::uint32_t slot = 0, x = 0, y = 0; ///< lower left corner, in units
        std::int32_t level = 0;
        std::uint32_t site = kNoSite;                           ///< with the smallest value at the centre
        std::uint32_t last = kNoSite;                           ///< site offered last
        double value = std::numeric_limits<double>::infinity(); ///< of `site`
    };
    static constexpr std::uint32_t kNoSite = 0xffffffffU;
    struct Split {
        std::uint32_t x = 0, y = 0;
    };
    /// Numbers in rows, one row per leaf.
    struct Rows {
        std::vector<std::uint32_t> starts, entries;
        std::span<const std::uint32_t> at(std::uint32_t row) const {
            return {entries.data() + starts[row], starts[row + 1] - starts[row]};
        }
        /// Sorts pairs of row and entry into rows; with `bothWays`, stores each pair in both directions.
        void fill(std::size_t rows, std::span<const std::array<std::uint32_t, 2>> pairs, bool bothWays) {
            starts.assign(rows + 1, 0);
            for (const auto &[row, entry] : pairs) {
                ++starts[row];
                if (bothWays) {
                    ++starts[entry];
                }
            }
            std::uint32_t sum = 0;
            for (std::uint32_t &start : starts) {
                sum += start;
                start = sum;
            }
            entries.resize(sum);
            for (std::size_t i = pairs.size(); i-- > 0;) {
                const auto &[row, entry] = pairs[i];
                entries[--starts[row]] = entry;
                if (bothWays) {
                    entries[--starts[entry]] = row;
                }
            }
        }
    };

    /// Divides cells around the sites, into coarser ones if memory would run short. Returns false if cancelled.
    bool divide(const Progress &progress) {
        const std::size_t undivided = tree_.cells_.size();
        for (int coarser = 0; !progress.cancelled(); ++coarser) {
            // Cells of the table are few enough.
            if ((splitAtSites(coarser) && balance()) || coarser == SiteTree::kBits) {
                return true;
            }
            tree_.cells_.assign(undivided, 0);
        }
        return false;
    }

    int levelOf(const SizeSite &s, int coarser) const {
        constexpr double kLongest = 1U << SiteTree::kBits;
        const double units = std::clamp(s.size * tree_.toUnits_ / cellsPerSize_, 1.0, kLongest);
        return std::min(std::ilogb(units) + coarser, SiteTree::kBits);
    }

    /// A line of equally distant places, one more than there are steps.
    struct Places {
        Vec2 from, ab;
        double steps = 0.0;
    };
    Places placesAlong(Vec2 from, Vec2 ab, double cell) const {
        return {from, ab, std::ceil(length(ab) * tree_.toUnits_ / cell)};
    }
    /// Returns the places along a site, a cell apart; only those near the box if the site is much longer than the box,
    /// since there could be any number of them.
    Places placesOf(const SizeSite &s, double cell) const {
        constexpr double kMuchLonger = 64.0;
        const double side = tree_.unit_ * static_cast<double>(1U << kTopLevel), margin = tree_.unit_ * cell;
        if (length(s.ab) <= kMuchLonger * side) {
            return placesAlong(s.a, s.ab, cell);
        }
        const Vec2 low = tree_.corner_ - Vec2{margin, margin};
        const Vec2 high = tree_.corner_ + tree_.unit_ * Vec2{tree_.spanX_, tree_.spanY_} + Vec2{margin, margin};
        double first = 0.0, last = 1.0;
        const auto clip = [&](double at, double along, double from, double to) {
            const double enters = (from - at) / along, leaves = (to - at) / along;
            if (along != 0.0) {
                first = std::max(first, std::min(enters, leaves));
                last = std::min(last, std::max(enters, leaves));
            } else if (at < from || at > to) {
                last = -1.0;
            }
        };
        clip(s.a.x, s.ab.x, low.x, high.x);
        clip(s.a.y, s.ab.y, low.y, high.y);
        return first <= last ? placesAlong(s.a + first * s.ab, (last - first) * s.ab, cell)
                             : Places{s.nearest(midpoint(low, high)), {}, 0.0};
    }

    /// Calls visit(x, y) for the places, in units, whose cells a site belongs to: along it, around it in squares.
    template <class Visit>
    void alongSite(const SizeSite &s, int level, const Visit &visit) const {
        const double cell = static_cast<double>(1U << level);
        const Places places = placesOf(s, cell);
        const auto steps = static_cast<std::int64_t>(places.steps);
        for (std::int64_t k = 0; k <= steps; ++k) {
            const double part = steps > 0 ? static_cast<double>(k) / places.steps : 0.0;
            const Vec2 p = tree_.toUnits_ * (places.from + part * places.ab - tree_.corner_);
            for (unsigned corner = 0; corner < 4; ++corner) {
                const double x = p.x + ((corner & 1U) != 0 ? 0.5 : -0.5) * cell;
                const double y = p.y + ((corner & 2U) != 0 ? 0.5 : -0.5) * cell;
                visit(static_cast<std::uint32_t>(std::clamp(x, 0.0, tree_.spanX_)),
                      static_cast<std::uint32_t>(std::clamp(y, 0.0, tree_.spanY_)));
            }
        }
    }

    /// Splits the cells around the sites. Returns false if there are too many.
    bool splitAtSites(int coarser) {
        for (auto &splits : splits_) {
            splits.clear();
        }
        levels_.clear();
        double places = 0.0;
        for (const SizeSite &s : tree_.sites_) {
            const int level = levelOf(s, coarser);
            levels_.push_back(static_cast<std::uint8_t>(level));
            places += 1.0 + placesOf(s, static_cast<double>(1U << level)).steps;
            if ((tree_.cells_.size() > maxCells_ || places > static_cast<double>(maxCells_)) &&
                coarser < SiteTree::kBits) {
                return false;
            }
            alongSite(s, level, [&](std::uint32_t x, std::uint32_t y) { splitDownTo(x, y, level); });
        }
        return true;
    }
    std::uint32_t tableSlot(std::uint32_t x, std::uint32_t y) const {
        return (y >> SiteTree::kBits) * tree_.columns_ + (x >> SiteTree::kBits);
    }
    /// Splits cells until the one at a place has at most the given level.
    void splitDownTo(std::uint32_t x, std::uint32_t y, int level) {
        std::uint32_t slot = tableSlot(x, y);
        for (int l = SiteTree::kBits; l > level; --l) {
            if ((tree_.cells_[slot] & SiteTree::kSplit) == 0) {
                const auto group = static_cast<std::uint32_t>(tree_.cells_.size());
                tree_.cells_.resize(group + 4, 0);
                tree_.cells_[slot] = group | SiteTree::kSplit;
                const std::uint32_t mask = ~((1U << l) - 1U);
                splits_[static_cast<std::size_t>(l)].push_back({x & mask, y & mask});
            }
            slot = childAt(slot, x, y, l - 1);
        }
    }
    std::uint32_t childAt(std::uint32_t slot, std::uint32_t x, std::uint32_t y, int level) const {
        return (tree_.cells_[slot] & ~SiteTree::kSplit) + ((x >> level) & 1U) + 2U * ((y >> level) & 1U);
    }

    /// Splits cells until those around a split one, corners included, are at least as fine as it was. Returns false if
    /// there are too many.
    bool balance() {
        const std::uint32_t endX = tree_.columns_ << SiteTree::kBits, endY = rows_ << SiteTree::kBits;
        for (std::size_t level = 1; level < SiteTree::kBits; ++level) {
            const std::uint32_t size = 1U << level;
            for (std::size_t i = 0; i < splits_[level].size(); ++i) {
                // Of the cells around it, those within its parent already exist.
                const auto [x, y] = splits_[level][i];
                if (tree_.cells_.size() > maxCells_) {
                    return false;
                }
                const std::uint32_t besideX = (x & size) != 0 ? x + size : x - size; // wraps below zero
                const std::uint32_t besideY = (y & size) != 0 ? y + size : y - size;
                const int fine = static_cast<int>(level);
                if (besideX < endX) {
                    splitDownTo(besideX, y, fine);
                }
                if (besideY < endY) {
                    splitDownTo(x, besideY, fine);
                }
                if (besideX < endX && besideY < endY) {
                    splitDownTo(besideX, besideY, fine);
                }
            }
        }
        return true;
    }

    /// Lists the leaves; the slot of each refers to it until it is filled.
    void listLeaves() {
        const std::size_t table = std::size_t{tree_.columns_} * rows_;
        leaves_.clear();
        leaves_.reserve(table +
                        (tree_.cells_.size() - table) / 4 * 3); // each split adds four cells and makes one no leaf
        for (std::uint32_t row = 0; row < rows_; ++row) {
            for (std::uint32_t column = 0; column < tree_.columns_; ++column) {
                listBelow(row * tree_.columns_ + column, column << SiteTree::kBits, row << SiteTree::kBits,
                          SiteTree::kBits);
            }
        }
    }
    void listBelow(std::uint32_t slot, std::uint32_t x, std::uint32_t y, int level) {
        if ((tree_.cells_[slot] & SiteTree::kSplit) == 0) {
            tree_.cells_[slot] = static_cast<std::uint32_t>(leaves_.size());
            leaves_.push_back({slot, x, y, level});
            return;
        }
        const std::uint32_t group = tree_.cells_[slot] & ~SiteTree::kSplit, half = 1U << (level - 1);
        for (std::uint32_t child = 0; child < 4; ++child) {
            listBelow(group + child, x + (child & 1U) * half, y + (child >> 1) * half, level - 1);
        }
    }

    bool isSplit(std::uint32_t slot) const { return (tree_.cells_[slot] & SiteTree::kSplit) != 0; }
    std::uint32_t child(std::uint32_t slot, std::uint32_t which) const {
        return isSplit(slot) ? (tree_.cells_[slot] & ~SiteTree::kSplit) + which : slot;
    }

    /// Finds the pairs of leaves that share a part of a side.
    void findNeighbours() {
        std::vector<std::array<std::uint32_t, 2>> pairs;
        pairs.reserve(3 * leaves_.size());
        for (std::uint32_t row = 0; row < rows_; ++row) {
            for (std::uint32_t column = 0; column < tree_.columns_; ++column) {
                const std::uint32_t slot = row * tree_.columns_ + column;
                pairWithin(slot, pairs);
                if (column + 1 < tree_.columns_) {
                    pairAcross(slot, slot + 1, 1, 2, pairs);
                }
                if (row + 1 < rows_) {
                    pairAcross(slot, slot + tree_.columns_, 2, 1, pairs);
                }
            }
        }
        neighbours_.fill(leaves_.size(), pairs, true);
    }
    void pairWithin(std::uint32_t slot, std::vector<std::array<std::uint32_t, 2>> &pairs) const {
        if (!isSplit(slot)) {
            return;
        }
        const std::uint32_t group = tree_.cells_[slot] & ~SiteTree::kSplit;
        for (std::uint32_t k = 0; k < 4; ++k) {
            pairWithin(group + k, pairs);
        }
        pairAcross(group, group + 1, 1, 2, pairs);
        pairAcross(group + 2, group + 3, 1, 2, pairs);
        pairAcross(group, group + 2, 2, 1, pairs);
        pairAcross(group + 1, group + 3, 2, 1, pairs);
    }
    /// `from` lies before `to` in the direction of the child bit `across`; the other bit runs along their common side.
    void pairAcross(std::uint32_t from, std::uint32_t to, std::uint32_t across, std::uint32_t along,
                    std::vector<std::array<std::uint32_t, 2>> &pairs) const {
        if (!isSplit(from) && !isSplit(to)) {
            pairs.push_back({tree_.cells_[from], tree_.cells_[to]});
            return;
        }
        pairAcross(child(from, across), child(to, 0), across, along, pairs);
        pairAcross(child(from, across + along), child(to, along), across, along, pairs);
    }

    /// Lists the sites in and directly beside each leaf, and offers them to these leaves and those beside them.
    void listSites() {
        changed_.assign(leaves_.size(), 0);
        std::vector<std::array<std::uint32_t, 2>> pairs;
        pairs.reserve(8 * tree_.sites_.size());
        for (std::uint32_t i = 0; i < tree_.sites_.size(); ++i) {
            const auto first = static_cast<std::ptrdiff_t>(pairs.size());
            alongSite(tree_.sites_[i], levels_[i], [&](std::uint32_t x, std::uint32_t y) {
                const std::array<std::uint32_t, 2> pair{leafAt(x, y), i};
                const auto count = static_cast<std::ptrdiff_t>(pairs.size()) - first;
                if (std::find(pairs.end() - std::min<std::ptrdiff_t>(count, 8), pairs.end(), pair) == pairs.end()) {
                    pairs.push_back(pair);
                }
            });
            std::for_each(pairs.begin() + first, pairs.end(), [&](const auto &pair) { offerAround(pair[0], i); });
        }
        own_.fill(leaves_.size(), pairs, false);
    }
    std::uint32_t leafAt(std::uint32_t x, std::uint32_t y) const {
        std::uint32_t slot = tableSlot(x, y);
        for (int level = SiteTree::kBits; isSplit(slot);) {
            slot = childAt(slot, x, y, --level);
        }
        return tree_.cells_[slot];
    }

    Vec2 centreOf(const Leaf &leaf) const {
        const double half = 0.5 * static_cast<double>(1U << leaf.level);
        return placeOf(leaf.x + half, leaf.y + half);
    }

    /// Offers a site to a leaf. The same one comes from several leaves in turn.
    void offer(std::uint32_t leaf, std::uint32_t site) {
        Leaf &taker = leaves_[leaf];
        if (taker.site == site || taker.last == site) {
            return;
        }
        taker.last = site;
        const double value = tree_.sites_[site].at(centreOf(taker));
        if (value < taker.value) {
            taker.value = value;
            taker.site = site;
            changed_[leaf] = 1;
        }
    }
    /// Offers a site to a leaf and those beside it.
    void offerAround(std::uint32_t leaf, std::uint32_t site) {
        offer(leaf, site);
        for (const std::uint32_t beside : neighbours_.at(leaf)) {
            offer(beside, site);
        }
        if (leaves_[leaf].site == site) {
            changed_[leaf] = 0; // those beside it have been offered its winner
        }
    }

    /// Offers winners to the leaves beside theirs, in passes forward and back through the leaves, which keeps
    /// neighbours close in memory: on coasts, three times as fast as in order of increasing value, as in Dijkstra's
    /// algorithm.
    void spread() {
        const auto count = static_cast<std::uint32_t>(leaves_.size());
        bool any = true;
        const auto offerOn = [&](std::uint32_t leaf) {
            if (changed_[leaf] != 0) {
                changed_[leaf] = 0;
                any = true;
                for (const std::uint32_t beside : neighbours_.at(leaf)) {
                    offer(beside, leaves_[leaf].site);
                }
            }
        };
        while (any) {
            any = false;
            for (std::uint32_t leaf = 0; leaf < count; ++leaf) {
                offerOn(leaf);
            }
            for (std::uint32_t leaf = count; leaf-- > 0;) {
                offerOn(leaf);
            }
        }
    }

    void fill(std::uint32_t index) {
        const Leaf &leaf = leaves_[index];
        const double span = static_cast<double>(1U << leaf.level);
        gatherCompetitors(index, 0.70711 * span * tree_.unit_);
        if (competitors_.size() > kFew && isSmooth(leaf.x, leaf.y, span, kTolerance)) {
            storeSmooth(leaf.slot, corners_);
            return;
        }
        if (competitors_.size() > kLongestList) {
            std::nth_element(competitors_.begin(), competitors_.begin() + kLongestList, competitors_.end(),
                             [](const Competitor &p, const Competitor &q) {
                                 return p.value != q.value ? p.value < q.value : p.site < q.site;
                             });
            competitors_.resize(kLongestList);
        }
        storeList(leaf.slot, leaf.x, leaf.y, span);
    }
    /// Gathers the sites that may win within `reach` of the centre of a leaf.
    void gatherCompetitors(std::uint32_t index, double reach) {
        const Leaf &leaf = leaves_[index];
        const Vec2 centre = centreOf(leaf);
        const std::span<const std::uint32_t> own = own_.at(index);
        candidates_.assign(own.begin(), own.end());
        candidates_.push_back(leaf.site);
        for (const std::uint32_t beside : neighbours_.at(index)) {
            const std::uint32_t site = leaves_[beside].site;
            if (site != leaf.site && site != candidates_.back()) { // neighbours mostly have the same winner
                candidates_.push_back(site);
            }
        }
        competitors_.clear();
        if (candidates_.size() == 1) {
            competitors_.push_back({leaf.site, leaf.value});
            return;
        }
        std::sort(candidates_.begin(), candidates_.end());
        candidates_.erase(std::unique(candidates_.begin(), candidates_.end()), candidates_.end());
        double minimum = std::numeric_limits<double>::infinity();
        for (const std::uint32_t site : candidates_) {
            competitors_.push_back({site, tree_.sites_[site].at(centre)});
            minimum = std::min(minimum, competitors_.back().value);
        }
        const double change = 2.0 * tree_.sites_.front().growth * reach;
        std::erase_if(competitors_, [&](const Competitor &c) { return c.value - minimum > change; });
        if (competitors_.size() > 2) {
            dropParallel(centre, reach);
        }
    }

    double cellsPerSize_;
    std::size_t maxCells_ = kMaxCells;
    std::array<std::vector<Split>, SiteTree::kBits + 1> splits_; ///< cells that were split, by level
    std::vector<std::uint8_t> levels_;                           ///< per site: of the cells along it
    std::vector<Leaf> leaves_;
    Rows neighbours_, own_;
    std::vector<std::uint8_t> changed_; ///< per leaf: its winner has not been offered to its neighbours yet
    std::vector<std::uint32_t> candidates_;
};

bool canSpread(std::span<const SizeSite> sites) {
    return std::all_of(sites.begin(), sites.end(),
                       [&](const SizeSite &s) { return s.growth > 0.0 && s.growth == sites.front().growth; });
}

std::optional<SiteTree> spreadSites(std::vector<SizeSite> sites, const Box2 &box, double cellsPerSize,
                                    const Progress &progress) {
    return SiteSpreader(std::move(sites), box, cellsPerSize).run(progress);
}

} // namespace forefront
