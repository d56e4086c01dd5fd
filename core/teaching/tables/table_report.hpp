#pragma once

#include "core/teaching/tables/log_plot.hpp"
#include "core/teaching/tables/table_run.hpp"

#include <string>
#include <vector>

namespace forefront {

/// A line of the tables: the figures of a row with one grid, Lo's or ours. A figure that is not known is 0.
struct TableLine {
    std::string row, label; ///< name of the row, and the same with a star if the case is ours
    std::string grid;
    std::string who; ///< "Lo", "ours" or "own case"
    bool published = false;
    double rhoMin = 0.0;
    double nodes = 0.0, elements = 0.0, seconds = 0.0, efficiency = 0.0;
    double alpha = 0.0, alphaImproved = 0.0, delta = 0.0, deltaImproved = 0.0;
    double front = 0.0, neighbours = 0.0, considered = 0.0, tests = 0.0;
    std::string hash; ///< of the raw mesh; empty: published
};

/// Returns our figures of a row, each after Lo's for the same grid; his best are listed once, before the first grid
/// that he did not use.
std::vector<TableLine> tableRowLines(const RowFigures &row);
/// Returns Lo's figures of a row for each of his grids.
std::vector<TableLine> publishedLines(const TableCase &row);

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
