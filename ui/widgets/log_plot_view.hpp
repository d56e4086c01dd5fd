#pragma once

#include "core/teaching/tables/log_plot.hpp"
#include "ui/widgets/widget_context.hpp"

#include <string_view>

namespace forefront::ui {

enum class PlotLegend : bool { Without, With };

/// Draws a plot with logarithmic axes and its fitted lines over the rest of the row, and a legend with the exponents of
/// the lines. `height` in design pixels.
void logPlot(WidgetContext &context, std::string_view name, const LogPlot &plot, double height,
             PlotLegend legend = PlotLegend::With);

} // namespace forefront::ui
