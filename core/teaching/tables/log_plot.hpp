#pragma once

#include "core/engine/base/vec2.hpp"

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

/// Returns the plot as an SVG image: a labelled grid line at every decade, fine lines in between, marks, fitted lines
/// and a legend with the exponents. Points that are not positive are left out. The same plot gives the same bytes.
std::string toSvg(const LogPlot &plot);

} // namespace forefront
