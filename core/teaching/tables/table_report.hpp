#pragma once

#include "core/teaching/tables/log_plot.hpp"
#include "core/teaching/tables/table_run.hpp"

#include <string>
#include <vector>

namespace forefront {

/// Returns the header of the text table.
std::string tableHead();
/// Returns the lines of one row: for each grid the published figures, if any, and ours below them.
std::string tableLines(const RowFigures &row);
/// Returns the text below the table: the fitted exponents of the cost, the targets and whether they are met, and why
/// counts differ.
std::string tableNotes(const std::vector<RowFigures> &rows);
/// Returns the published figures and ours as a CSV table.
std::string tableCsv(const std::vector<RowFigures> &rows);
/// Returns a plot of seconds against elements, published and ours for each grid.
LogPlot tablePlot(const std::vector<RowFigures> &rows);

} // namespace forefront
