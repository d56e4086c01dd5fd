#include "core/teaching/tables/table_report.hpp"

#include "core/engine/base/hash.hpp"
#include "core/teaching/tables/power_law.hpp"
#include "core/teaching/tables/published.hpp"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <limits>
#include <set>

namespace forefront {

namespace {

[[gnu::format(printf, 1, 2)]] std::string format(const char *pattern, ...) {
    std::array<char, 512> text{};
    va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(text.data(), text.size(), pattern, arguments);
    va_end(arguments);
    return text.data();
}

/// Returns a number for %llu; the compilers for Windows take %zu for a mistake.
unsigned long long whole(std::size_t number) {
    return number;
}

/// Formats a number for a column; blanks if there is none.
std::string cell(int width, int digits, double value, bool given = true) {
    return given ? format(" %*.*f", width, digits, value) : std::string(static_cast<std::size_t>(width) + 1, ' ');
}

/// Returns the name of a row, starred if the case is ours.
std::string label(const TableCase &row) {
    return std::string(row.row) + (row.adaptive ? "*" : "");
}

using Line = TableLine;

Line lineOf(const PublishedFigures &p) {
    Line line;
    line.row = line.label = p.row;
    line.grid = p.grid;
    line.who = "Lo";
    line.published = true;
    line.rhoMin = p.rhoMin;
    line.nodes = p.nodes;
    line.elements = p.elements;
    line.seconds = p.seconds;
    line.efficiency = p.efficiency;
    line.alpha = p.alpha;
    line.delta = p.delta;
    line.front = p.front;
    line.neighbours = p.neighbours == kNotPublished ? 0.0 : p.neighbours;
    line.considered = p.tests;
    return line;
}

Line lineOf(const RowFigures &r, const GridFigures &grid) {
    Line line;
    line.row = r.row.row;
    line.grid = grid.grid;
    line.who = r.row.adaptive ? "own case" : "ours";
    line.label = label(r.row);
    line.rhoMin = r.row.rhoMin;
    line.nodes = static_cast<double>(r.nodes);
    line.elements = static_cast<double>(r.elements);
    line.seconds = grid.seconds;
    line.efficiency = grid.efficiency;
    line.alpha = r.alphaRaw;
    line.alphaImproved = r.alphaImproved;
    line.delta = r.deltaRaw;
    line.deltaImproved = r.deltaImproved;
    line.front = r.front;
    line.neighbours = grid.neighbours;
    line.considered = r.considered;
    line.tests = r.tests;
    line.hash = toHex(r.hash);
    return line;
}

/// Returns true if a row belongs to one of the two functions: rows 1A to 1E, or 2A to 2E.
bool belongs(const RowFigures &row, char function) {
    return row.row.row.size() == 2 && row.row.row.front() == function;
}

std::vector<Vec2> costs(const std::vector<RowFigures> &rows, const std::string &grid, bool published,
                        std::string_view functions) {
    std::vector<Vec2> points;
    for (const RowFigures &row : rows) {
        if (!std::any_of(functions.begin(), functions.end(), [&](char f) { return belongs(row, f); })) {
            continue;
        }
        for (const Line &line : tableRowLines(row)) {
            if (line.grid == grid && line.published == published) {
                points.push_back({line.elements, line.seconds});
            }
        }
    }
    return points;
}

std::vector<std::string> gridsOf(const std::vector<RowFigures> &rows) {
    std::vector<std::string> names;
    for (const RowFigures &row : rows) {
        for (const Line &line : tableRowLines(row)) {
            if (std::find(names.begin(), names.end(), line.grid) == names.end()) {
                names.push_back(line.grid);
            }
        }
    }
    return names;
}

std::string exponentText(const std::vector<Vec2> &points) {
    const auto law = fitPowerLaw(points);
    return law ? format("%5.2f", law->exponent) : std::string("    -");
}

std::string exponents(const std::vector<RowFigures> &rows) {
    std::string text = "Growth of the cost: exponent of Ne in the seconds, fitted to the rows above\n"
                       "                   first function    second function\n"
                       "  grid               Lo   ours          Lo   ours\n";
    for (const std::string &grid : gridsOf(rows)) {
        text += format(
            "  %-15s %s  %s       %s  %s\n", grid.c_str(), exponentText(costs(rows, grid, true, "1")).c_str(),
            exponentText(costs(rows, grid, false, "1")).c_str(), exponentText(costs(rows, grid, true, "2")).c_str(),
            exponentText(costs(rows, grid, false, "2")).c_str());
    }
    return text;
}

/// The row with the smallest margin.
class Margin {
  public:
    void add(double value, const TableCase &row) {
        if (value < smallest_) {
            smallest_ = value;
            row_ = label(row);
        }
    }
    bool any() const { return !row_.empty(); }
    /// `sign`: -1 if the margin is the negative of the figure shown.
    std::string text(const char *what, double target, const char *pattern, double sign = 1.0) const {
        if (!any()) {
            return {};
        }
        return format("  %-58s %-4s ", what, smallest_ >= target ? "yes" : "NO") + format(pattern, sign * smallest_) +
               " in " + row_ + '\n';
    }

