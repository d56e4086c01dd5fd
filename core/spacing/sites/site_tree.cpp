#include "core/spacing/sites/site_tree.hpp"

#include "core/base/assert.hpp"

namespace forefront {

/// Builds level by level, so that when memory runs short, the tree is equally deep everywhere.
class SiteTreeBuilder {
  public:
    SiteTreeBuilder(std::vector<SizeSite> sites, const Box2 &box) {
        tree_.sites_ = std::move(sites);
        aims_ = tree_.sites_.size() > kManySites ? kAimsOfMany : kAims;
        maxCells_ = std::max(kMaxCells, kMaxCellsPerSite * tree_.sites_.size());
        maxEntries_ = std::max(kMaxEntries, kMaxEntriesPerSite * tree_.sites_.size());
        const double extent = std::max({box.size().x, box.size().y, 1e-300});
        tree_.corner_ = box.min;
        tree_.scale_ = extent;
        tree_.unit_ = extent / static_cast<double>(1U << kTopLevel);
        tree_.toUnits_ = 1.0 / tree_.unit_;
        const auto cellsAcross = [&](double size) {
            const double cells = std::ceil(size * tree_.toUnits_ / static_cast<double>(1U << SiteTree::kBits));
            return static_cast<std::uint32_t>(std::clamp(cells, 1.0, static_cast<double>(kTableCells)));
        };
        tree_.columns_ = cellsAcross(box.size().x);
        rows_ = cellsAcross(box.size().y);
        const auto span = [](std::uint32_t cells) {
            return std::nextafter(static_cast<double>(cells) * (1U << SiteTree::kBits), 0.0);
        };
        tree_.spanX_ = span(tree_.columns_);
        tree_.spanY_ = span(rows_);
        tree_.cells_.assign(static_cast<std::size_t>(tree_.columns_) * rows_, 0);
        tree_.minimum_ = std::numeric_limits<double>::infinity();
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
        tree_.cells_.shrink_to_fit();
        tree_.lists_.shrink_to_fit();
        tree_.smooth_.shrink_to_fit();
        return std::move(tree_);
    }

  private:
    static constexpr int kTableBits = 6;
    static constexpr std::uint32_t kTableCells = 1U << kTableBits;
    static constexpr int kTopLevel = SiteTree::kBits + kTableBits;
    /// What building aims at: `shortList` sites in a list, `thinning` per level and `tolerance` relative to the value.
    struct Aims {
        std::size_t shortList;
        double thinning, tolerance;
    };
    static constexpr Aims kAims{5, 4e-4, SiteTree::kTolerance};
    /// With many sites, building would take several times as long as meshing.
    static constexpr Aims kAimsOfMany{12, 6.4e-3, 2.0 * SiteTree::kTolerance};
    static constexpr std::size_t kLongestTested = 48;
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
    struct Competitor {
        std::uint32_t site = 0;
        double value = 0.0; ///< at the centre of the cell
    };

    void startAtRoot() {
        lists_.resize(tree_.sites_.size());
        for (std::size_t i = 0; i < lists_.size(); ++i) {
            lists_[i] = static_cast<std::uint32_t>(i);
        }
        cells_ = {Cell{0, 0, 0, 0, static_cast<std::uint32_t>(lists_.size())}};
    }
    Vec2 placeOf(double x, double y) const { return tree_.corner_ + tree_.unit_ * Vec2{x, y}; }
    const SizeSite &site(const Competitor &competitor) const { return tree_.sites_[competitor.site]; }
    double least(Vec2 p) const {
        double value = std::numeric_limits<double>::infinity();
        for (const Competitor &competitor : competitors_) {
            value = std::min(value, site(competitor).at(p));
        }
        return value;
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

    /// Value and slope of a site, and how far the slope may turn within reach: the distance to a convex shape at
    /// distance d has second derivatives of at most 1/d.
    struct Slope {
        Vec2 gradient;
        double turn = 0.0; ///< infinite where the reach touches the site
    };
    static Slope slopeOf(const SizeSite &s, Vec2 centre, double reach) {
        const Vec2 away = centre - s.nearest(centre);
        const double d = length(away);
        if (d <= reach + s.radius) {
            return {{}, std::numeric_limits<double>::infinity()};
        }
        return {(s.growth / d) * away, s.growth * reach / (d - reach)};
    }
    /// Sites seen in nearly the same direction keep their order: drops those that the best one beats in the whole cell.
    void dropParallel(Vec2 centre, double reach) {
        const Competitor best = *std::min_element(competitors_.begin(), competitors_.end(),
                                                  [](const auto &p, const auto &q) { return p.value < q.value; });
        const Slope slope = slopeOf(site(best), centre, reach);
        if (!std::isfinite(slope.turn)) {
            return;
        }
        std::erase_if(competitors_, [&](const Competitor &c) {
            if (c.site == best.site) {
                return false;
            }
            const Slope other = slopeOf(site(c), centre, reach);
            return c.value - best.value > reach * (length(other.gradient - slope.gradient) + slope.turn + other.turn);
        });
    }

    /// A far competitor as seen from the centre of a cell.
    struct Sight {
        Vec2 nearest;
        double distance = 0.0; ///< to the axis of the site
        double length = 0.0;   ///< of the site
        std::int32_t sector = -1;
    };
    /// Keeps the best one of many distant sites in the same direction. Of two sites whose nearest points lie e apart
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
            // The "diamond angle" in [0, 4): as good as an angle for telling directions apart.
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
            storeList(cell, span, reach);
        } else if (last || isSmooth(cell, span, size)) {
            storeSmooth(cell, span);
        } else {
            split(cell, level);
        }
    }

