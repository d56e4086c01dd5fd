#pragma once

#include "core/spacing/spec/spacing_spec.hpp"
#include "ui/tools/drawing_tool.hpp"

namespace forefront {

/// Places size sources: points by a click, lines and circles by a drag.
class SourceTool final : public DrawingTool {
  public:
    using DrawingTool::DrawingTool;

    const char *id() const override { return "source"; }
    const char *name() const override { return "Size source"; }
    const char *icon() const override;
    int key() const override { return 'S'; }
    bool hasOptions(const AppContext &) const override { return true; }
    void drawOptions(AppContext &context, ui::Flow &flow) override;
    std::string statusText(const AppContext &context) const override;
    bool undo(AppContext &context) override;

  protected:
    void place(Vec2 at, AppContext &context) override;
    void drawSketch(CanvasPainter &painter, AppContext &context) override;
    std::optional<Vec2> anchor() const override { return first_; }
    std::span<const EntryField> entryFields() const override;
    void cancel() override { first_.reset(); }
    bool dragPlaces() const override { return true; }

  private:
    SourceShape shape() const { return static_cast<SourceShape>(state_->sourceShape); }
    double size(const AppContext &context, Vec2 at) const;
    void add(AppContext &context, Vec2 a, Vec2 b);

    std::optional<Vec2> first_;
};

} // namespace forefront
