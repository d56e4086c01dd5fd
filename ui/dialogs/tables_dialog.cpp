#include "ui/dialogs/tables_dialog.hpp"

#include "core/engine/base/out_of_memory.hpp"
#include "core/files/files.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/log_plot_view.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace forefront {

namespace {

constexpr const char *kTables = "dialog/tables/";
constexpr double kBoxes = 80.0; ///< left edge of the boxes, design pixels
constexpr std::array<const char *, 4> kGridNames = {"none", "30x20", "60x40", "hierarchical"};

constexpr int kNotPrinted = -1;

/// A column of the table.
struct FigureColumnOfTables {
    const char *name, *meaning;
    double TableLine::*value;
    int digits;  ///< after the point
    int printed; ///< the same in Lo's tables; kNotPrinted: they do not give it
};

constexpr std::array<FigureColumnOfTables, 12> kFigureColumns{
    {{"Nn", "Number of nodes", &TableLine::nodes, 0, 0},
     {"Ne", "Number of elements", &TableLine::elements, 0, 0},
     {"seconds", "Ours: CPU time of the front alone on this computer. Lo's: with graphics, on an unknown machine",
      &TableLine::seconds, 3, 2},
     {"effic.", "Time without a grid over time with this one; needs a run without a grid", &TableLine::efficiency, 2,
      2},
     {"\xce\xb1", "Mean shape factor; ours is that of the mesh as the front leaves it", &TableLine::alpha, 4, 4},
     {"\xce\xb1 impr.", "The same after the improvement", &TableLine::alphaImproved, 4, kNotPrinted},
     {"\xce\xb4", "Mean spacing conformity; ours is that of the mesh as the front leaves it", &TableLine::delta, 4, 3},
     {"\xce\xb4 impr.", "The same after the improvement", &TableLine::deltaImproved, 4, kNotPrinted},
     {"Nb", "Mean number of segments on the front", &TableLine::front, 0, 0},
     {"Nc", "Segments that the grid returns, per element. Lo's Nc is too small in large rows: his sum stopped at 2^24",
      &TableLine::neighbours, 2, 2},
     {"Ns", "Segments near enough to be considered, per element", &TableLine::considered, 3, 3},
     {"Nt", "Segments tested exactly, per element; Lo does not give them", &TableLine::tests, 3, kNotPrinted}}};

std::string tableFigureText(const TableLine &line, const FigureColumnOfTables &column) {
    const double value = line.*column.value;
    const int digits = line.published ? column.printed : column.digits;
    if (value == 0.0 || digits == kNotPrinted) {
        return "\xe2\x80\x93";
    }
    return digits == 0 ? ui::count(static_cast<std::uint64_t>(std::llround(value))) : ui::format("%.*f", digits, value);
}

void rightAlignedText(const std::string &text, Colour colour) {
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(room, 0.0F));
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
}

void drawFigureHead(WidgetContext &context) {
    constexpr ImGuiTableColumnFlags kFixed = ImGuiTableColumnFlags_WidthFixed;
    ImGui::TableSetupColumn("row", kFixed, context.px(34));
    ImGui::TableSetupColumn("spacing", kFixed, context.px(52));
    ImGui::TableSetupColumn("grid", kFixed, context.px(92));
    ImGui::TableSetupColumn("whose", kFixed, context.px(66));
    for (const FigureColumnOfTables &column : kFigureColumns) {
        ImGui::TableSetupColumn(column.name);
    }
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableNextRow();
    for (const char *name : {"Row", "\xcf\x81 min", "Grid", "Whose"}) {
        ImGui::TableNextColumn();
        ui::muted(context, name);
    }
    for (const FigureColumnOfTables &column : kFigureColumns) {
        ImGui::TableNextColumn();
        rightAlignedText(column.name, context.theme.muted);
        ui::tooltip(context, column.meaning);
    }
}

