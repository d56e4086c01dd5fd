#pragma once

#include "core/drawing/document/background_picture.hpp"
#include "ui/parts/tool.hpp"
#include "ui/workspace/edit_state.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// The effect of a drag or click with the picture tool.
enum class PictureMode : std::uint8_t {
    Move,     ///< drags the picture
    Calibrate ///< marks two points whose distance is known
};

template <>
struct EnumWords<PictureMode> {
    static constexpr auto kLast = PictureMode::Calibrate;
    static constexpr std::array<std::string_view, 2> kList = {"move", "calibrate"};
};

/// Places the background picture: moves it, or scales it by two points and their distance.
class PictureTool final : public Tool {
  public:
    explicit PictureTool(std::shared_ptr<EditState> state) : state_(std::move(state)) {}

    const char *id() const override { return "picture"; }
    const char *name() const override { return "Background picture"; }
    const char *icon() const override;
    int key() const override { return 'Z'; }
    bool handle(const CanvasEvent &event, Shell &context) override;
    void deactivate(Shell &context) override;
    void forget(Shell &context) override { deactivate(context); }
    void drawOverlay(CanvasPainter &painter, Shell &context) override;
    bool hasOptions(const Shell &) const override { return true; }
    void drawOptions(Shell &context, ui::Flow &flow) override;
    CursorShape cursor() const override;
    std::string statusText(const Shell &context) const override;
    bool undo(Shell &context) override;
    std::string undoLabel(const Shell &) const override { return points_.size() == 1 ? "last point" : ""; }

  private:
    /// Returns the picture of the document if it can be placed: null if there is none or it is locked.
    static const BackgroundPicture *movable(const Shell &context);
    bool press(Vec2 at, Shell &context);
    void pressPoint(Vec2 at, Shell &context);
    void drag(Vec2 to, Shell &context);
    bool key(int code);
    void change(Shell &context, const BackgroundPicture &picture, const std::string &label,
                const std::string &stroke = {}) const;
    /// Makes the distance between the two points `distance`.
    void calibrate(Shell &context, double distance) const;
    /// Returns true if a calibration scales the drawing, too: as chosen, else if the drawing lies on the picture.
    bool scalesDrawing(const Shell &context) const;
    Vec2 place(const BackgroundPicture &picture, std::size_t point) const;
    static Vec2 share(const BackgroundPicture &picture, Vec2 place);
    void drawPlace(Shell &context, ui::Flow &flow);
    void drawCalibration(Shell &context, ui::Flow &flow);
    void drawSecondPlace(Shell &context, ui::Flow &flow);
    void drawLook(Shell &context, ui::Flow &flow);

    std::shared_ptr<EditState> state_;
    PictureMode mode_ = PictureMode::Move;
    std::vector<Vec2> points_; ///< at most two, as shares of the width and height, so that they move with the picture
    bool firstPlaced_ = false; ///< the user has entered the place of the first point
    std::optional<bool> scaleDrawing_; ///< chosen for these points; absent: see scalesDrawing()
    std::optional<std::size_t> held_;  ///< point being dragged
    std::string stroke_;               ///< of the drag or the slider; empty: none
    Vec2 grip_;                        ///< from the corner of the picture to where it is held
};

} // namespace forefront
