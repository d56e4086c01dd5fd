#include "ui/canvas/legend.hpp"
#include "ui/gl/gl_kit.hpp"
#include "ui/layers/layers.hpp"
#include "ui/style/colour_map.hpp"
#include "ui/style/spacing_tint.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

class SpacingLayer final : public Layer {
  public:
    const char *id() const override { return "size"; }
    const char *name() const override { return "Spacing \xcf\x81"; }

    std::uint64_t stillVersion(const LayerFrame &frame) const override {
        // The preview, whose spacing sets the range, may arrive a frame later than its raster.
        return reinterpret_cast<std::uintptr_t>(frame.raster.get()) ^ (frame.preview.revision << 32);
    }

    void drawStill(const LayerFrame &frame) override {
        if (!take(frame)) {
            return;
        }
        const FieldTint tint{.box = shown_->box,
                             .columns = shown_->columns,
                             .rows = shown_->rows,
                             .logRho = &logRho_,
                             .version = version_,
                             .minimum = std::log(minimum_),
                             .maximum = std::log(maximum_),
                             .levels = levels_,
                             .contourWidth = 1.25 * frame.scale,
                             .opacity = spacingTint(frame.theme.kind)};
        frame.gl.drawField(*frame.preview.domain, frame.preview.revision, frame.camera, frame.area(frame.theme.domain),
                           &tint);
    }

    bool coloursByValue() const override { return true; }
    bool hasLegend() const override { return true; }
    bool drawLegend(CanvasPainter &painter, const LayerFrame &frame, Pixel corner) override {
        if (!shown_ || shown_->rho.empty()) {
            return false;
        }
        drawColourBar(painter, frame.theme, frame.fonts, corner,
                      {.title = "node spacing \xcf\x81",
                       .map = spacingColour,
                       .ticks = uniform_ ? std::vector<LegendTick>{{0.5, ui::number(0.5 * maximum_, 3)}}
                                         : logarithmicTicks(minimum_, maximum_, 5),
                       .opacity = spacingTint(frame.theme.kind)});
        return true;
    }

  private:
    /// Uses a new raster if there is one. Returns false if there is no raster at all.
    bool take(const LayerFrame &frame) {
        if (frame.raster != shown_) {
            shown_ = frame.raster;
            ++version_;
            logRho_.resize(shown_->rho.size());
            std::transform(shown_->rho.begin(), shown_->rho.end(), logRho_.begin(),
                           [](float rho) { return std::log(std::max(rho, 1e-30F)); });
        }
        if (shown_->rho.empty() || !frame.preview.spacing || !frame.preview.domain) {
            return false;
        }
        // The range is that of the whole domain, not of the part in view, so that colours do not change while panning.
        minimum_ = frame.preview.spacing->minimum();
        maximum_ = frame.preview.spacing->maximum(); // often that of a corner outside the domain
        if (frame.preview.largestSpacing > 0.0) {
            maximum_ = std::max(minimum_, std::min(maximum_, frame.preview.largestSpacing));
        }
        uniform_ = maximum_ < 1.02 * minimum_;
        if (uniform_) {
            minimum_ *= 0.5; // one colour, from the middle of the map
            maximum_ *= 2.0;
        }
        levels_.clear();
        for (const double value :
             uniform_ ? std::vector<double>() : contourValues(minimum_, maximum_, FieldTint::kMaxLevels)) {
            levels_.push_back(static_cast<float>(std::log(value)));
        }
        return true;
    }

    std::shared_ptr<const SpacingRaster> shown_;
    std::vector<float> logRho_;
    std::vector<float> levels_; ///< ln ρ of the contour lines
    std::uint64_t version_ = 0;
    double minimum_ = 1.0, maximum_ = 2.0;
    bool uniform_ = false; ///< ρ is the same everywhere
};

} // namespace

std::unique_ptr<Layer> makeSpacingLayer() {
    return std::make_unique<SpacingLayer>();
}

} // namespace forefront
