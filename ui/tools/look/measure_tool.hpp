#pragma once

#include "core/drawing/shapes/measure.hpp"
#include "ui/tools/common/drawing_tool.hpp"

#include <string>
#include <utility>
#include <vector>

namespace forefront {

/// The quantity that the measure tool measures.
enum class MeasureMode : std::uint8_t {
    Distance, ///< between two points
    Angle,    ///< between two segments, or at the second of three points
    Object    ///< the segment, curve or face that is clicked
};

template <>
struct EnumWords<MeasureMode> {
    static constexpr auto kLast = MeasureMode::Object;
    static constexpr std::array<std::string_view, 3> kList = {"distance", "angle", "object"};
};

/// Measures distances, angles, curves and faces. Draws nothing into the document.
class MeasureTool final : public DrawingTool {
  public:
    using DrawingTool::DrawingTool;

    const char *id() const override { return "measure"; }
    const char *name() const override { return "Measure"; }
    const char *icon() const override;
    int key() const override { return 'M'; }
    void drawOptions(Shell &context, ui::Flow &flow) override;
    bool hasOptions(const Shell &) const override { return true; }
    std::string statusText(const Shell &context) const override;
    std::string copyText(const Shell &context) const override { return reading(context); }
    std::vector<ContextGroup> menu(Shell &context, Vec2 place) override;
    /// Returns the measured values: "5   Δx 3   Δy 4   ∠ 53.1°"; empty before there are any.
    std::string reading(const Shell &context) const;

  protected:
    void place(Vec2 at, Shell &context) override;
    void drawSketch(CanvasPainter &painter, Shell &context) override;
    std::optional<Vec2> anchor() const override;
    void cancel() override;
    bool removeLast() override;
    /// A segment that was picked has no point that the next one could refer to.
    bool hasBegun() const override {
        return inProgress() || (mode_ == MeasureMode::Angle && !picked_.empty() && !complete());
    }
    bool dragPlaces() const override { return mode_ == MeasureMode::Distance; }
    bool snaps() const override { return mode_ != MeasureMode::Object; }

  private:
    /// A segment that was clicked.
    struct Picked {
        Curve curve;
        Vec2 at; ///< where
    };
    /// Values by name, such as "radius", "2.5".
    using Values = std::vector<std::pair<std::string, std::string>>;

    Values values(const Shell &context) const;
    std::optional<Picked> segmentUnder(const Shell &context) const;
    void placeAngle(Vec2 at, Shell &context);
    void placeObject(Shell &context);
    void drawDistance(CanvasPainter &painter, Shell &context) const;
    void drawAngle(CanvasPainter &painter, Shell &context) const;
    void drawObject(CanvasPainter &painter, Shell &context) const;
    void label(CanvasPainter &painter, Shell &context, Vec2 at) const;
    /// Returns the points measured: those placed, and the pointer while there are too few.
    std::vector<Vec2> points() const;
    bool complete() const;

    MeasureMode mode_ = MeasureMode::Distance;
    std::vector<Vec2> points_;
    std::vector<Picked> picked_; ///< at most two for an angle, one as an object
    std::optional<FaceMeasure> face_;
    std::vector<std::pair<Vec2, Vec2>> faceLines_; ///< its outline
    Vec2 faceAt_;
    bool missed_ = false;        ///< nothing can be measured where the last click was
    std::uint64_t revision_ = 0; ///< of the document that was measured
};

} // namespace forefront
