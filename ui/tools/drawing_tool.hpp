#pragma once

#include "ui/parts/tool.hpp"
#include "ui/tools/numeric_entry.hpp"
#include "ui/workspace/edit_state.hpp"

#include <memory>
#include <optional>
#include <span>

namespace forefront {

/// Base of all drawing tools: snapping with feedback, typed numbers, click or drag, Enter, Esc, Backspace.
class DrawingTool : public Tool {
  public:
    explicit DrawingTool(std::shared_ptr<EditState> state) : state_(std::move(state)) {}

    bool handle(const CanvasEvent &event, Shell &context) final;
    void drawOverlay(CanvasPainter &painter, Shell &context) final;
    void deactivate(Shell &context) override;
    CursorShape cursor() const override { return CursorShape::Crosshair; }

  protected:
    /// Takes a node given by a click, a typed number or the end of a drag.
    virtual void place(Vec2 at, Shell &context) = 0;
    /// Draws the unfinished shape.
    virtual void drawSketch(CanvasPainter &painter, Shell &context) = 0;
    /// The last node placed, while a shape is unfinished.
    virtual std::optional<Vec2> anchor() const { return std::nullopt; }
    /// Enter, double-click or a change of tool: makes a shape of the nodes placed so far, if they suffice.
    virtual void finish(Shell &) {}
    virtual void cancel() {}
    /// Removes the last node (Backspace). False if there is none.
    virtual bool removeLast() { return false; }
    /// True if releasing a drag places a second node.
    virtual bool dragPlaces() const { return false; }
    /// A place of the tool's own (the first node of a path) to snap to before all others.
    virtual std::optional<Vec2> ownSnap(Vec2, const Shell &) const { return std::nullopt; }
    /// Whether Shift constrains the angle; false if the tool gives Shift another meaning.
    virtual bool shiftIsAngle() const { return true; }
    /// The quantities that can be typed now, in the order of Tab: coordinates before the first node, then distance and
    /// angle.
    virtual std::span<const EntryField> entryFields() const;
    /// The place that a typed pair stands for.
    virtual Vec2 typedPlace(const TypedPair &pair) const;

    bool inProgress() const { return anchor().has_value(); }
    /// Adds a shape, selects it and clears the typed numbers.
    bool commitShape(Shell &context, Shape shape, const std::string &label);
    /// Labels the pointer with `text` and with the numbers being typed.
    void drawMeasure(CanvasPainter &painter, Shell &context, const std::string &text) const;

    std::shared_ptr<EditState> state_;
    NumericEntry entry_;
    Snapped pointer_;   ///< where a click would place a node now
    bool over_ = false; ///< the pointer is over the canvas
    Modifiers modifiers_;

  private:
    bool press(const CanvasEvent &event, Shell &context);
    bool typed(const CanvasEvent &event, Shell &context);
    void follow(const CanvasEvent &event, Shell &context);

    Vec2 pressPixel_, place_;
};

} // namespace forefront
