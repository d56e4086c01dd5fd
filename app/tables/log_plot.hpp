#pragma once

#include "core/base/vec2.hpp"

#include <string>
#include <vector>

namespace forefront {

/// One set of points of a plot, with the straight line fitted to their logarithms.
struct PlotSeries {
    std::string name;
    std::string colour;     ///< an SVG colour
    bool published = false; ///< hollow marks and a dashed line; else filled and solid
    std::vector<Vec2> points;
};

/// A drawing with logarithmic axes.
struct LogPlot {
    std::string title;
    std::string xLabel, yLabel;
    std::vector<PlotSeries> series;
};

/// The plot as an SVG picture: a grid line and a number at every decade, fine lines between, marks, fitted lines and a
/// legend that tells the exponents. Points that are not positive are left out. The same plot gives the same bytes.
std::string toSvg(const LogPlot &plot);

} // namespace forefront
