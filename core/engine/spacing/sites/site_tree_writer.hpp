#pragma once

#include "core/engine/spacing/sites/site_tree.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace forefront {

/// Lays out the table of a SiteTree and writes its leaves; common to the two ways of building one.
class SiteTreeWriter {
  protected:
    /// A site that may win in a cell.
    struct Competitor {
        std::uint32_t site = 0;
        double value = 0.0; ///< at the centre of the cell
    };
    static constexpr int kTableBits = 6;
    static constexpr std::uint32_t kTableCells = 1U << kTableBits;
    static constexpr int kTopLevel = SiteTree::kBits + kTableBits;
    /// With more competitors, the smoothness of their minimum is tested less thoroughly.
    static constexpr std::size_t kLongestTested = 48;

    SiteTreeWriter(std::vector<SizeSite> sites, const Box2 &box);

    Vec2 placeOf(double x, double y) const { return tree_.corner_ + tree_.unit_ * Vec2{x, y}; }
    const SizeSite &site(const Competitor &competitor) const { return tree_.sites_[competitor.site]; }
    double minimumAt(Vec2 p) const {
        double value = std::numeric_limits<double>::infinity();
        for (const Competitor &competitor : competitors_) {
            value = std::min(value, site(competitor).at(p));
        }
        return value;
    }

    /// Drops the competitors that the best one beats in the whole cell, since both are seen in nearly the same
    /// direction.
    void dropParallel(Vec2 centre, double reach);
    /// Returns true if bilinear values are within a relative `tolerance` of the minimum of the competitors in the whole
    /// cell; corners_ then holds the minima at its corners. `x` and `y` are its lower left corner and `span` its side,
    /// in units.
    bool isSmooth(double x, double y, double span, double tolerance);
    /// Returns the minima at the corners of a cell: lower left, lower right, upper left, upper right.
    std::array<double, 4> minimaAtCorners(double x, double y, double span) const;
    void storeList(std::uint32_t slot, double x, double y, double span);
    void storeSmooth(std::uint32_t slot, const std::array<double, 4> &values);
    /// Returns an upper bound of the minimum of the competitors in a cell: the smallest of their maxima.
    double maximumIn(double x, double y, double span) const;
    SiteTree take();

    SiteTree tree_;
    std::uint32_t rows_ = 1;
    std::vector<Competitor> competitors_;
    std::array<double, 4> corners_{}; ///< of the last smooth cell
};

} // namespace forefront