    /// True if bilinear values are good enough in the whole cell.
    bool isSmooth(const Cell &cell, double span, double size) const {
        double growth = 0.0;
        double low = std::numeric_limits<double>::infinity();
        double middle = std::numeric_limits<double>::infinity();
        bool touched = false;
        for (const Competitor &competitor : competitors_) {
            const SizeSite &s = site(competitor);
            growth = std::max(growth, s.growth);
            low = std::min(low, std::max(s.size, competitor.value - 0.70711 * size * s.growth));
            middle = std::min(middle, competitor.value);
            touched = touched || competitor.value - s.size <= 0.8 * size * s.growth;
        }
        if (growth * size <= aims_.tolerance * low) {
            return true; // cannot change more than the tolerance
        }
        // A kink at a site could hide between the samples.
        if (touched || (competitors_.size() > kLongestTested && growth * size > 0.5 * low)) {
            return false;
        }
        const double x = cell.x;
        const double y = cell.y;
        const double h = 0.5 * span;
        const double a = least(placeOf(x, y));
        const double b = least(placeOf(x + span, y));
        const double c = least(placeOf(x, y + span));
        const double d = least(placeOf(x + span, y + span));
        const auto near = [this](double exact, double interpolated) {
            return std::fabs(exact - interpolated) <= aims_.tolerance * exact;
        };
        return near(middle, 0.25 * (a + b + c + d)) && near(least(placeOf(x + h, y)), 0.5 * (a + b)) &&
               near(least(placeOf(x, y + h)), 0.5 * (a + c)) && near(least(placeOf(x + span, y + h)), 0.5 * (b + d)) &&
               near(least(placeOf(x + h, y + span)), 0.5 * (c + d));
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

    void storeList(const Cell &cell, double span, double reach) {
        // The likeliest winner first; ties by index keep the order independent of anything but the sites.
        std::sort(competitors_.begin(), competitors_.end(), [](const Competitor &p, const Competitor &q) {
            return p.value != q.value ? p.value < q.value : p.site < q.site;
        });
        tree_.cells_[cell.slot] = static_cast<std::uint32_t>(tree_.lists_.size());
        tree_.lists_.push_back(static_cast<std::uint32_t>(competitors_.size()));
        double high = std::numeric_limits<double>::infinity();
        for (const Competitor &competitor : competitors_) {
            tree_.lists_.push_back(competitor.site);
            const SizeSite &s = site(competitor);
            tree_.minimum_ = std::min(tree_.minimum_, std::max(s.size, competitor.value - s.growth * reach));
            double most = 0.0; // distance to a convex shape is maximal at a corner
            for (std::uint32_t corner = 0; corner < 4; ++corner) {
                most = std::max(most, s.at(placeOf(cell.x + (corner & 1U) * span, cell.y + (corner >> 1) * span)));
            }
            high = std::min(high, most);
        }
        tree_.maximum_ = std::max(tree_.maximum_, high);
    }
    void storeSmooth(const Cell &cell, double span) {
        SiteTree::Corners corners{};
        for (std::uint32_t corner = 0; corner < 4; ++corner) {
            const Vec2 place = placeOf(cell.x + (corner & 1U) * span, cell.y + (corner >> 1) * span);
            corners[corner] = static_cast<float>(least(place) / tree_.scale_);
            tree_.minimum_ = std::min(tree_.minimum_, tree_.scale_ * corners[corner]);
            tree_.maximum_ = std::max(tree_.maximum_, tree_.scale_ * corners[corner]);
        }
        tree_.cells_[cell.slot] = static_cast<std::uint32_t>(tree_.smooth_.size()) | SiteTree::kSmooth;
        tree_.smooth_.push_back(corners);
    }

    SiteTree tree_;
    std::uint32_t rows_ = 1;
    bool full_ = false;
    Aims aims_ = kAims;
    std::size_t maxCells_ = kMaxCells, maxEntries_ = kMaxEntries;
    std::vector<Cell> cells_; ///< cells of the current level, and their candidates
    std::vector<std::uint32_t> lists_;
    std::vector<Cell> nextCells_;
    std::vector<std::uint32_t> nextLists_;
    std::vector<Competitor> competitors_;
    std::vector<Competitor> crowd_; ///< the competitors before thinning, in step with sights_
    std::vector<Sight> sights_;
    std::vector<std::int32_t> bestOfSector_;
};

std::optional<SiteTree> SiteTree::build(std::vector<SizeSite> sites, const Box2 &box, const Progress &progress) {
    FOREFRONT_ASSERT(!sites.empty() && !box.empty());
    return SiteTreeBuilder(std::move(sites), box).run(progress);
}

std::size_t SiteTree::winner(Vec2 p) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < sites_.size(); ++i) {
        if (sites_[i].at(p) < sites_[best].at(p)) {
            best = i;
        }
    }
    return best;
}

std::size_t SiteTree::bytes() const {
    return sites_.size() * sizeof(SizeSite) + (cells_.size() + lists_.size()) * sizeof(std::uint32_t) +
           smooth_.size() * sizeof(Corners);
}

} // namespace forefront