void drawTableLine(WidgetContext &context, const TableLine &line) {
    const Colour ink = line.published ? context.theme.muted : context.theme.text;
    ImGui::TableNextRow();
    ImGui::PushStyleColor(ImGuiCol_Text, ink);
    for (const std::string &text : {line.label, ui::number(line.rhoMin), line.grid, line.who}) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(text.c_str());
    }
    ImGui::PopStyleColor();
    ui::mark(context, std::string(kTables) + "line/" + line.row + '/' + line.grid + (line.published ? "/Lo" : "/ours"));
    for (const FigureColumnOfTables &column : kFigureColumns) {
        ImGui::TableNextColumn();
        rightAlignedText(tableFigureText(line, column), ink);
    }
}

} // namespace

TablesDialog::TablesDialog(BackgroundList &list, std::shared_ptr<TableRows> rows)
    : rows_(std::move(rows)), worker_(list, answer) {
    grids_.fill(true);
    for (std::size_t k = 0; k < tableCases().size(); ++k) {
        const std::string_view row = tableCases()[k].row;
        chosen_[k] = row == "1A" || row == "1B" || row == "2A" || row == "2B";
    }
}

TablesDialog::State TablesDialog::answer(const LatestTurn<Request, State> &turn) {
    State state;
    auto rows = std::make_shared<TableRows>();
    Progress progress;
    progress.stop = turn.stop;
    progress.report = [&](std::string_view stage, double fraction) {
        constexpr double kStep = 0.01; // a frame for each report would cost more than the work
        if (stage != state.stage || fraction >= state.fraction + kStep) {
            state.stage = stage;
            state.fraction = fraction;
            turn.publish(state);
        }
    };
    for (const TableCase &row : turn.request.rows) {
        Result<RowFigures> figures =
            orOutOfMemory("for this row", [&] { return runTableRow(row, turn.request.grids, progress); });
        if (!figures) {
            state.end = figures.faults();
            return state;
        }
        rows = std::make_shared<TableRows>(*rows);
        rows->push_back(*std::move(figures));
        state.rows = rows;
        turn.publish(state);
    }
    state.end.emplace();
    return state;
}

void TablesDialog::start() {
    Request request;
    for (std::size_t k = 0; k < tableCases().size(); ++k) {
        if (chosen_[k]) {
            request.rows.push_back(tableCases()[k]);
        }
    }
    for (std::size_t k = 0; k < kGridNames.size(); ++k) {
        if (grids_[k]) {
            request.grids.push_back(*parseTableGrid(kGridNames[k]));
        }
    }
    worker_.clear();
    running_ = true;
    worker_.submit(std::move(request));
}

void TablesDialog::takeNews(Shell &context) {
    if (!worker_.refresh() || !running_) {
        return;
    }
    const State &now = worker_.now();
    if (now.rows) {
        for (const RowFigures &done : *now.rows) {
            const auto known = std::find_if(rows_->begin(), rows_->end(),
                                            [&done](const RowFigures &row) { return row.row.row == done.row.row; });
            RowFigures row = done;
            if (known != rows_->end()) {
                addEarlierGrids(row, *known);
                *known = std::move(row);
            } else {
                rows_->push_back(std::move(row));
            }
        }
        std::sort(rows_->begin(), rows_->end(),
                  [](const RowFigures &a, const RowFigures &b) { return a.row.row < b.row.row; });
    }
    if (now.end) {
        running_ = false;
        if (!now.end->empty() && now.end->front().code != "cancelled") {
            context.log.add(*now.end);
        }
    }
    context.animate();
}

void TablesDialog::drawChoices(Shell &context) {
    ui::rowLabel(context, "Rows", kBoxes);
    for (std::size_t k = 0; k < tableCases().size(); ++k) {
        const TableCase &row = tableCases()[k];
        if (k > 0) {
            ImGui::SameLine(0, context.px(12));
        }
        ui::checkbox(context, kTables + ("row/" + std::string(row.row)),
                     std::string(row.row) + (row.adaptive ? "*" : ""), chosen_[k]);
        ui::tooltip(context, row.adaptive ? "Adaptive refinement. The domain and the field are ours: Lo's are not known"
                                          : "Minimum spacing " + ui::number(row.rhoMin) +
                                                (row.row.front() == '1' ? ", first function" : ", second function"));
    }
    ui::rowLabel(context, "Grids", kBoxes);
    for (std::size_t k = 0; k < kGridNames.size(); ++k) {
        if (k > 0) {
            ImGui::SameLine(0, context.px(12));
        }
        ui::checkbox(context, kTables + ("grid/" + std::string(kGridNames[k])), kGridNames[k], grids_[k]);
    }
}

