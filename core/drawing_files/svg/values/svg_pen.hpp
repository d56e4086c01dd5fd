#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/engine/geometry/elliptical_arc.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// A polyline drawn by the pen, in the coordinates of its element, with the curves that it follows.
struct SvgSubpath {
    std::vector<Vec2> nodes;
    std::vector<Curve> curves;
    std::vector<CurveStretch> stretches; ///< per segment between consecutive nodes
    bool closed = false;
    double rounding = 0.0; ///< how far apart the rounded digits of path data may leave its ends
};

/// Turns path data and basic shapes into polylines along exact curves. In a first pass, which only measures the
/// drawing, curves are replaced by points that bound them.
class SvgPen {
  public:
    /// `tolerance` is in the element's units; absent: only measure.
    explicit SvgPen(std::optional<double> tolerance) : tolerance_(tolerance) {}

    Vec2 at() const { return at_; }
    bool down() const { return !subpaths_.empty(); }
    void moveTo(Vec2 p);
    void lineTo(Vec2 p);
    void quadraticTo(Vec2 control, Vec2 p);
    void cubicTo(Vec2 control1, Vec2 control2, Vec2 p);
    void arcTo(const EllipticalArc &arc, Vec2 p);
    void close();
    /// Sets the rounding of the present subpath.
    void setRounding(double rounding) { subpaths_.back().rounding = rounding; }

    void ellipse(Vec2 centre, double radiusX, double radiusY);
    void rectangle(Vec2 corner, Vec2 size, double radiusX, double radiusY);

    std::vector<SvgSubpath> take() { return std::move(subpaths_); }

  private:
    SvgSubpath &subpath();
    void straightTo(Vec2 p);
    void curveTo(const Curve &curve, Vec2 p);

    std::optional<double> tolerance_;
    std::vector<SvgSubpath> subpaths_;
    Vec2 at_, start_;
    bool closedLast_ = false; ///< the next drawing command begins a new subpath at the start of the closed one
};

/// A fault in a text and its byte.
struct SvgFault {
    std::size_t offset = 0;
    std::string message;
};

/// Draws path data, all commands of SVG 1.1, up to the end or the first fault.
std::optional<SvgFault> drawPath(std::string_view data, SvgPen &pen);
/// Reads the attribute `points` of polygon and polyline up to the end or the first fault.
std::optional<SvgFault> readPoints(std::string_view data, std::vector<Vec2> &points);

/// Reads numbers as SVG writes them: "1.5.5-3e2,4" is 1.5, .5, -300, 4.
class SvgNumbers {
  public:
    explicit SvgNumbers(std::string_view text) : text_(text) {}
    std::size_t offset() const { return at_; }
    bool atEnd();
    char peek();
    void skip() {
        ++at_;
        comma_ = false;
    }
    bool number(double &value);
    /// Returns the maximum number of digits after the point, less the exponent, of all numbers so far; at least 0.
    int decimals() const { return decimals_; }
    bool point(Vec2 &p) { return number(p.x) && number(p.y); }
    bool flag(bool &value);
    /// Returns the letters or percent sign that directly follow a number, in lower case.
    std::string unit();
    /// Returns true if another number follows.
    bool more();

  private:
    void skipBlanks();
    void taken(std::size_t end);

    std::string_view text_;
    std::size_t at_ = 0;
    int decimals_ = 0;
    bool comma_ = false; ///< one has been skipped since the last number
};

} // namespace forefront
