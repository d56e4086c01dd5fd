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
    void drawOptions(AppContext &context, ui::Flow &flow) override;
    bool hasOptions(const AppContext &) const override { return true; }
    std::string statusText(const AppContext &context) const override;
    bool undo(AppContext &context) override;
    bool redo(AppContext &context) override;

  protected:
    void place(Vec2 at, AppContext &context) override;
    void drawSketch(CanvasPainter &painter, AppContext &context) override;
    std::optional<Vec2> anchor() const override;
    void finish(AppContext &context) override;
    void cancel() override;
    bool removeLast() override;
    std::optional<Vec2> ownSnap(Vec2 at, const AppContext &context) const override;

  private:
    bool closes(Vec2 at) const { return path_.size() >= 3 && at == path_.front(); }
    void commit(AppContext &context, bool closed);

    ShapeKind kind_;
    std::vector<Vec2> path_;
    std::vector<Vec2> undone_; ///< nodes removed by undo, newest last
};

} // namespace forefront
