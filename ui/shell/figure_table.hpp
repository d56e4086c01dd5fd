#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace forefront {
struct WidgetContext;
}

namespace forefront::shell {

/// A column of the table below the compared views.
struct FigureColumn {
    const char *id, *name, *meaning;
};

/// A row of that table: the canvas first, then each view beside it.
struct FigureRow {
    std::string name;
    std::vector<std::optional<double>> figures; ///< one per column; not set: unknown
    bool comparable = true;                     ///< with the first row: ratios mean something
};

/// Draws a table of figures. Every row but the first also shows the ratios to the first row.
void drawFigureTable(WidgetContext &context, std::span<const FigureColumn> columns, std::span<const FigureRow> rows);

} // namespace forefront::shell
