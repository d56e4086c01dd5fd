#pragma once

#include "core/drawing/commands/inferred_constraints.hpp"
#include "core/drawing/formulas/place_formulas.hpp"
#include "ui/parts/tool.hpp"
#include "ui/tools/common/numeric_entry.hpp"
#include "ui/workspace/edit_state.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// Base of all drawing tools: snapping with feedback, typed numbers, click or drag, Enter, Esc, Backspace.
class DrawingTool : public Tool {
  public:
    explicit DrawingTool(std::shared_ptr<EditState> state) : state_(std::move(state)) {}

    bool handle(const CanvasEvent &event, Shell &context) final;
    void drawOverlay(CanvasPainter &painter, Shell &context) final;
    void deactivate(Shell &context) override;
    void forget(Shell &context) override;
    /// Removes the last node, or cancels a shape that has only one.
    bool undo(Shell &context) override;
    std::string undoLabel(const Shell &) const override { return hasBegun() ? "last point" : ""; }
    std::string typingHint(const Shell &context) const override;
    /// Returns the line below the typed numbers: what Tab and Enter do. Empty while none is typed.
    std::string typingPrompt() const { return entry_.prompt(goal()); }
    CursorShape cursor() const override { return CursorShape::Crosshair; }

  protected:
    /// Handles a node placed by a click, a typed number or the end of a drag.
    virtual void place(Vec2 at, Shell &context) = 0;
    /// Returns what Enter does once the typed numbers determine the next node, such as "place the centre".
    virtual std::string_view goal() const { return "place the node"; }
    /// Draws the unfinished shape.
    virtual void drawSketch(CanvasPainter &painter, Shell &context) = 0;
    /// Returns the last node placed, while a shape is unfinished.
    virtual std::optional<Vec2> anchor() const { return std::nullopt; }
    /// Makes a shape from the nodes placed so far, if there are enough. Called on Enter, a double-click or a tool
    /// change.
    virtual void finish(Shell &) {}
    virtual void cancel() {}
    /// Drops the unfinished shape because the user pressed Esc.
    virtual void discard(Shell &) { cancel(); }
    /// Removes the last node (Backspace). Returns false if there is none.
    virtual bool removeLast() { return false; }
    /// Returns true if releasing a drag places a second node.
    virtual bool dragPlaces() const { return false; }
    /// Handles a button release while a shape is unfinished; `away`: the pointer has moved since the press.
    virtual void release(Vec2 at, bool away, Shell &context);
    /// Follows the pointer while it is dragged away from where a press placed a node; see PenTool.
    virtual void pull(Vec2) {}
    /// Returns a snap target of the tool, such as the first node of a path, that takes precedence over all others.
    virtual std::optional<Vec2> ownSnap(Vec2, const Shell &) const { return std::nullopt; }
    /// Returns the place that a click would take instead of one under the pointer or typed, such as one on an arc.
    /// Called for each event.
    virtual Vec2 fitted(Vec2 at) { return at; }
    /// Handles a key that has a meaning of its own while a shape is unfinished. Returns false for other keys.
    virtual bool ownKey(int, Shell &) { return false; }
    /// Returns the letters that ownKey() handles now, so that they do not begin the name of a parameter.
    virtual std::string_view ownLetters() const { return {}; }
    /// Called after the pointer has moved or left.
    virtual void pointed(Shell &) {}
    /// Returns true if Shift constrains the angle; false if Shift has another meaning in this tool.
    virtual bool shiftIsAngle() const { return true; }
    /// Returns false if places do not snap now, so that no snap mark is drawn.
    virtual bool snaps() const { return true; }
    /// Returns false while nodes do not snap to the grid, even if that is on.
    virtual bool snapsToGrid() const { return true; }
    /// Describes the path being drawn, so that relations of the next node to it are found. Returns false if relations
    /// say nothing about the next place.
    virtual bool describePath(InferenceQuery &) const { return false; }
    /// Returns relations that a new shape has by itself and that become constraints like those of its places.
    virtual std::vector<InferredNode> relationsOf(const Shape &) const { return {}; }
    /// Returns the quantities that can be typed now, in Tab order: coordinates before the first node, then distance and
    /// angle.
    virtual std::span<const EntryField> entryFields() const;
    /// Returns the point that a typed pair denotes.
    virtual Vec2 typedPlace(const TypedPair &pair) const;

    bool inProgress() const { return anchor().has_value(); }
    /// Returns true if there is something that Backspace and undo remove, and Esc cancels.
    virtual bool hasBegun() const { return inProgress(); }
    /// Returns true if the selection can be seen in this tool, so that its menu may act on it.
    virtual bool showsSelection() const { return false; }
    /// Adds a shape, selects it and clears the typed numbers. Numbers of the shape that were typed as expressions
    /// follow them: see keepFormulas().
    bool commitShape(Shell &context, Shape shape, const std::string &label);
    /// Takes a formula of a number of a new shape; the handle is 0 for numbers without one.
    using Keep = std::function<void(Quantity what, std::uint32_t handle, const std::string &formula)>;
    /// Lets numbers of a new shape follow the expressions that were typed while it was drawn. An empty formula is
    /// ignored. What does not fit, such as a width that the pointer has changed, is removed when the document changes.
    virtual void keepFormulas(const Shape &drawn, const Keep &keep) const;
    /// Returns the place of a node of the unfinished shape as expressions: those that lead to it, or its coordinates.
    PlaceFormula formulaOf(Vec2 node) const;
    /// Returns the expressions that lead to a place beside the last node, given what was typed; empty ones where
    /// nothing was. A place typed relative to the last node, or by distance and angle, follows that node.
    virtual PlaceFormula typedFormula(Vec2 at) const;
    /// Returns true if the shape will follow the expressions typed now: those of a place, or of a distance and an
    /// angle, but not of one and the other together.
    virtual bool followsEntry() const;
    /// Returns the corner of a box opposite to `first` where a click is at a place: given the typed width and height
    /// (negative: to the left, downwards), and Shift for a square.
    Vec2 cornerOfBox(Vec2 first, Vec2 at) const;
    /// Labels the pointer with `text` and with the numbers being typed.
    void drawMeasure(CanvasPainter &painter, Shell &context, const std::string &text) const;

    std::shared_ptr<EditState> state_;
    NumericEntry entry_;
    Snapped pointer_;   ///< where a click would place a node now
    bool over_ = false; ///< the pointer is over the canvas
    Vec2 place_;        ///< position under the pointer, without snapping
    Modifiers modifiers_;

    /// A node whose coordinates follow expressions; an empty text: they do not.
    struct TypedNode {
        Vec2 at;
        std::string x, y;
    };
    std::vector<TypedNode> typedNodes_;       ///< of the unfinished shape
    std::vector<InferredNode> inferredNodes_; ///< of the unfinished shape, whose relations become constraints

  private:
    bool press(const CanvasEvent &event, Shell &context);
    void placeTyped(Shell &context);
    /// Keeps the relations at the pointer for the shape, if they are to become constraints.
    void keepRelations(const Shell &context);
    void reveal(Vec2 node, bool completed, Shell &context) const;
    bool typed(const CanvasEvent &event, Shell &context);
    void follow(const CanvasEvent &event, Shell &context);

    Pixel pressPixel_{};
};

} // namespace forefront
