#include "core/drawing/document/equality.hpp"
#include "core/drawing/document/history.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

Document withPoint(const Document &document, Vec2 at) {
    Result<Document> next = addShape(document, makeShape(ShapeKind::Point, {at}, ShapeUse::Constraint));
    REQUIRE(next.ok());
    return *std::move(next);
}

/// Applies a random command to the document.
Document randomCommand(const Document &document, Random &random) {
    const auto some = [&](const Result<Document> &next) { return next ? *next : document; };
    Selection selection;
    if (!document.shapes.empty()) {
        selection.shapes.insert(document.shapes[random.below(static_cast<std::uint32_t>(document.shapes.size()))]->id);
    }
    const std::uint32_t id = selection.shapes.empty() ? 0 : *selection.shapes.begin();
    switch (random.below(14)) {
    case 0:
    case 1:
        return some(addShape(document, square(random.place(10), random.real(0.1, 3))));
    case 2:
        return some(addShape(document, makeShape(ShapeKind::Circle, {random.place(5), random.place(5)})));
    case 3:
        return some(addShape(document, makeShape(ShapeKind::Rectangle, {random.place(5), random.place(5)})));
    case 4:
        return some(moveSelection(document, selection, random.place(2)));
    case 5:
        return some(insertNode(document, {id, random.below(4)}, random.place(5)));
    case 6:
        return some(setHandle(document, {id, random.below(4)}, random.place(5)));
    case 7:
        selection.nodes.insert({id, random.below(4)});
        selection.shapes.clear();
        return deleteSelection(document, selection);
    case 8:
        return some(setSegmentTag(document, {{id, random.below(4)}}, static_cast<std::int32_t>(random.below(4))));
    case 9:
        return some(setSize(document, random.real(-0.1, 1)));
    case 10:
        return some(addSource(document, {SourceShape::Point, random.place(3), {}, 0.0, 0.1, 0.2, "s"}));
    case 11:
        return some(setBoundaryName(document, static_cast<std::int32_t>(random.below(5)), "wall"));
    case 12:
        return some(duplicateSelection(document, selection, {1, 1}, nullptr));
    default:
        return random.below(3) == 0 ? deleteSelection(document, selection)
                                    : some(addRegionMarker(document, {random.place(4), 2}));
    }
}

} // namespace

TEST_CASE("History: a new history has a saved document and nothing to undo") {
    History history;
    CHECK_FALSE(history.canUndo());
    CHECK_FALSE(history.canRedo());
    CHECK_FALSE(history.dirty());
    CHECK(history.undoLabel().empty());
    CHECK_FALSE(history.undo());
    CHECK_FALSE(history.redo());
}

TEST_CASE("History: labels name what undo and redo would do") {
    History history;
    CHECK(history.commit("Draw a point", withPoint(history.document(), {1, 1})));
    CHECK(history.commit("Draw another", withPoint(history.document(), {2, 1})));
    CHECK(history.undoLabel() == "Draw another");
    CHECK(history.undo());
    CHECK(history.undoLabel() == "Draw a point");
    CHECK(history.redoLabel() == "Draw another");
    CHECK(history.document().shapes.size() == 1);
    CHECK(history.redo());
    CHECK(history.document().shapes.size() == 2);
}

TEST_CASE("History: a command after undo discards the undone commands") {
    History history;
    history.commit("a", withPoint(history.document(), {1, 1}));
    history.undo();
    history.commit("b", withPoint(history.document(), {2, 2}));
    CHECK_FALSE(history.canRedo());
    CHECK(history.size() == 2);
    CHECK(history.document().shapes[0]->nodes[0] == Vec2{2, 2});
}

TEST_CASE("History: an unchanged document is not recorded") {
    History history;
    history.commit("a", withPoint(history.document(), {1, 1}));
    Document same = history.document();
    same.shapes[0] = std::make_shared<const Shape>(*same.shapes[0]);
    CHECK_FALSE(history.commit("nothing", same));
    CHECK(history.size() == 2);
}

TEST_CASE("History: a drag is one command, and two drags are two") {
    History history;
    history.commit("a", withPoint(history.document(), {0, 0}));
    const std::uint32_t id = history.document().shapes[0]->id;
    for (int drag = 0; drag < 2; ++drag) {
        for (int k = 0; k < 10; ++k) {
            Selection selection;
            selection.shapes = {id};
            history.commit("Move", *moveSelection(history.document(), selection, {1, 0}), "drag");
        }
        history.endStroke();
    }
    CHECK(history.size() == 4);
    CHECK(history.document().shapes[0]->nodes[0] == Vec2{20, 0});
    history.undo();
    CHECK(history.document().shapes[0]->nodes[0] == Vec2{10, 0});
    history.undo();
    CHECK(history.document().shapes[0]->nodes[0] == Vec2{0, 0});
}

