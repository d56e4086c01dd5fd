#include "ui/shell/figure_table.hpp"

#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <cstddef>

namespace forefront::shell {

namespace {

/// Formats a figure, with its ratio to that of the first row.
std::string figureText(const std::optional<double> &value, const std::optional<double> &first, bool ratio) {
    if (!value) {
        return "\xe2\x80\x93";
    }
    std::string text = ui::number(*value, 3);
    if (ratio && first && *first > 0.0 && *value > 0.0) {
        text += ui::format("   \xc3\x97%s", ui::number(*value / *first, 3).c_str());
    }
    return text;
}

} // namespace

void drawFigureTable(WidgetContext &context, std::span<const FigureColumn> columns, std::span<const FigureRow> rows) {
    if (!ImGui::BeginTable("figures", static_cast<int>(columns.size()) + 1, ImGuiTableFlags_SizingStretchProp)) {
        return;
    }
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 1.7F);
    ImGui::TableNextColumn();
    for (const FigureColumn &column : columns) {
        ImGui::TableNextColumn();
        ui::muted(context, column.name);
        ui::tooltip(context, column.meaning);
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
        ImGui::TableNextColumn();
        ui::muted(context, rows[k].name);
        for (std::size_t c = 0; c < columns.size(); ++c) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(
                figureText(rows[k].figures[c], rows[0].figures[c], k > 0 && rows[k].comparable).c_str());
            ui::mark(context, std::string("sides/") + columns[c].id + '/' + std::to_string(k));
        }
    }
    ImGui::EndTable();
}

} // namespace forefront::shell
