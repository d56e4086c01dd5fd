#pragma once

#include "core/engine/geometry/curve.hpp"
#include "ui/tools/common/drawing_tool.hpp"

#include <string>
#include <vector>

namespace forefront {

/// Draws an arc of a circle by its ends and a point between them, or by its centre and its ends.
class ArcTool final : public DrawingTool {
  public:
    using DrawingTool::DrawingTool;

    const char *id() const override { return "arc"; }
    const char *name() const override { return "Inner arc"; }
    const char *icon() const override;
    int key() const override { return 'A'; }
    void drawOptions(Shell &context, ui::Flow &flow) override;
    bool hasOptions(const Shell &) const override { return true; }
    std::string statusText(const Shell &context) const override;

  protected:
    void place(Vec2 at, Shell &context) override;
    std::string_view goal() const override;
    void drawSketch(CanvasPainter &painter, Shell &context) override;
    std::optional<Vec2> anchor() const override;
    void cancel() override { places_.clear(); }
    bool removeLast() override;
    std::span<const EntryField> entryFields() const override;
    bool describePath(InferenceQuery &query) const override {
        query.starts = places_;
        query.round = byCentre() && places_.size() == 1 ? std::optional(places_.front()) : std::nullopt;
        return places_.size() < 2; // then the arc is on a circle
    }
    Vec2 fitted(Vec2 at) override;
    void keepFormulas(const Shape &drawn, const Keep &keep) const override;
    bool followsEntry() const override;

  private:
    bool byCentre() const { return state_->arcMode == ArcMode::Centre; }
    /// Returns the arc that a click at a point would complete, once two places are known.
    Curve completed(Vec2 at) const;
    std::string measure() const;

    std::vector<Vec2> places_;     ///< two ends, or the centre and where the arc begins
    double turn_ = 0.0;            ///< of the arc about its centre, as the hand has moved, in radians
    PlaceFormula centre_, radius_; ///< expressions that were typed; that of the radius is `x`
};

} // namespace forefront
