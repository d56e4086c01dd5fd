#pragma once

#include "core/engine/spacing/parts/paint/painted_part.hpp"
#include "core/engine/spacing/sites/site_tree.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <limits>
#include <memory>
#include <optional>

namespace forefront {

/// A field whose paint replaces other rules, see PaintedSpacing::replaces. Where nothing is painted it is the minimum
/// of all rules and the reach of the paint; where something is, the paint, limited by the rules of the boundary and of
/// regions, and by gradation from the spacing around the paint.
class ReplacedField final : public SpacingField {
  public:
    static Result<std::shared_ptr<const SpacingField>> build(const SpacingSpec &spec, const Domain &domain,
                                                             const Progress &progress);

    double at(Vec2 p) const override;
    void atMany(std::span<const Vec2> points, std::span<double> rho) const override;
    SpacingSample sample(Vec2 p) const override;
    double minimum() const override;
    double maximum() const override;

  private:
    explicit ReplacedField(PaintedPart paint) : paint_(std::move(paint)) {}

    bool painted(Vec2 p) const { return paint_.at(p) < std::numeric_limits<double>::infinity(); }
    double fromBorder(Vec2 p) const { return border_ ? border_->at(p) : std::numeric_limits<double>::infinity(); }

    std::shared_ptr<const SpacingField> others_; ///< all rules without the paint
    std::shared_ptr<const SpacingField> kept_;   ///< the paint, with the rules that it does not replace
    PaintedPart paint_;
    std::optional<SiteTree> border_; ///< from which the spacing around the paint limits it
    double largest_ = 0.0;           ///< painted value
    double farthest_ = 0.0;          ///< size of kept_ where it has no rule
};

} // namespace forefront
