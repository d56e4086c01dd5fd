#pragma once

#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "ui/tools/common/drawing_tool.hpp"

namespace forefront {

/// Places size sources: points by a click, lines, circles and boxes by a drag.
class SourceTool final : public DrawingTool {
  public:
    using DrawingTool::DrawingTool;

    const char *id() const override { return "source"; }
    const char *name() const override { return "Size source"; }
    const char *icon() const override;
    int key() const override { return 'S'; }
    bool hasOptions(const Shell &) const override { return true; }
    void drawOptions(Shell &context, ui::Flow &flow) override;
    std::string statusText(const Shell &context) const override;

  protected:
    void place(Vec2 at, Shell &context) override;
    std::string_view goal() const override;
    void drawSketch(CanvasPainter &painter, Shell &context) override;
    std::optional<Vec2> anchor() const override { return first_; }
    std::span<const EntryField> entryFields() const override;
    void cancel() override { first_.reset(); }
    bool dragPlaces() const override { return true; }
    bool shiftIsAngle() const override { return shape() != SourceShape::Box; }
    Vec2 typedPlace(const TypedPair &pair) const override;

  private:
    SourceShape shape() const { return state_->sourceShape; }
    double size(const Shell &context, Vec2 at) const;
    /// Returns the second corner of a box where a click is at a place.
    Vec2 corner(Vec2 at) const;
    void add(Shell &context, Vec2 a, Vec2 b);
    /// Lets the numbers of a new source follow the expressions that were typed for them.
    void keepSourceFormulas(Document &document, const SizeSource &source) const;

    std::optional<Vec2> first_;
};

} // namespace forefront
