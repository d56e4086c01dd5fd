#pragma once

#include "ui/tools/drawing_tool.hpp"

namespace forefront {

/// Draws a polygon (boundary) or a polyline (constraint) node by node, like Inkscape's pen.
class PenTool final : public DrawingTool {
  public:
    PenTool(std::shared_ptr<EditState> state, ShapeKind kind) : DrawingTool(std::move(state)), kind_(kind) {}

    const char *id() const override { return kind_ == ShapeKind::Polygon ? "polygon" : "polyline"; }
    const char *name() const override { return kind_ == ShapeKind::Polygon ? "Polygon" : "Constraint polyline"; }
    const char *icon() const override;
    int key() const override { return kind_ == ShapeKind::Polygon ? 'P' : 'L'; }
    void drawOptions(Shell &context, ui::Flow &flow) override;
    bool hasOptions(const Shell &) const override { return true; }
    std::string statusText(const Shell &context) const override;
    bool undo(Shell &context) override;
    bool redo(Shell &context) override;

  protected:
    void place(Vec2 at, Shell &context) override;
    void drawSketch(CanvasPainter &painter, Shell &context) override;
    std::optional<Vec2> anchor() const override;
    void finish(Shell &context) override;
    void cancel() override;
    bool removeLast() override;
    std::optional<Vec2> ownSnap(Vec2 at, const Shell &context) const override;

  private:
    bool closes(Vec2 at) const { return path_.size() >= 3 && at == path_.front(); }
    void commit(Shell &context, bool closed);

    ShapeKind kind_;
    std::vector<Vec2> path_;
    std::vector<Vec2> undone_; ///< nodes removed by undo, newest last
};

} // namespace forefront
