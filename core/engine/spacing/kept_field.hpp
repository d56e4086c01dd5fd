#pragma once

#include "core/engine/domain/inside_test.hpp"
#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/spacing/sites/site_tree.hpp"
#include "core/engine/spacing/sites/site_words.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace forefront {

/// A field that is larger beside given segments that are kept and longer than its size. No element of the size asked
/// for can stand on such a segment: at the segment, the size is a part of its length, and falls with the distance, so
/// that elements of good shape lead to the size asked for.
class KeptField final : public SpacingField {
  public:
    /// Returns `asked`, the spacing by all rules, raised beside long segments, with a note of where it is; `asked`
    /// itself if no segment is too long. Error: cancelled.
    static Result<std::shared_ptr<const SpacingField>> raise(std::shared_ptr<const SpacingField> asked,
                                                             const Domain &domain, const Progress &progress);

    double at(Vec2 p) const override { return raised(p, asked_->at(p)); }
    void atMany(std::span<const Vec2> points, std::span<double> rho) const override;
    SpacingSample sample(Vec2 p) const override;
    double minimum() const override { return asked_->minimum(); }
    double maximum() const override;

    /// Returns the specified size, without the limits from undivided segments.
    double asked(Vec2 p) const { return asked_->at(p); }
    /// Returns the long segments between which the size asked for would be reached nowhere, at their indices in the
    /// domain. Beside them the size falls as fast as elements can follow, and only with given nodes: see
    /// addGradedNodes().
    const std::vector<std::uint32_t> &crowded() const { return crowded_; }
    /// Maximum fall of the size beside crowded segments, per unit of distance.
    static constexpr double kSteepestFall = 2.5;

  private:
    explicit KeptField(std::shared_ptr<const SpacingField> asked) : asked_(std::move(asked)) {}

    double raised(Vec2 p, double asked) const;
    bool isCrowded(std::size_t item, const InsideTest &inside) const;
    double crowdedFall(std::size_t item, const InsideTest &inside) const;
    void findCrowded(const Domain &domain, const Progress &progress);
    void note(double ratio, Vec2 at, double reach);

    std::shared_ptr<const SpacingField> asked_;
    std::vector<SizeSite> long_;         ///< segments that are too long; their growth is negative
    std::vector<std::uint32_t> source_;  ///< per long segment: its index in the domain
    std::vector<std::uint32_t> crowded_; ///< indices in the domain
    BoxTree reach_;                      ///< boxes in which each long segment raises the size
    /// All segments: near a short one, a long one beside it does not raise the size above the short one's.
    std::optional<SiteTree> lengths_;
    SiteWords words_;
};

} // namespace forefront
