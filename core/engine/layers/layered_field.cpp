#include "core/engine/layers/layered_field.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/spacing/sites/site_tree.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

namespace {

class LayeredField final : public SpacingField {
  public:
    LayeredField(std::shared_ptr<const SpacingField> others, SiteTree tops)
        : others_(std::move(others)), tops_(std::move(tops)) {
        addNotes(others_->notes());
    }

    double at(Vec2 p) const override { return std::min(others_->at(p), tops_.at(p)); }
    void atMany(std::span<const Vec2> points, std::span<double> rho) const override {
        others_->atMany(points, rho);
        tops_.lowerMany(points, rho);
    }
    SpacingSample sample(Vec2 p) const override {
        SpacingSample sample = others_->sample(p);
        if (const double rho = tops_.at(p); rho < sample.rho) {
            const SpacingRunnerUp next{sample.rho, sample.describe};
            sample = {rho, SpacingOrigin::Boundary, 0, "the last boundary layer", next};
        }
        return sample;
    }
    double minimum() const override { return std::min(others_->minimum(), tops_.minimum()); }
    double maximum() const override { return std::min(others_->maximum(), tops_.maximum()); }

  private:
    std::shared_ptr<const SpacingField> others_;
    SiteTree tops_;
};

} // namespace

Result<std::shared_ptr<const SpacingField>> layeredField(std::shared_ptr<const SpacingField> others,
                                                         std::vector<SizeSite> tops, const Box2 &box,
                                                         const Progress &progress) {
    if (tops.empty()) {
        return others;
    }
    SpreadOptions spread;
    spread.many = kManySites;
    std::optional<SiteTree> tree = SiteTree::build(std::move(tops), box, progress, spread);
    if (!tree) {
        return cancelled("meshing");
    }
    return std::shared_ptr<const SpacingField>(std::make_shared<LayeredField>(std::move(others), std::move(*tree)));
}

} // namespace forefront
