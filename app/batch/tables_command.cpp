#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/interrupt.hpp"
#include "app/batch/outputs.hpp"
#include "app/batch/progress_bar.hpp"
#include "core/files/files.hpp"
#include "core/teaching/tables/table_report.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

namespace {

constexpr const char *kTablesExamples = R"(
Examples:
  forefront tables
        every row with every grid, published figures beside ours; takes minutes, most of them without a grid
  forefront tables --rows 1A,2A --grids none,60x40,hierarchical
        two small rows
  forefront tables --rows 3,4 --grids none,hierarchical
        adaptive refinement; domains and fields are ours, since the published ones are unknown
  forefront tables --csv tables.csv --svg times.svg
        the same figures as CSV, and a plot of time against elements

Exit codes: 0 done, 1 a grid changed a mesh or a file cannot be written, 2 usage error, 3 cancelled.)";

struct TablesArguments {
    std::vector<TableCase> rows;
    std::vector<TableGrid> grids;
    std::optional<std::filesystem::path> csv, svg;
};

/// Describes the first error in the lists; empty if they are valid.
std::string parseLists(const std::vector<std::string> &rows, const std::vector<std::string> &grids,
                       TablesArguments &arguments) {
    for (const std::string &name : rows) {
        const TableCase *row = tableCase(name);
        if (row == nullptr) {
            return "--rows: unknown row '" + name + "'; expected 1A to 1E, 2A to 2E, 3* or 4*";
        }
        arguments.rows.push_back(*row);
    }
    for (const std::string &name : grids) {
        const auto grid = parseTableGrid(name);
        if (!grid) {
            return "--grids: unknown grid '" + name + "'; expected " + tableGridList();
        }
        const auto same = [&](const TableGrid &other) { return other.name == grid->name; };
        if (std::any_of(arguments.grids.begin(), arguments.grids.end(), same)) {
            return "--grids: grid '" + name + "' is given twice";
        }
        arguments.grids.push_back(*grid);
    }
    if (arguments.rows.empty()) {
        arguments.rows.assign(tableCases().begin(), tableCases().end());
    }
    return {};
}

int runTables(const TablesArguments &arguments) {
    InterruptWatch interrupt;
    interrupt.deferToStop();
    ProgressBar bar(true);
    const Progress progress = bar.progress(interrupt.token());
    std::vector<RowFigures> rows;
    std::fputs(tableHead().c_str(), stdout);
    for (const TableCase &row : arguments.rows) {
        Result<RowFigures> figures = bar.during({}, [&] { return runTableRow(row, arguments.grids, progress); });
        if (!figures) {
            return refuse(figures.faults(), interrupt);
        }
        std::fputs(tableLines(*figures).c_str(), stdout);
        std::fflush(stdout);
        rows.push_back(std::move(*figures));
    }
    std::fputs(tableNotes(rows).c_str(), stdout);
    FileSet files;
    if (arguments.csv) {
        files.write(*arguments.csv, tableCsv(rows));
    }
    if (arguments.svg) {
        files.write(*arguments.svg, toSvg(tablePlot(rows)));
    }
    const Status written = files.commit();
    return hasErrors(written) ? refuse(written, interrupt) : static_cast<int>(kDone);
}

} // namespace

int tablesCommand(const CommandLine &line) {
    TablesArguments arguments;
    std::vector<std::string> rows;
    std::vector<std::string> grids{"none", "30x20", "60x40", "hierarchical"};
    CLI::App app("Runs the cases of S. H. Lo's published tables with the classic method.", "forefront tables");
    app.footer(kTablesExamples);
    app.add_option("--rows", rows,
                   "rows to run, separated by commas: 1A to 1E, 2A to 2E, 3*, 4* (*: our own cases); default all")
        ->delimiter(',')
        ->type_name("ROWS");
    app.add_option("--grids", grids, "background grids: " + tableGridList() + "; default none,30x20,60x40,hierarchical")
        ->delimiter(',')
        ->type_name("GRIDS");
    app.add_option("--csv", arguments.csv, "write the figures as CSV")->type_name("FILE");
    app.add_option("--svg", arguments.svg, "write a plot of time against elements")->type_name("FILE");
    if (const auto code = parseOptions(app, line)) {
        return *code;
    }
    const std::string wrong = parseLists(rows, grids, arguments);
    if (!wrong.empty()) {
        return wrongUsage(app.get_name(), wrong);
    }
    std::vector<Output> files;
    for (const auto &file : {arguments.csv, arguments.svg}) {
        if (file) {
            files.push_back({*file, {}});
        }
    }
    const Diagnostics faults = checkOutputs(files);
    printFaults(faults);
    return faults.empty() ? runTables(arguments) : static_cast<int>(kRefused);
}

} // namespace forefront
