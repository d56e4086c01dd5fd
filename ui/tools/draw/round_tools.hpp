#pragma once

#include "ui/tools/common/drawing_tool.hpp"

#include <vector>

namespace forefront {

/// Draws a regular polygon from its centre to a corner.
class RegularPolygonTool final : public DrawingTool {
  public:
    using DrawingTool::DrawingTool;

    const char *id() const override { return "regular"; }
    const char *name() const override { return "Regular polygon"; }
    const char *icon() const override;
    int key() const override { return 'H'; }
    void drawOptions(Shell &context, ui::Flow &flow) override;
    bool hasOptions(const Shell &) const override { return true; }
    std::string statusText(const Shell &context) const override;

  protected:
    void place(Vec2 at, Shell &context) override;
    std::string_view goal() const override { return centre_ ? "draw the polygon" : "place the centre"; }
    void drawSketch(CanvasPainter &painter, Shell &context) override;
    std::optional<Vec2> anchor() const override { return centre_; }
    void cancel() override { centre_.reset(); }
    bool dragPlaces() const override { return true; }
    std::span<const EntryField> entryFields() const override;
    bool describePath(InferenceQuery &query) const override {
        if (centre_) {
            query.starts = {*centre_};
        }
        return true;
    }
    void keepFormulas(const Shape &drawn, const Keep &keep) const override;

  private:
    /// Returns the first corner that a click would place, given the typed numbers.
    Vec2 firstCorner(Vec2 at) const;
    std::vector<Vec2> corners(Vec2 first) const;

    int sides_ = 6;
    std::optional<Vec2> centre_;
};

} // namespace forefront
