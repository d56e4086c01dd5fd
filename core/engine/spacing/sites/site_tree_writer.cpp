#include "core/engine/spacing/sites/site_tree_writer.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {
namespace {

/// Value and slope of a site, and how far the slope may turn within reach: the distance to a convex shape at
/// distance d has second derivatives of at most 1/d.
struct Slope {
    Vec2 gradient;
    double turn = 0.0; ///< infinite where the reach touches the site
};
Slope slopeOf(const SizeSite &s, Vec2 centre, double reach) {
    const Vec2 away = centre - s.nearest(centre);
    const double d = length(away);
    if (d <= reach + s.radius) {
        return {{}, std::numeric_limits<double>::infinity()};
    }
    return {(s.growth / d) * away, s.growth * reach / (d - reach)};
}

} // namespace

SiteTreeWriter::SiteTreeWriter(std::vector<SizeSite> sites, const Box2 &box) {
    tree_.sites_ = std::move(sites);
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

void SiteTreeWriter::dropParallel(Vec2 centre, double reach) {
    const Competitor best = *std::min_element(competitors_.begin(), competitors_.end(),
                                              [](const auto &p, const auto &q) { return p.value < q.value; });
    const Slope slope = slopeOf(site(best), centre, reach);
    if (!std::isfinite(slope.turn)) {
        return;
    }
    std::erase_if(competitors_, [&](const Competitor &c) {
        const double lead = c.value - best.value;
        if (lead <= reach * slope.turn) { // most of them; includes the best one
            return false;
        }
        const Slope other = slopeOf(site(c), centre, reach);
        return lead > reach * (length(other.gradient - slope.gradient) + slope.turn + other.turn);
    });
}

bool SiteTreeWriter::isSmooth(double x, double y, double span, double tolerance) {
    const double size = span * tree_.unit_;
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
    if (growth * size <= tolerance * low) { // cannot change more than the tolerance
        corners_ = minimaAtCorners(x, y, span);
        return true;
    }
    // A kink at a site could hide between the samples.
    if (touched || (competitors_.size() > kLongestTested && growth * size > 0.5 * low)) {
        return false;
    }
    const double h = 0.5 * span;
    corners_ = minimaAtCorners(x, y, span);
    const auto [a, b, c, d] = corners_;
    const auto near = [tolerance](double exact, double interpolated) {
        return std::fabs(exact - interpolated) <= tolerance * exact;
    };
    return near(middle, 0.25 * (a + b + c + d)) && near(minimumAt(placeOf(x + h, y)), 0.5 * (a + b)) &&
           near(minimumAt(placeOf(x, y + h)), 0.5 * (a + c)) &&
           near(minimumAt(placeOf(x + span, y + h)), 0.5 * (b + d)) &&
           near(minimumAt(placeOf(x + h, y + span)), 0.5 * (c + d));
}

void SiteTreeWriter::storeList(std::uint32_t slot, double x, double y, double span) {
    const double reach = 0.70711 * (span * tree_.unit_);
    // The likeliest winner first; ties are broken by index, so that the order depends only on the sites.
    std::sort(competitors_.begin(), competitors_.end(), [](const Competitor &p, const Competitor &q) {
        return p.value != q.value ? p.value < q.value : p.site < q.site;
    });
    tree_.cells_[slot] = static_cast<std::uint32_t>(tree_.lists_.size());
    tree_.lists_.push_back(static_cast<std::uint32_t>(competitors_.size()));
    for (const Competitor &competitor : competitors_) {
        tree_.lists_.push_back(competitor.site);
        const SizeSite &s = site(competitor);
        tree_.minimum_ = std::min(tree_.minimum_, std::max(s.size, competitor.value - s.growth * reach));
    }
    // No value in the cell exceeds that of its best site at the centre by more than this, rounding included.
    const Competitor &best = competitors_.front();
    if (1.000001 * (best.value + site(best).growth * reach) > tree_.maximum_) {
        tree_.maximum_ = std::max(tree_.maximum_, maximumIn(x, y, span));
    }
}

double SiteTreeWriter::maximumIn(double x, double y, double span) const {
    double high = std::numeric_limits<double>::infinity();
    for (const Competitor &competitor : competitors_) {
        double maximum = 0.0; // distance to a convex shape is maximal at a corner
        for (std::uint32_t corner = 0; corner < 4; ++corner) {
            const Vec2 place = placeOf(x + (corner & 1U) * span, y + (corner >> 1) * span);
            maximum = std::max(maximum, site(competitor).at(place));
        }
        high = std::min(high, maximum);
    }
    return high;
}

std::array<double, 4> SiteTreeWriter::minimaAtCorners(double x, double y, double span) const {
    return {minimumAt(placeOf(x, y)), minimumAt(placeOf(x + span, y)), minimumAt(placeOf(x, y + span)),
            minimumAt(placeOf(x + span, y + span))};
}

void SiteTreeWriter::storeSmooth(std::uint32_t slot, const std::array<double, 4> &values) {
    SiteTree::Corners corners{};
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
        corners[corner] = static_cast<float>(values[corner] / tree_.scale_);
        tree_.minimum_ = std::min(tree_.minimum_, tree_.scale_ * corners[corner]);
        tree_.maximum_ = std::max(tree_.maximum_, tree_.scale_ * corners[corner]);
    }
    tree_.cells_[slot] = static_cast<std::uint32_t>(tree_.smooth_.size()) | SiteTree::kSmooth;
    tree_.smooth_.push_back(corners);
}

SiteTree SiteTreeWriter::take() {
    tree_.cells_.shrink_to_fit();
    tree_.lists_.shrink_to_fit();
    tree_.smooth_.shrink_to_fit();
    return std::move(tree_);
}

} // namespace forefront
