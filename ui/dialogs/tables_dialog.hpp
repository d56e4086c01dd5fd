#pragma once

#include "core/teaching/tables/table_report.hpp"
#include "core/teaching/tables/table_run.hpp"
#include "ui/background/latest.hpp"
#include "ui/parts/dialog.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// The rows of Lo's tables that were run since the program started, in the order of the tables; each once, with all the
/// grids that it was run with.
using TableRows = std::vector<RowFigures>;

/// Runs the rows of S. H. Lo's tables on a separate thread and shows our figures beside his, and the time against the
/// number of elements. Closing the dialog stops the run; the rows that are done stay.
class TablesDialog final : public Dialog {
  public:
    /// `rows`: those of earlier runs; never null.
    TablesDialog(BackgroundList &list, std::shared_ptr<TableRows> rows);

    const char *id() const override { return "tables"; }
    std::string title() const override { return "Lo's tables"; }
    float width() const override { return 1120.0F; }
    float height() const override { return 660.0F; }
    bool draw(Shell &context) override;

    bool running() const { return running_; }
    const TableRows &rows() const { return *rows_; }

  private:
    static constexpr std::size_t kCases = 12, kGrids = 4;

    struct Request {
        std::vector<TableCase> rows;
        std::vector<TableGrid> grids;
    };
    /// What a run has done so far.
    struct State {
        std::string stage;
        double fraction = 0.0;                 ///< of the stage
        std::shared_ptr<const TableRows> rows; ///< done; null: none
        std::optional<Diagnostics> end;        ///< why the run ended: empty, it is done; not set: it goes on
    };
    static State answer(const LatestTurn<Request, State> &turn);

    void start();
    void takeNews(Shell &context);
    void drawChoices(Shell &context);
    void drawRunRow(Shell &context);
    void drawTable(Shell &context) const;
    void save(Shell &context) const;

    std::shared_ptr<TableRows> rows_;
    std::array<bool, kCases> chosen_{};
    std::array<bool, kGrids> grids_{};
    bool running_ = false;
    Latest<Request, State> worker_;
};

} // namespace forefront
