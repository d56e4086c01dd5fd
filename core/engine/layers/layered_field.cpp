#include "core/engine/layers/layered_field.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/spacing/sites/site_tree.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

namespace {

class LayeredField final : public SpacingField {
  public:
    LayeredField(std::shared_ptr<const SpacingField> others, SiteTree sites, const char *what)
        : others_(std::move(others)), sites_(std::move(sites)), what_(what) {
        describeAs(*others_);
    }

    double at(Vec2 p) const override { return std::min(others_->at(p), sites_.at(p)); }
    void atMany(std::span<const Vec2> points, std::span<double> rho) const override {
        others_->atMany(points, rho);
        sites_.lowerMany(points, rho);
    }
    SpacingSample sample(Vec2 p) const override {
        SpacingSample sample = others_->sample(p);
        if (const double rho = sites_.at(p); rho < sample.rho) {
            const SpacingRunnerUp next{sample.rho, sample.describe};
            sample = {rho, SpacingOrigin::Boundary, 0, what_, next};
        }
        return sample;
    }
    double minimum() const override { return std::min(others_->minimum(), sites_.minimum()); }
    double maximum() const override { return std::min(others_->maximum(), sites_.maximum()); }

  private:
    std::shared_ptr<const SpacingField> others_;
    SiteTree sites_;
    const char *what_;
};

} // namespace

Result<std::shared_ptr<const SpacingField>> layeredField(std::shared_ptr<const SpacingField> others,
                                                         std::vector<SizeSite> sites, const Box2 &box,
                                                         const Progress &progress, const char *what) {
    if (sites.empty()) {
        return others;
    }
    SpreadOptions spread;
    spread.many = kManySites;
    std::optional<SiteTree> tree = SiteTree::build(std::move(sites), box, progress, spread);
    if (!tree) {
        return cancelled("meshing");
    }
    return std::shared_ptr<const SpacingField>(
        std::make_shared<LayeredField>(std::move(others), std::move(*tree), what));
}

} // namespace forefront