  private:
    double smallest_ = std::numeric_limits<double>::infinity();
    std::string row_;
};

std::string comparisons(const std::vector<RowFigures> &rows) {
    Margin alpha, delta, considered, neighbours, efficiency;
    for (const RowFigures &row : rows) {
        for (const PublishedFigures &line : publishedFigures()) {
            if (line.row == row.row.row) {
                alpha.add(row.alphaRaw - line.alpha, row.row);
                delta.add(row.deltaRaw - line.delta, row.row);
                considered.add(line.tests - row.considered, row.row);
            }
        }
        for (const GridFigures &grid : row.grids) {
            if (grid.grid == "hierarchical") {
                neighbours.add(-grid.neighbours, row.row);
                if (grid.efficiency > 0.0 && row.row.row == "2E") {
                    efficiency.add(grid.efficiency, row.row);
                }
            }
        }
    }
    return "Raw meshes against the published figures, in the least favourable row\n" +
           alpha.text("alpha higher by 0.03 or more", 0.03, "%+.4f") +
           delta.text("delta at least as high", 0.0, "%+.4f") +
           considered.text("fewer segments considered per element (Ns)", 0.0, "%.3f fewer") +
           neighbours.text("hierarchical grid: at most 20 segments returned (Nc)", -20.0, "%.2f", -1.0) +
           efficiency.text("hierarchical grid: efficiency of 100 or more", 100.0, "%.0f");
}

std::string countNotes(const std::vector<RowFigures> &rows) {
    std::string text = "Counts\n"
                       "  row     Ne ours   integral of 4/(sqrt(3) rho^2)    Ne of Lo    boundary nodes\n";
    for (const RowFigures &row : rows) {
        const PublishedFigures *line = publishedFigures(row.row.row, "60x40");
        text += format("  %-4s %10llu %18.0f (%+.1f %%) %13u (%+.1f %%) %8llu\n", label(row.row).c_str(),
                       whole(row.elements), row.expectedElements,
                       100.0 * (static_cast<double>(row.elements) / row.expectedElements - 1.0), line->elements,
                       100.0 * (static_cast<double>(row.elements) / line->elements - 1.0), whole(row.boundaryNodes));
    }
    return text;
}

/// Returns the number of boundary nodes of a published mesh without holes, by Euler's formula.
std::int64_t publishedBoundary(std::string_view row) {
    const PublishedFigures *line = publishedFigures(row, "none");
    return 2 * static_cast<std::int64_t>(line->nodes) - line->elements - 2;
}

std::string adaptiveNotes(const std::vector<RowFigures> &rows) {
    std::string text;
    for (const RowFigures &row : rows) {
        if (!row.adapted) {
            continue;
        }
        text +=
            format("  %-4s %6llu %14.4f %11.4f %11.4g of %g %13llu %14lld\n", label(row.row).c_str(),
                   whole(row.adapted->rounds), row.adapted->target, row.adapted->error, row.adapted->minSpacing,
                   row.row.rhoMin, whole(row.boundaryNodes), static_cast<long long>(publishedBoundary(row.row.row)));
    }
    if (text.empty()) {
        return text;
    }
    return "\nAdaptive refinement; *: domain and field are our own, since the published ones are not known\n"
           "  row  rounds   target error    estimate     min spacing   boundary nodes    those of Lo\n" +
           text;
}

constexpr const char *kExplanation =
    R"(  Percentages: our count relative to that figure. The publication does not print its domain and functions: rows 1A to 2E
  are reconstructed from its counts (rectangle in 50 boundary segments, distance to one or two circles, constants for
  which the integral is within 3 % of the ten published Ne), so a difference of a few percent from Lo's counts says
  nothing about either mesher. Our counts exceed the integral, which counts equilateral triangles with sides of rho: our
  sides match rho in the mean square, and a triangle of quality alpha has alpha times the area of the equilateral one
  with the same mean square of sides; so Ne is about the integral / alpha. Lo's counts change with the grid; in six of
  his lines with a grid, the number of boundary nodes, 2 Nn - Ne - 2, is 39 or 43 where the others have 50.
  Rows 3* and 4* are cases of our own in place of adaptive meshes of unknown domains: an L with a re-entrant corner and a
  rectangle with a hole, refined by our own error estimate. They share with the published ones only the minimum spacing
  and, roughly, the numbers of boundary nodes and elements.
Notes
  alpha, delta: of the mesh as the front leaves it (raw); alpha*, delta*: after the default swapping and smoothing.
  The raw values are compared, which is the stricter choice: the published ten steps have no smoothing, and it is not
  stated whether the published alpha and delta are those of smoothed meshes.
  Seconds: ours are CPU time of the front alone on this machine, Lo's include the graphics display on an unknown machine;
  only growth and efficiency can be compared. Efficiency: time without grid / time with it.
  Lo had no grid, 30x20 and 60x40; any other grid is compared with his figures for 60x40, his best.
  Lo's Nc is not reliable in the larger rows (Nc*Ne is 2^24 there: a sum that stopped growing).
  Ns: the segments near enough to be considered, per element: those that reach into the search region, without AB, once
  for each candidate side AC and CB. Lo does not say how he counts his; it is the same with and without a grid, as ours
  is, and of a similar size. Nt: those of them that are tested exactly; the others share an end with the side, or their
  box does not overlap its box.
  Every grid gives the same mesh, bit for bit; the hash is that of the raw mesh.
)";

constexpr std::array<const char *, 6> kColours = {"#8250df", "#bf8700", "#1a7f37", "#0969da", "#cf222e", "#57606a"};

} // namespace

