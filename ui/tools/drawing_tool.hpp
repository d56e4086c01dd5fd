#pragma once

#include "ui/tools/edit_state.hpp"
#include "ui/tools/numeric_entry.hpp"
#include "ui/tools/tool.hpp"

#include <memory>
#include <optional>
#include <span>

namespace forefront {

/// What all drawing tools do alike: snapping with feedback, typed numbers, click or drag, Enter, Esc, Backspace.
class DrawingTool : public Tool {
  public:
    explicit DrawingTool(std::shared_ptr<EditState> state) : state_(std::move(state)) {}

    bool handle(const CanvasEvent &event, AppContext &context) final;
    void drawOverlay(CanvasPainter &painter, AppContext &context) final;
    void deactivate(AppContext &context) override;
    CursorShape cursor() const override { return CursorShape::Crosshair; }

  protected:
    /// A node given by a click, a typed number or the end of a drag.
    virtual void place(Vec2 at, AppContext &context) = 0;
    /// What is half done.
    virtual void drawSketch(CanvasPainter &painter, AppContext &context) = 0;
    /// The last node placed, while something is half done.
    virtual std::optional<Vec2> anchor() const { return std::nullopt; }
    /// Enter, double click, another tool: makes a shape of what there is, if it is enough for one.
    virtual void finish(AppContext &) {}
    virtual void cancel() {}
    /// Backspace. False: there was nothing to remove.
    virtual bool removeLast() { return false; }
    /// The end of a drag is a second click.
    virtual bool dragPlaces() const { return false; }
    /// Draws the pointer to a place of the tool's own (the first node of a path) before all others.
    virtual std::optional<Vec2> ownSnap(Vec2, const AppContext &) const { return std::nullopt; }
    /// Shift means more than an angle here: false leaves it to the tool.
    virtual bool shiftIsAngle() const { return true; }
    /// Where a typed pair is.
    virtual Vec2 typedPlace(const TypedPair &pair) const;

    bool inProgress() const { return anchor().has_value(); }
    /// Adds a shape, selects it, and forgets the numbers typed.
    bool commitShape(AppContext &context, Shape shape, const std::string &label);
    /// Chips with length and direction from the anchor beside the pointer.
    void drawMeasure(CanvasPainter &painter, AppContext &context, const std::string &text) const;

    std::shared_ptr<EditState> state_;
    NumericEntry entry_;
    Snapped pointer_;   ///< where a click would place a node now
    bool over_ = false; ///< the pointer is over the canvas
    Modifiers modifiers_;

  private:
    bool press(const CanvasEvent &event, AppContext &context);
    bool typed(const CanvasEvent &event, AppContext &context);
    void follow(const CanvasEvent &event, AppContext &context);

    Vec2 pressPixel_, place_;
};

} // namespace forefront
