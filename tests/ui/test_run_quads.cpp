#include "tests/ui/meshed_square.hpp"
#include "ui/shell/main_window.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

namespace forefront::test {

TEST_CASE("Run: quadrilaterals chosen in the panel Meshing are meshed, with undo") {
    MeshedSquare driver;
    driver.showPanel("meshing");
    CHECK_FALSE(driver.has("meshing/quadnodes/9"));
    driver.click("meshing/elements/Quads");
    CHECK(driver.document().options.elements == Elements::Quads);
    driver.key(key::kF5);
    driver.settle();
    const SessionSnapshot &run = driver.context().run.now();
    REQUIRE(run.state == RunState::Finished);
    CHECK(run.known > 0);
    REQUIRE(run.mesh);
    CHECK(run.quality.kinds[static_cast<std::size_t>(CellKind::Quadrilateral4)] == run.quality.elements);
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.document().options.elements == Elements::Triangles);
}

TEST_CASE("Run: quadrilaterals are stepped in the workspace Step, back from their mesh and forward to it again") {
    MeshedSquare driver;
    driver.showPanel("meshing");
    driver.click("meshing/elements/Quads");
    driver.key(key::kF5);
    driver.settle();
    const std::uint64_t hash = driver.context().run.now().meshHash;
    driver.workspace(WorkspaceKind::Step);
    CHECK(driver.has("timeline/granularity/Square"));
    CHECK_FALSE(driver.has("timeline/granularity/Advance"));
    CHECK(driver.context().layer("colours")->visible);
    driver.key(key::kComma); // one step back from the end: of the clean-up
    driver.settle();
    REQUIRE(driver.run().improvement);
    CHECK(driver.run().improvement->quads);
    CHECK(shell::stateText(driver.context()).starts_with("Clean-up "));
    driver.click("timeline/start");
    driver.settle();
    CHECK(driver.run().position() == 0);
    driver.key(key::kPeriod);
    driver.settle();
    CHECK(driver.run().advance == 1);
    REQUIRE(driver.run().explanation);
    CHECK(driver.run().explanation->coloured);
    REQUIRE(driver.run().mesh);
    CHECK(driver.run().mesh->view().elementCount() == 1);
    CHECK(shell::stateText(driver.context()).find("a square with") != std::string::npos);
    driver.key(key::kComma);
    driver.settle();
    CHECK(driver.run().advance == 0);
    driver.click("timeline/end");
    driver.settle();
    CHECK(driver.run().meshHash == hash);
    CHECK(driver.run().atEnd());
}

TEST_CASE("Run: the panels Steps and Candidates tell of squares, their colours and why one is refused") {
    MeshedSquare driver;
    Document quads = *driver.context().document.current();
    quads.options.elements = Elements::Quads;
    driver.context().document.apply(std::move(quads), "Quadrilaterals");
    driver.key(key::kF5);
    driver.settle();
    driver.workspace(WorkspaceKind::Step);
    driver.showPanel("candidates");
    driver.click("timeline/start");
    driver.settle();
    std::size_t refused = 0;
    std::set<SquareKind> made;
    for (int step = 0; step < 400 && !driver.run().frontDone(); ++step) {
        driver.context().run.step(Granularity::Advance, 1);
        driver.settle();
        const AdvanceExplanation &told = *driver.run().explanation;
        made.insert(told.square);
        for (std::size_t k = 0; k < told.candidates.size(); ++k) {
            const bool isRefused = told.candidates[k].square != SquareKind::None && !told.deferred &&
                                   told.candidates[k].verdict != Verdict::Accepted;
            if (isRefused && refused++ == 0) {
                driver.click("candidates/" + std::to_string(k));
                driver.settle();
                CHECK(driver.has("candidates/worked"));
                CHECK(shell::stateText(driver.context()).find("refused: ") != std::string::npos);
            }
        }
    }
    CHECK(made.contains(SquareKind::Row));
    CHECK(made.contains(SquareKind::Closing));
    CHECK(refused > 0);
}

} // namespace forefront::test
