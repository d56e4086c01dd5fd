#pragma once

#include "core/engine/spacing/sites/site_set.hpp"
#include "core/engine/spacing/sites/site_tree.hpp"
#include "core/engine/spacing/sites/site_words.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <memory>
#include <vector>

namespace forefront {

/// A field that is also limited by Domain::curveTolerance: beside a curve that chords of its size would not follow
/// closely enough, it is the length of those that do, growing by the gradation.
class ToleranceField final : public SpacingField {
  public:
    /// Returns `others`, the spacing by all other rules of `spec`, limited by the tolerance; `others` itself if no
    /// curve limits it. Error: cancelled.
    static Result<std::shared_ptr<const SpacingField>> limit(std::shared_ptr<const SpacingField> others,
                                                             const SpacingSpec &spec, const Domain &domain,
                                                             const Progress &progress);

    double at(Vec2 p) const override;
    void atMany(std::span<const Vec2> points, std::span<double> rho) const override;
    SpacingSample sample(Vec2 p) const override;
    double minimum() const override;
    double maximum() const override { return others_->maximum(); }

  private:
    ToleranceField(std::shared_ptr<const SpacingField> others, SiteTree sites, std::vector<SiteLabel> labels);

    std::shared_ptr<const SpacingField> others_;
    SiteTree sites_;
    std::vector<SiteLabel> labels_;
    SiteWords words_;
};

} // namespace forefront
