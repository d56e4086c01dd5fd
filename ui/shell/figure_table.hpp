#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace forefront {
struct WidgetContext;
}

namespace forefront::shell {

/// A column of the table below views side by side.
struct FigureColumn {
    const char *id, *name, *meaning;
};

/// A row of that table: the canvas first, then each view beside it.
struct FigureRow {
    std::string name;
    std::vector<std::optional<double>> figures; ///< one per column; not set: unknown
};

/// Draws a table of figures. Those of every row but the first also show their ratio to the first.
void drawFigureTable(WidgetContext &context, std::span<const FigureColumn> columns, std::span<const FigureRow> rows);

} // namespace forefront::shell