TEST_CASE("History: an abandoned stroke leaves no trace") {
    History history;
    history.commit("a", withPoint(history.document(), {0, 0}), "stroke");
    history.commit("a", withPoint(history.document(), {1, 0}), "stroke");
    history.abandonStroke("stroke");
    CHECK(history.document().shapes.empty());
    CHECK(history.size() == 1);
    history.abandonStroke("stroke");
    CHECK(history.size() == 1);
}

TEST_CASE("History: cancelling a stroke that changed nothing keeps the one before it") {
    History history;
    history.commit("drag", withPoint(history.document(), {1, 0}), "first");
    history.abandonStroke("second");
    CHECK(history.size() == 2);
    CHECK(history.document().shapes.size() == 1);
    history.commit("drag", withPoint(history.document(), {2, 0}), "first");
    CHECK(history.size() == 2); // the first stroke goes on
}

TEST_CASE("History: cancelling a stroke restores the redo steps; ending it does not") {
    for (const bool abandon : {true, false}) {
        CAPTURE(abandon);
        History history;
        history.commit("a", withPoint(history.document(), {0, 0}));
        history.commit("b", withPoint(history.document(), {1, 0}));
        history.markSaved();
        history.commit("c", withPoint(history.document(), {2, 0}));
        history.goTo(1);
        const std::uint64_t before = history.revision();
        history.commit("drag", withPoint(history.document(), {5, 5}), "stroke");
        history.commit("drag", withPoint(history.document(), {6, 5}), "stroke");
        abandon ? history.abandonStroke("stroke") : history.endStroke();
        history.abandonStroke("stroke"); // no effect: no stroke is in progress
        if (!abandon) {
            CHECK(history.size() == 3);
            CHECK(history.undoLabel() == "drag");
            CHECK_FALSE(history.canRedo());
            continue;
        }
        CHECK(history.revision() == before);
        CHECK(history.size() == 4);
        REQUIRE(history.redo());
        CHECK(history.undoLabel() == "b");
        CHECK_FALSE(history.dirty());
        REQUIRE(history.redo());
        CHECK(history.document().shapes.size() == 3);
        CHECK_FALSE(history.canRedo());
    }
}

TEST_CASE("History: cancelling a stroke that was saved midway returns to the saved document, with nothing to redo") {
    History history;
    history.commit("a", withPoint(history.document(), {0, 0}));
    history.undo();
    history.commit("drag", withPoint(history.document(), {5, 5}), "stroke");
    history.markSaved();
    history.commit("drag", withPoint(history.document(), {6, 5}), "stroke");
    history.abandonStroke("stroke");
    CHECK_FALSE(history.dirty());
    CHECK(history.document().shapes.size() == 1);
    CHECK_FALSE(history.canRedo());
}

TEST_CASE("History: a document is dirty if it differs from the saved one, even within a stroke") {
    History history;
    history.commit("a", withPoint(history.document(), {0, 0}), "stroke");
    CHECK(history.dirty());
    history.markSaved();
    CHECK_FALSE(history.dirty());
    history.commit("a", withPoint(history.document(), {1, 0}), "stroke");
    CHECK(history.dirty());
    history.undo();
    CHECK_FALSE(history.dirty());
    CHECK(history.document().shapes.size() == 1);
    history.undo();
    CHECK(history.dirty());
    history.markUnsaved();
    history.redo();
    CHECK(history.dirty());
}

TEST_CASE("History: undoing random commands leads to the start, redoing them to the end, through the same documents "
          "both ways") {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Random random(seed);
        History history;
        std::vector<Document> seen{history.document()};
        for (int k = 0; k < 80; ++k) {
            if (history.commit("command", randomCommand(history.document(), random))) {
                seen.push_back(history.document());
            }
        }
        REQUIRE(seen.size() == history.size());
        REQUIRE(seen.size() > 20);
        for (std::size_t k = seen.size(); k-- > 0;) {
            REQUIRE(sameContent(history.document(), seen[k]));
            REQUIRE(history.undo() == (k > 0));
        }
        for (std::size_t k = 0; k < seen.size(); ++k) {
            REQUIRE(sameContent(history.document(), seen[k]));
            REQUIRE(history.redo() == (k + 1 < seen.size()));
        }
        for (const auto &shape : history.document().shapes) {
            REQUIRE(checkShape(*shape).empty());
        }
    }
}
