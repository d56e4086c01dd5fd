#pragma once

#include "core/drawing/colour_outline/outline_fit.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "ui/background/latest.hpp"
#include "ui/canvas/picture.hpp"
#include "ui/parts/tool.hpp"
#include "ui/workspace/edit_state.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// Traces an area of one colour of the background picture, such as a lake: a click shows its outline, with its islands
/// as holes, and Enter makes boundaries of it.
class OutlineTool final : public Tool {
  public:
    explicit OutlineTool(std::shared_ptr<EditState> state) : state_(std::move(state)) {}

    const char *id() const override { return "outline"; }
    const char *name() const override { return "Trace by colour: click an area of the picture"; }
    const char *icon() const override;
    int key() const override { return 'Y'; }
    CursorShape cursor() const override { return CursorShape::Crosshair; }
    void activate(Shell &context) override;
    void deactivate(Shell &context) override;
    void forget(Shell &context) override;
    bool handle(const CanvasEvent &event, Shell &context) override;
    void drawOverlay(CanvasPainter &painter, Shell &context) override;
    bool hasOptions(const Shell &) const override { return true; }
    void drawOptions(Shell &context, ui::Flow &flow) override;
    std::string statusText(const Shell &context) const override;
    bool undo(Shell &context) override;
    std::string undoLabel(const Shell &) const override { return seed_ ? "traced area" : ""; }

  private:
    /// The area and how it is traced.
    struct Request {
        std::shared_ptr<const Picture> picture;
        PixelPlace seed;
        double tolerance = 0.0, smoothness = 0.0;

        bool sameRegion(const Request &other) const {
            return picture == other.picture && seed == other.seed && tolerance == other.tolerance;
        }
    };
    /// The outline found for a request; while it is being found, the one before.
    struct Traced {
        Request of;
        std::shared_ptr<const std::vector<PixelLoop>> outlines; ///< null: none found yet
        std::shared_ptr<const OutlineFit> fit;                  ///< null: none found yet
        std::string stage;                                      ///< what is being done; empty: done
        Diagnostics faults;                                     ///< why nothing could be found; empty: nothing failed
    };
    using Worker = Latest<Request, Traced>;

    static Traced answer(const LatestTurn<Request, Traced> &turn);
    static Traced trace(const LatestTurn<Request, Traced> &turn);
    void press(Vec2 at, Shell &context);
    void request(Shell &context);
    void drop(Shell &context);
    /// Makes boundaries of the outline that is shown.
    void take(Shell &context);
    /// Returns the outline of the last click; null until it is found.
    const OutlineFit *found() const;
    void drawCount(CanvasPainter &painter, const Shell &context, const OutlineFit &fit) const;

    std::shared_ptr<EditState> state_;
    std::unique_ptr<Worker> worker_; ///< null before the tool is first chosen
    std::optional<Request> seed_;    ///< the area that was clicked
    Vec2 clicked_;                   ///< in the plane
    bool takesWhenFound_ = false;    ///< Enter was pressed before the outline was found
    double tolerance_ = 12.0;        ///< ΔE of 1976
    double smoothness_ = 2.0;        ///< pixels of the picture
};

} // namespace forefront
