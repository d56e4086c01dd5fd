#pragma once

#include "ui/tools/common/drawing_tool.hpp"

#include <string>
#include <vector>

namespace forefront {

/// Draws a slot: the centres of its two round ends, then its radius.
class SlotTool final : public DrawingTool {
  public:
    using DrawingTool::DrawingTool;

    const char *id() const override { return "slot"; }
    const char *name() const override { return "Slot"; }
    const char *icon() const override;
    int key() const override { return 'U'; }
    void drawOptions(Shell &context, ui::Flow &flow) override;
    bool hasOptions(const Shell &) const override { return true; }
    std::string statusText(const Shell &context) const override;

  protected:
    void place(Vec2 at, Shell &context) override;
    std::string_view goal() const override;
    void drawSketch(CanvasPainter &painter, Shell &context) override;
    std::optional<Vec2> anchor() const override {
        return centres_.empty() ? std::nullopt : std::optional(centres_.back());
    }
    void cancel() override { centres_.clear(); }
    bool removeLast() override;
    std::span<const EntryField> entryFields() const override;
    bool describePath(InferenceQuery &query) const override {
        query.starts = centres_;
        return centres_.size() < 2; // then the width follows
    }
    void keepFormulas(const Shape &drawn, const Keep &keep) const override;

  private:
    /// Returns the typed radius, or the distance of a point from the line between the centres.
    double radiusTo(Vec2 at) const;

    /// Returns the typed distance of the second centre, if that alone uses parameters.
    std::string typedLength() const;

    std::vector<Vec2> centres_;
    std::string length_; ///< expression of the distance between the centres; empty: none was typed
};

} // namespace forefront
