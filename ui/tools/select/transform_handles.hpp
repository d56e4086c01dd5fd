#pragma once

#include "core/drawing/commands/carry_joints.hpp"
#include "core/drawing/picking/pointer_snap.hpp"
#include "core/drawing/shapes/plane_map.hpp"
#include "ui/parts/tool.hpp"
#include "ui/tools/common/numeric_entry.hpp"
#include "ui/workspace/edit_state.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// The handles around the selection that scale and rotate it, and the drag of one of them. Shift keeps the proportions
/// or turns in steps of some degrees, Ctrl scales about the centre, Alt turns snapping off, and a typed number is the
/// factor or the angle.
class TransformHandles {
  public:
    explicit TransformHandles(std::shared_ptr<EditState> state) : state_(std::move(state)) {}

    /// A handle on a side (one of x and y is 0) or a corner of the box around the selection, x and y being -1, 0 or 1;
    /// or the one that rotates, outside the upper right corner.
    struct Handle {
        int x = 0, y = 0;
        bool rotates = false;

        friend bool operator==(const Handle &, const Handle &) = default;
    };
    /// Returns the handle under the pointer.
    std::optional<Handle> at(Vec2 place, Shell &context) const;

    /// `joints`: of the current document.
    void begin(const Handle &handle, const CanvasEvent &event, Shell &context, std::shared_ptr<const Joints> joints);
    bool active() const { return start_ != nullptr; }
    void drag(const CanvasEvent &event, Shell &context);
    /// Handles typed numbers and Esc during a drag. Returns true if the event was used.
    bool typed(const CanvasEvent &event, Shell &context);
    void end();
    /// Ends the drag and names the dimensions that it has changed.
    void finish(Shell &context);

    /// Returns the places of the handles that are shown.
    std::vector<Vec2> places(const Shell &context) const;
    void draw(CanvasPainter &painter, Shell &context, const std::optional<Handle> &hovered) const;
    /// Returns a line for the status bar.
    static std::string statusText(const Handle &handle);

  private:
    /// Returns the box around the selection; empty if it has no handles.
    const Box2 &box(const Shell &context) const;
    /// Returns the place of a handle around a box; none if it is not shown.
    static std::optional<Vec2> placeOf(const Handle &handle, const Box2 &around, const Shell &context);
    void update(Shell &context);
    PlaneMap map() const;
    Vec2 factors() const;
    Vec2 fixedPoint() const;
    double angle() const;
    std::string measure() const;

    std::shared_ptr<EditState> state_;
    Handle handle_;
    std::shared_ptr<const Document> start_; ///< document when the drag began; null: none
    std::shared_ptr<const PickIndex> startIndex_;
    std::shared_ptr<const Joints> startJoints_;
    Selection moving_;
    Selection following_; ///< moving_ with what is joined with it
    Box2 startBox_;
    std::string stroke_;
    std::string fault_; ///< why the selection cannot become what the pointer asks for
    NumericEntry entry_;
    CanvasEvent last_; ///< of the pointer
    Pixel pressPixel_{};
    Vec2 pressPlace_;
    Snapped target_;                ///< of the dragged side or corner
    double angleStep_ = kSnapAngle; ///< with Shift
    bool away_ = false;             ///< the pointer has left the place of the press

    mutable Box2 box_; ///< of boxSelection_ in the document boxRevision_
    mutable Selection boxSelection_;
    mutable std::uint64_t boxRevision_ = 0;
};

} // namespace forefront