std::vector<Line> tableRowLines(const RowFigures &row) {
    std::vector<Line> lines;
    std::set<std::string_view> shown;
    for (const GridFigures &grid : row.grids) {
        const PublishedFigures *published = publishedFigures(row.row.row, grid.grid);
        const bool waits = published->grid != grid.grid &&
                           std::any_of(row.grids.begin(), row.grids.end(),
                                       [&](const GridFigures &other) { return other.grid == published->grid; });
        if (!waits && shown.insert(published->grid).second) {
            lines.push_back(lineOf(*published));
        }
        lines.push_back(lineOf(row, grid));
    }
    return lines;
}

std::vector<TableLine> publishedLines(const TableCase &row) {
    std::vector<TableLine> lines;
    for (const PublishedFigures &published : publishedFigures()) {
        if (published.row == row.row) {
            lines.push_back(lineOf(published));
        }
    }
    return lines;
}

std::string tableHead() {
    return "row  rho_min grid         who       Nn      Ne   seconds effic.  alpha alpha*  delta delta*      Nb        "
           "Nc "
           "    Ns     Nt hash\n";
}

std::string tableLines(const RowFigures &row) {
    std::string text;
    for (const Line &line : tableRowLines(row)) {
        const bool ours = !line.published;
        text +=
            format("%-4s %-7g %-12s %-4s", line.label.c_str(), line.rhoMin, line.grid.c_str(), ours ? "ours" : "Lo") +
            cell(7, 0, line.nodes) + cell(7, 0, line.elements) + cell(9, ours ? 3 : 2, line.seconds) +
            cell(6, line.efficiency < 100.0 ? 2 : 1, line.efficiency, line.efficiency > 0.0) + cell(6, 4, line.alpha) +
            cell(6, 4, line.alphaImproved, ours) + cell(6, ours ? 4 : 3, line.delta) +
            cell(6, 4, line.deltaImproved, ours) + cell(7, 0, line.front) +
            cell(9, 2, line.neighbours, line.neighbours > 0.0) + cell(6, 3, line.considered) +
            cell(6, 3, line.tests, ours) + (ours ? ' ' + line.hash : std::string()) + '\n';
    }
    return text;
}

std::string tableNotes(const std::vector<RowFigures> &rows) {
    return '\n' + exponents(rows) + '\n' + comparisons(rows) + adaptiveNotes(rows) + '\n' + countNotes(rows) +
           kExplanation;
}

std::string tableCsv(const std::vector<RowFigures> &rows) {
    std::string text = "row,rho_min,grid,source,Nn,Ne,cpu_s,efficiency,alpha,alpha_improved,delta,delta_improved,Nb,Nc,"
                       "Ns,Nt,hash\n";
    const auto optional = [](bool given, const char *pattern, double value) {
        return given ? format(pattern, value) : std::string();
    };
    for (const RowFigures &row : rows) {
        for (const Line &line : tableRowLines(row)) {
            const bool ours = !line.published;
            text += format("%s,%g,%s,%s,%.0f,%.0f,%.6g,", line.row.c_str(), line.rhoMin, line.grid.c_str(),
                           line.who.c_str(), line.nodes, line.elements, line.seconds) +
                    optional(line.efficiency > 0.0, "%.4g", line.efficiency) + format(",%.5g,", line.alpha) +
                    optional(ours, "%.5g", line.alphaImproved) + format(",%.5g,", line.delta) +
                    optional(ours, "%.5g", line.deltaImproved) + format(",%.6g,", line.front) +
                    optional(line.neighbours > 0.0, "%.6g", line.neighbours) + format(",%.5g,", line.considered) +
                    optional(ours, "%.5g", line.tests) + ',' + line.hash + '\n';
        }
    }
    return text;
}

LogPlot tablePlot(const std::vector<RowFigures> &rows) {
    LogPlot plot{"Time against elements: rows 1A to 2E, Lo and ours", "elements Ne", "seconds", {}};
    const std::vector<std::string> grids = gridsOf(rows);
    for (const bool published : {true, false}) {
        for (std::size_t g = 0; g < grids.size(); ++g) {
            PlotSeries series;
            series.points = costs(rows, grids[g], published, "12");
            series.published = published;
            series.colour = kColours[g % kColours.size()];
            series.name = (published ? "Lo, " : "ours, ") + (grids[g] == "none" ? std::string("no grid") : grids[g]);
            if (!series.points.empty()) {
                plot.series.push_back(std::move(series));
            }
        }
    }
    return plot;
}

} // namespace forefront
