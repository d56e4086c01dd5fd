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

/// Whole decades, as powers of ten, that contain the positive values of a coordinate; at least one.
struct Decades {
    int first = 0, last = 1;

    /// Returns where a positive value lies between the first decade, 0, and the last one, 1.
    double place(double value) const;
};
Decades decadesOf(const LogPlot &plot, double Vec2::*coordinate);

/// Returns the plot as an SVG image: a labelled grid line at every decade, fine lines in between, marks, fitted lines
/// and a legend with the exponents. Points that are not positive are left out. The same plot gives the same bytes.
std::string toSvg(const LogPlot &plot);

} // namespace forefront
