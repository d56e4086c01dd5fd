#pragma once

#include "core/engine/geometry/curve.hpp"
#include "ui/tools/common/drawing_tool.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// The kind of the next segment of a path.
enum class PenSegment : std::uint8_t { Line, Tangent, Through };

template <>
struct EnumWords<PenSegment> {
    static constexpr auto kLast = PenSegment::Through;
    static constexpr std::array<std::string_view, 3> kList = {"line", "tangent", "through"};
};

/// Draws a polygon (boundary) or a polyline (constraint) node by node, like Inkscape's pen: a click places a corner, a
/// drag a smooth node and its two control points; A makes the next segments arcs of circles, tangent to the one before
/// or through a point, and L lines again. As a spline, clicks place the points of a smooth curve; freehand, a drag
/// draws a path that becomes smooth curves or straight segments on release.
class PenTool final : public DrawingTool {
  public:
    PenTool(std::shared_ptr<EditState> state, ShapeKind kind) : DrawingTool(std::move(state)), kind_(kind) {}

    const char *id() const override { return kind_ == ShapeKind::Polygon ? "polygon" : "polyline"; }
    const char *name() const override { return kind_ == ShapeKind::Polygon ? "Polygon" : "Inner polyline"; }
    const char *icon() const override;
    int key() const override { return kind_ == ShapeKind::Polygon ? 'P' : 'L'; }
    void drawOptions(Shell &context, ui::Flow &flow) override;
    bool hasOptions(const Shell &) const override { return true; }
    std::string statusText(const Shell &context) const override;
    /// Makes a shape of the path if it has enough nodes; otherwise undo brings it back, with the tool.
    void deactivate(Shell &context) override;
    /// Draws corners again in another document.
    void forget(Shell &context) override;
    std::optional<Shape> unfinished() const override;
    bool undo(Shell &context) override;
    bool redo(Shell &context) override;
    std::string undoLabel(const Shell &context) const override;
    std::string redoLabel(const Shell &context) const override;

  protected:
    void place(Vec2 at, Shell &context) override;
    void drawSketch(CanvasPainter &painter, Shell &context) override;
    std::optional<Vec2> anchor() const override;
    void finish(Shell &context) override;
    void cancel() override;
    void discard(Shell &context) override;
    bool removeLast() override;
    std::optional<Vec2> ownSnap(Vec2 at, const Shell &context) const override;
    /// An outline drawn freehand would get a corner where it begins and ends.
    bool snapsToGrid() const override { return mode_ != PenMode::Freehand; }
    bool describePath(InferenceQuery &query) const override;
    std::vector<InferredNode> relationsOf(const Shape &shape) const override;
    void pull(Vec2 to) override;
    void release(Vec2 at, bool away, Shell &context) override;
    Vec2 fitted(Vec2 at) override;
    bool ownKey(int key, Shell &context) override;
    std::string_view ownLetters() const override;
    std::span<const EntryField> entryFields() const override;
    PlaceFormula typedFormula(Vec2 at) const override;
    void keepFormulas(const Shape &drawn, const Keep &keep) const override;
    bool followsEntry() const override;

  private:
    /// A node of the unfinished path. It is smooth if it has an arm: the vector to the control point after it; the
    /// opposite vector leads to the one before it.
    struct Node {
        Vec2 at;
        Vec2 arm;
        std::optional<Curve> arc{}; ///< the segment that leads to it; of the first node: the one that closes the path
        std::string radius{};       ///< expression of its radius; empty: none was typed
    };
    static bool curved(const Node &from, const Node &to) { return to.arc || from.arm != Vec2{} || to.arm != Vec2{}; }
    /// Returns the segment between two nodes.
    static Curve segment(const Node &from, const Node &to);
    bool anyCurved() const;
    bool drawsArc() const { return mode_ == PenMode::Corners && segment_ != PenSegment::Line; }
    /// Returns the direction in which the path ends; none before its first segment.
    std::optional<Vec2> heading() const;
    /// Returns true if the next click places a point on the next arc, not its end.
    bool wantsMiddle() const;
    /// Returns true if the next arc is tangent to the segment before it.
    bool isTangent() const { return drawsArc() && segment_ == PenSegment::Tangent && heading(); }
    /// Returns the arc from the last node to a point.
    Curve arcTo(Vec2 at) const;
    bool canFinish() const { return kind_ == ShapeKind::Polygon ? canClose() : path_.size() >= 2; }
    bool canClose() const { return path_.size() >= (anyCurved() ? 2U : 3U); }
    bool closes(Vec2 at) const { return canClose() && at == path_.front().at; }
    /// Returns the path so far as a shape.
    Shape shapeOf(bool closed) const;
    void commit(Shell &context, bool closed);
    /// Returns true if undo brings a discarded path back.
    bool bringsBack(const Shell &context) const;
    void commit(Shell &context, Shape shape);
    /// Completes the freehand path with its end, and makes a shape of it.
    void finishFreehand(Vec2 at, Shell &context);
    /// Makes straight segments, or smooth curves, of the freehand path; `loop`: it ends near where it began.
    void simplifyStroke(Shell &context, bool loop);
    void smoothStroke(Shell &context, bool loop);
    void announceTooFew(Shell &context) const;
    double freehandTolerance(const Shell &context) const;
    /// Returns the curves between the points placed so far.
    std::vector<Curve> splineOf(bool closed) const;
    void drawPath(CanvasPainter &painter, const Shell &context) const;

    ShapeKind kind_;
    PenSegment segment_ = PenSegment::Line; ///< the next one
    std::optional<Vec2> middle_;            ///< a point on the next arc
    std::vector<Node> path_;
    PenMode mode_ = PenMode::Corners; ///< of this tool alone: a freehand outline says nothing about lines
    bool clicked_ = false;            ///< freehand, a click has drawn nothing
    std::vector<Vec2> hand_;          ///< pointer positions while drawing freehand
    std::vector<Node> undone_;        ///< nodes removed by undo, newest last
    std::vector<Node> discarded_;     ///< path dropped by Esc, which undo brings back until anything is drawn
    std::uint64_t discardedRevision_ = 0;
    std::uint64_t discardedPlaced_ = 0;     ///< EditState::placed then
    std::vector<TypedNode> discardedTyped_; ///< of the dropped path
    std::uint64_t undoneRevision_ = 0;      ///< of the document when a node was last undone
};

} // namespace forefront
