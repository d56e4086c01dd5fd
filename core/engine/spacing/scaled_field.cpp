#include "core/engine/spacing/scaled_field.hpp"

#include "core/engine/base/assert.hpp"

#include <utility>

namespace forefront {
namespace {

class ScaledField final : public SpacingField {
  public:
    ScaledField(std::shared_ptr<const SpacingField> field, double factor) : field_(std::move(field)), factor_(factor) {
        describeAs(*field_);
    }

    double at(Vec2 p) const override { return factor_ * field_->at(p); }
    void atMany(std::span<const Vec2> points, std::span<double> rho) const override {
        field_->atMany(points, rho);
        for (double &value : rho) {
            value *= factor_;
        }
    }
    SpacingSample sample(Vec2 p) const override {
        SpacingSample sample = field_->sample(p);
        sample.rho *= factor_;
        if (sample.runnerUp) {
            sample.runnerUp->rho *= factor_;
        }
        return sample;
    }
    double minimum() const override { return factor_ * field_->minimum(); }
    double maximum() const override { return factor_ * field_->maximum(); }

  private:
    std::shared_ptr<const SpacingField> field_;
    double factor_;
};

} // namespace

std::shared_ptr<const SpacingField> scaledField(std::shared_ptr<const SpacingField> field, double factor) {
    FOREFRONT_ASSERT(factor > 0.0);
    return std::make_shared<ScaledField>(std::move(field), factor);
}

} // namespace forefront
