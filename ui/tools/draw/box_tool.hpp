#pragma once

#include "ui/tools/common/drawing_tool.hpp"

#include <string>

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
    std::string_view goal() const override;
    void drawSketch(CanvasPainter &painter, Shell &context) override;
    std::optional<Vec2> anchor() const override { return first_; }
    void cancel() override { first_.reset(); }
    bool dragPlaces() const override { return true; }
    bool shiftIsAngle() const override { return !isBox(); }
    /// A corner or a centre may be level with other nodes; a point on a circle may give it the radius of another one.
    bool describePath(InferenceQuery &query) const override {
        query.round = isBox() ? std::nullopt : first_;
        return true;
    }
    std::span<const EntryField> entryFields() const override;
    Vec2 typedPlace(const TypedPair &pair) const override;
    PlaceFormula typedFormula(Vec2 at) const override;
    void keepFormulas(const Shape &drawn, const Keep &keep) const override;

  private:
    bool isBox() const { return kind_ != ShapeKind::Circle; }
    /// Returns the corner that a click places.
    Vec2 corner(Vec2 at) const;
    /// An extent of the box: from the first corner to the second one, as numbers and as expressions.
    struct Side {
        double from, to;
        std::string fromText, toText;
        std::string size; ///< expression of the width or height that was typed; empty: none
        bool placed;      ///< an expression was typed for the place of the second corner
    };
    /// Returns the expressions typed for the second corner; empty ones where nothing was.
    PlaceFormula cornerFormula() const;
    Side sideOf(bool across, Vec2 second) const;
    /// Returns the expression typed for the width or height, as a positive one; empty if it is a plain number.
    std::string typedSize(bool across) const;
    /// Returns the shape between the first click and another.
    Shape shapeTo(Vec2 second) const;

    ShapeKind kind_;
    std::optional<Vec2> first_;
    double radius_ = 0.0; ///< of the corners of the next rectangle
    std::string radiusFormula_;
};

} // namespace forefront
