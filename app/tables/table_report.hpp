#pragma once

#include "app/tables/log_plot.hpp"
#include "app/tables/table_run.hpp"

#include <string>
#include <vector>

namespace forefront {

/// The head of the table for people.
std::string tableHead();
/// The lines of one row: for each grid the published figures, where there are some, and ours below them.
std::string tableLines(const RowFigures &row);
/// What follows the table: the fitted exponents of the cost, the targets and whether they are met, and why counts
/// differ.
std::string tableNotes(const std::vector<RowFigures> &rows);
/// Published and own figures in one CSV table.
std::string tableCsv(const std::vector<RowFigures> &rows);
/// Seconds against elements of the rows, published and ours for each grid.
LogPlot tablePlot(const std::vector<RowFigures> &rows);

} // namespace forefront
