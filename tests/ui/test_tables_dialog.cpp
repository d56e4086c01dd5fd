#include "core/teaching/tables/table_report.hpp"
#include "tests/ui/driver.hpp"
#include "ui/dialogs/tables_dialog.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace forefront::test {

namespace tables_dialog_test {

/// Opens the dialog with one small row chosen.
class TablesReader : public Driver {
  public:
    TablesReader() : Driver({}, {1280, 800}) {
        context().actions.run("learn.tables", context());
        settle();
        for (const char *row : {"1B", "2A", "2B"}) {
            click(std::string("dialog/tables/row/") + row);
        }
        for (const char *grid : {"none", "30x20"}) {
            click(std::string("dialog/tables/grid/") + grid);
        }
    }
    const TablesDialog &dialog() {
        const auto *dialog = dynamic_cast<const TablesDialog *>(context().dialogs.top());
        REQUIRE(dialog != nullptr);
        return *dialog;
    }
};

} // namespace tables_dialog_test

TEST_CASE("Lo's tables: the dialog has the figures of the batch command, beside Lo's") {
    tables_dialog_test::TablesReader reader;
    CHECK(reader.has("dialog/tables/line/1A/none/Lo")); // before any run
    CHECK_FALSE(reader.has("dialog/tables/line/1A/hierarchical/ours"));
    reader.click("dialog/tables/run");
    reader.settle();
    REQUIRE(reader.dialog().rows().size() == 1);
    const RowFigures &shown = reader.dialog().rows().front();
    const Result<RowFigures> expected =
        runTableRow(*tableCase("1A"), {*parseTableGrid("60x40"), *parseTableGrid("hierarchical")});
    REQUIRE(expected);
    CHECK(shown.hash == expected->hash);
    CHECK(shown.elements == 31'414);
    REQUIRE(shown.grids.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(shown.grids[k].grid == expected->grids[k].grid);
        CHECK(shown.grids[k].neighbours == expected->grids[k].neighbours);
        CHECK(shown.grids[k].seconds > 0.0);
    }
    CHECK(reader.has("dialog/tables/line/1A/60x40/Lo"));
    CHECK(reader.has("dialog/tables/line/1A/60x40/ours"));
    CHECK(reader.has("dialog/tables/line/1A/hierarchical/ours"));
    CHECK(reader.has("dialog/tables/plot"));
    reader.key(key::kEscape);
    reader.settle();
    reader.context().actions.run("learn.tables", reader.context());
    reader.settle();
    CHECK(reader.dialog().rows().size() == 1); // stays
}

TEST_CASE("Lo's tables: a row that is run again with other grids keeps those of before") {
    tables_dialog_test::TablesReader reader;
    reader.click("dialog/tables/grid/60x40");
    reader.click("dialog/tables/run"); // hierarchical alone
    reader.settle();
    REQUIRE(reader.dialog().rows().size() == 1);
    REQUIRE(reader.dialog().rows().front().grids.size() == 1);
    reader.click("dialog/tables/grid/60x40");
    reader.click("dialog/tables/grid/hierarchical");
    reader.click("dialog/tables/run");
    reader.settle();
    REQUIRE(reader.dialog().rows().size() == 1);
    const std::vector<GridFigures> &grids = reader.dialog().rows().front().grids;
    REQUIRE(grids.size() == 2);
    CHECK(grids[0].grid == "60x40");
    CHECK(grids[1].grid == "hierarchical");
    CHECK(reader.has("dialog/tables/line/1A/60x40/ours"));
    CHECK(reader.has("dialog/tables/line/1A/hierarchical/ours"));
}

TEST_CASE("Lo's tables: a run can be cancelled") {
    tables_dialog_test::TablesReader reader;
    reader.click("dialog/tables/row/1E");
    reader.click("dialog/tables/grid/none");
    reader.click("dialog/tables/run");
    reader.until([&] { return reader.has("dialog/tables/stage"); });
    reader.click("dialog/tables/cancel");
    reader.settle();
    CHECK_FALSE(reader.dialog().running());
    CHECK(reader.dialog().rows().size() <= 1); // 1E takes minutes without a grid
    CHECK(reader.has("dialog/tables/run"));
}

} // namespace forefront::test