void TablesDialog::drawRunRow(Shell &context) {
    const auto any = [](const auto &flags) { return std::find(flags.begin(), flags.end(), true) != flags.end(); };
    if (running_) {
        if (ui::button(context, std::string(kTables) + "cancel", "Cancel", ui::ButtonKind::Plain, true, 90.0F)) {
            worker_.requestStop();
        }
        const State &now = worker_.now();
        ImGui::SameLine(0, context.px(12));
        ImGui::AlignTextToFramePadding();
        ui::muted(context,
                  now.stage.empty() ? "starting" : ui::format("%s: %.0f %%", now.stage.c_str(), 100.0 * now.fraction));
        ui::mark(context, std::string(kTables) + "stage");
        return;
    }
    const bool ready = any(chosen_) && any(grids_);
    if (ui::button(context, std::string(kTables) + "run", "Run", ui::ButtonKind::Primary, ready, 90.0F)) {
        start();
    }
    ImGui::SameLine();
    if (ui::button(context, std::string(kTables) + "save", "Save\xe2\x80\xa6", ui::ButtonKind::Plain, !rows_->empty(),
                   90.0F)) {
        save(context);
    }
    ImGui::SameLine(0, context.px(12));
    ImGui::AlignTextToFramePadding();
    ui::muted(context, !ready ? "Choose a row and a grid."
                              : "Rows D and E take minutes without a grid. Same figures as forefront tables.");
}

void TablesDialog::drawTable(Shell &context) const {
    constexpr double kHeight = 262.0;
    const int columns = static_cast<int>(kFigureColumns.size()) + 4;
    ImGui::PushFont(context.fonts.small);
    if (ImGui::BeginTable("tables", columns, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_ScrollY,
                          {0.0F, context.px(kHeight)})) {
        drawFigureHead(context);
        for (std::size_t k = 0; k < tableCases().size(); ++k) {
            const TableCase &row = tableCases()[k];
            const auto done = std::find_if(rows_->begin(), rows_->end(),
                                           [&row](const RowFigures &figures) { return figures.row.row == row.row; });
            if (done == rows_->end() && !chosen_[k]) {
                continue;
            }
            for (const TableLine &line : done != rows_->end() ? tableRowLines(*done) : publishedLines(row)) {
                drawTableLine(context, line);
            }
        }
        ImGui::EndTable();
    }
    ImGui::PopFont();
}

void TablesDialog::save(Shell &context) const {
    FileRequest request;
    request.id = "savetables";
    request.title = "Save the tables";
    request.action = "Save";
    request.saves = true;
    request.filters = {{"Figures (.csv)", {".csv"}, "figures", "Lo's figures and ours."},
                       {"Plot (.svg)", {".svg"}, "plot", "Time against elements, with fitted exponents."}};
    request.folder = startFolder(context);
    request.name = "lo-tables.csv";
    request.chosen = [rows = *rows_](Shell &c, const std::filesystem::path &file, const FileFilter &filter) {
        FileSet files;
        files.write(file, std::string_view(filter.id) == "figures" ? tableCsv(rows) : toSvg(tablePlot(rows)));
        Status status = files.commit();
        if (status.empty()) {
            c.log.announce("Saved the tables to " + file.string());
        }
        return status;
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

bool TablesDialog::draw(Shell &context) {
    takeNews(context);
    drawChoices(context);
    drawRunRow(context);
    ImGui::Dummy({0, context.px(2)});
    drawTable(context);
    ImGui::Dummy({0, context.px(2)});
    const LogPlot plot = tablePlot(*rows_);
    if (plot.series.empty()) {
        ui::small(context, "Run rows 1A to 2E to see here how the time grows with the number of elements.", true);
        ui::mark(context, std::string(kTables) + "noplot");
    } else {
        ui::logPlot(context, std::string(kTables) + "plot", plot, 200.0);
    }
    return true;
}

} // namespace forefront
