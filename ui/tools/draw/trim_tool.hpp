#pragma once

#include "core/engine/geometry/curve.hpp"
#include "ui/parts/tool.hpp"
#include "ui/workspace/edit_state.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

/// Removes the part of an outline between two crossings, and extends the ends of open paths to the next crossing. The
/// part is shown before the click.
class TrimTool final : public Tool {
  public:
    explicit TrimTool(std::shared_ptr<EditState> state) : state_(std::move(state)) {}

    const char *id() const override { return "trim"; }
    const char *name() const override { return "Trim and extend"; }
    const char *icon() const override;
    int key() const override { return 'J'; }
    CursorShape cursor() const override { return CursorShape::Crosshair; }
    void deactivate(Shell &context) override;
    bool handle(const CanvasEvent &event, Shell &context) override;
    void drawOverlay(CanvasPainter &painter, Shell &context) override;
    std::string statusText(const Shell &context) const override;

  private:
    /// The effect of a click.
    struct Change {
        std::uint32_t shape = 0;
        std::optional<NodeRef> end; ///< to extend; none: trim at `at`
        Vec2 at;
        std::vector<Curve> curves; ///< removed or added; empty: not possible
        std::string fault;         ///< why
    };
    /// Where the shape under the pointer meets others; found once for each shape of a document.
    struct Crossed {
        std::shared_ptr<const PickIndex> index;
        std::uint32_t shape = 0;
        std::vector<double> places;
    };
    /// The piece that extending the end under the pointer adds; also computed once.
    struct Extended {
        std::shared_ptr<const PickIndex> index;
        NodeRef end;
        Result<Curve> added;
    };
    std::optional<Change> changeAt(Vec2 place, Shell &context);
    const Result<Curve> &extensionOf(const std::shared_ptr<const PickIndex> &index, NodeRef end);
    const std::vector<double> &crossingsOf(const std::shared_ptr<const PickIndex> &index, std::uint32_t shape);
    void apply(const Change &change, Shell &context) const;

    std::shared_ptr<EditState> state_;
    std::optional<Change> change_; ///< under the pointer
    Crossed crossed_;
    std::optional<Extended> extended_;
};

} // namespace forefront
