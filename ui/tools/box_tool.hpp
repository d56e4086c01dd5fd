#pragma once

#include "ui/tools/drawing_tool.hpp"

namespace forefront {

/// Draws a rectangle or an ellipse from corner to corner, or a circle from its centre, by drag or by two clicks.
class BoxTool final : public DrawingTool {
  public:
    BoxTool(std::shared_ptr<EditState> state, ShapeKind kind) : DrawingTool(std::move(state)), kind_(kind) {}

    const char *id() const override;
    const char *name() const override;
    const char *icon() const override;
    int key() const override;
    void forget(Shell &context) override;
    void drawOptions(Shell &context, ui::Flow &flow) override;
    bool hasOptions(const Shell &) const override { return true; }
    std::string statusText(const Shell &context) const override;

  protected:
    void place(Vec2 at, Shell &context) override;
    void drawSketch(CanvasPainter &painter, Shell &context) override;
    std::optional<Vec2> anchor() const override { return first_; }
    void cancel() override { first_.reset(); }
    bool dragPlaces() const override { return true; }
    bool shiftIsAngle() const override { return !isBox(); }
    std::span<const EntryField> entryFields() const override;
    Vec2 typedPlace(const TypedPair &pair) const override;

  private:
    bool isBox() const { return kind_ != ShapeKind::Circle; }
    /// Returns the corner that a click places, given the typed width and height (negative: to the left, downwards), and
    /// Shift for a square.
    Vec2 corner(Vec2 at) const;
    /// Returns the shape between the first click and another.
    Shape shapeTo(Vec2 second) const;

    ShapeKind kind_;
    std::optional<Vec2> first_;
    double radius_ = 0.0; ///< of the corners of the next rectangle
};

} // namespace forefront
