#include "tests/ui/slow_entry.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>

namespace forefront::test {

TEST_CASE("Slow frames: shapes drawn with typed numbers") {
    expectSame("rectangle", typedRectangle);
    expectSame("circle", [](Typist &typist) {
        typist.write("c");
        tabbed(typist, "11");
        enter(typist, "12");
        enter(typist, "3");
        typist.write("v");
    });
    expectSame("polygon", [](Typist &typist) {
        typist.write("p");
        enter(typist, "1,1");
        tabbed(typist, "4");
        enter(typist, "30");
        enter(typist, "x3");
        enter(typist, "y6");
        typist.tap(key::kBackspace);
        enter(typist, "@-2,1");
        typist.tap(key::kEnter);
    });
    expectSame("slot", [](Typist &typist) {
        typist.write("u");
        enter(typist, "1,1");
        tabbed(typist, "4");
        enter(typist, "0");
        enter(typist, "1");
    });
}

TEST_CASE("Slow frames: the numbers of a shape in its panel") {
    expectSame("circle in its panel", [](Typist &typist) {
        typist.write("c");
        enter(typist, "5,5");
        enter(typist, "2");
        typist.write("v");
        typist.touch("inspector/centre/x");
        tabbed(typist, "11");
        tabbed(typist, "12");
        enter(typist, "3");
        typist.write("v");
    });
    expectSame("name", [](Typist &typist) {
        selectedRectangle(typist);
        typist.touch("inspector/name");
        tabbed(typist, "plate");
        tabbed(typist, "3");
        tabbed(typist, "4");
        typist.tap(key::kTab, kShift);
        typist.tap(key::kTab, kShift);
        enter(typist, "7");
    });
}

TEST_CASE("Slow frames: a size line, drawn and then changed in its panel") {
    expectSame("line", [](Typist &typist) {
        typedRectangle(typist);
        typist.write("s");
        typist.touch("options/source/shape/Line");
        enter(typist, "2,3");
        enter(typist, "5,5");
        typist.write("v");
        typist.touch("inspector/b/x");
        tabbed(typist, "4");
        tabbed(typist, "4.5");
        tabbed(typist, "0.08");
        tabbed(typist, "0.02");
        typist.tap(key::kEnter);
    });
}

TEST_CASE("Slow frames: fields of the spacing, parameters and tool options") {
    expectSame("spacing", [](Typist &typist) {
        typedRectangle(typist);
        typist.showPanel("spacing");
        typist.touch("spacing/size");
        tabbed(typist, "0.5");
        tabbed(typist, "0.2+0.1*x");
        tabbed(typist, "0.125");
        tabbed(typist, "2");
        tabbed(typist, "0.3");
        enter(typist, "40");
    });
    expectSame("parameters", [](Typist &typist) {
        typist.showPanel("parameters");
        typist.touch("parameters/add");
        tabbed(typist, "width");
        enter(typist, "2*3");
    });
    expectSame("options", [](Typist &typist) {
        typedRectangle(typist);
        typist.write("b");
        typist.touch("options/brush/radius");
        tabbed(typist, "0.7");
        enter(typist, "0.05");
        typist.finish();
        typist.dragPlaces({3, 3}, {4, 4});
    });
}

TEST_CASE("Slow frames: names, sizes and commands that open a field") {
    expectSame("name of a shape", [](Typist &typist) {
        typedRectangle(typist);
        typist.write("v");
        typist.tap(key::kF1 + 1);
        enter(typist, "plate");
        typist.tap('F', kShift);
        enter(typist, "0.25");
        typist.write("r");
    });
    expectSame("name of a segment", [](Typist &typist) {
        selectedRectangle(typist);
        typist.clickPlace({3, 2});
        typist.clickPlace({3, 2});
        typist.tap(key::kF1 + 1);
        enter(typist, "wall");
        typist.tap('T', kShift);
        enter(typist, "7");
    });
    expectSame("palette", [](Typist &typist) {
        typedRectangle(typist);
        typist.tap('P', kControl);
        enter(typist, "duplicate");
        typist.tap('P', kControl);
        enter(typist, "convert to path");
        typist.write("c");
        enter(typist, "1,1");
        enter(typist, "0.5");
    });
    expectSame("operation", [](Typist &typist) {
        typedRectangle(typist);
        typist.write("v");
        typist.tap('P', kControl);
        enter(typist, "linear array");
        enter(typist, "4");
        typist.write("r");
    });
}

TEST_CASE("Slow frames: round shapes and arcs drawn with typed numbers") {
    expectSame("ellipse", [](Typist &typist) {
        typist.write("k");
        tabbed(typist, "1");
        enter(typist, "2");
        tabbed(typist, "6");
        enter(typist, "3");
        typist.finish();
        CHECK(typist.document().shapes.size() == 1);
    });
    expectSame("regular polygon", [](Typist &typist) {
        typist.write("h");
        typist.touch("options/sides");
        enter(typist, "5");
        enter(typist, "5,4");
        enter(typist, "2.5");
        typist.finish();
        REQUIRE(typist.document().shapes.size() == 1);
        CHECK(typist.document().shapes[0]->nodes.size() == 5);
    });
    expectSame("arc", [](Typist &typist) {
        typist.write("a");
        typist.touch("options/arc/Three points");
        enter(typist, "1,1");
        enter(typist, "3,1");
        enter(typist, "2,2");
        typist.finish();
        CHECK(typist.document().shapes.size() == 1);
    });
}

TEST_CASE("Slow frames: sources and gradients") {
    expectSame("box", [](Typist &typist) {
        typedRectangle(typist);
        typist.write("s");
        typist.touch("options/source/shape/Box");
        typist.touch("options/source/size");
        enter(typist, "0.15");
        enter(typist, "2,3");
        enter(typist, "5,5");
        typist.finish();
        REQUIRE(typist.document().spacing.sources.size() == 1);
        CHECK(typist.document().spacing.sources[0].size == 0.15);
    });
    expectSame("disc", [](Typist &typist) {
        typedRectangle(typist);
        typist.write("s");
        typist.touch("options/source/shape/Circle");
        enter(typist, "4,4");
        enter(typist, "1");
        typist.finish();
        CHECK(typist.document().spacing.sources.size() == 1);
    });
    expectSame("gradient", [](Typist &typist) {
        typedRectangle(typist);
        typist.write("d");
        typist.touch("options/gradient/size");
        tabbed(typist, "0.1");
        enter(typist, "0.5");
        typist.finish();
        typist.dragPlaces({2, 3}, {6, 3});
        CHECK(typist.document().spacing.hasGradient());
    });
}

TEST_CASE("Slow frames: the table of nodes, elements of a side, boundary layers and strips") {
    expectSame("nodes", [](Typist &typist) {
        typist.write("p");
        enter(typist, "1,1");
        enter(typist, "6,1");
        enter(typist, "6,5");
        typist.tap(key::kEnter);
        typist.write("v");
        typist.showPanel("nodes");
        typist.touch("nodes/1/2/x");
        tabbed(typist, "7");
        tabbed(typist, "1.5");
        enter(typist, "6.5");
        typist.finish();
        CHECK(typist.document().shapes[0]->nodes[1] == Vec2{7, 1.5});
    });
    const auto chooseSide = [](Typist &typist) {
        selectedRectangle(typist);
        typist.clickPlace({3, 2});
        typist.clickPlace({3, 2});
        typist.settle();
    };
    expectSame("elements and bias", [&](Typist &typist) {
        chooseSide(typist);
        typist.touch("inspector/elements");
        enter(typist, "10");
        typist.touch("inspector/bias");
        enter(typist, "4");
        typist.write("v");
    });
    expectSame("boundary layers", [&](Typist &typist) {
        typist.touch("workspace/Size");
        chooseSide(typist);
        typist.touch("inspector/layers/first");
        enter(typist, "0.02");
        typist.touch("inspector/layers/count");
        enter(typist, "5");
        typist.finish();
        REQUIRE(typist.document().layers.size() == 1);
        CHECK(typist.document().layers.begin()->count == 5);
    });
    expectSame("strip", [&](Typist &typist) {
        typist.write("l");
        enter(typist, "2,3");
        enter(typist, "6,3");
        typist.tap(key::kEnter);
        typist.write("v");
        typist.finish();
        typist.clickPlace({4, 3});
        typist.settle();
        typist.touch("inspector/strip/width");
        enter(typist, "0.2");
        typist.touch("inspector/strip/rows");
        enter(typist, "2");
        typist.write("v");
    });
}

TEST_CASE("Slow frames: a row of the shapes is renamed") {
    expectSame("rename", [](Typist &typist) {
        typedRectangle(typist);
        typist.write("v");
        typist.showPanel("shapes");
        typist.touch("shapes/1");
        typist.tap(key::kF1 + 1);
        enter(typist, "plate");
        typist.write("c");
        typist.finish();
        CHECK(typist.document().shapes[0]->name == "plate");
    });
}

TEST_CASE("Slow frames: options of an import") {
    const TemporaryFolder place;
    std::ofstream(place.path / "box.svg")
        << R"(<svg viewBox="0 0 10 10"><rect x="2" y="1" width="3" height="4"/></svg>)";
    expectSame("import", [&](Typist &typist) {
        typist.tap('I', kControl);
        typist.finish();
        typist.chooseFile("import", place.path / "box.svg");
        typeOver(typist, "dialog/importoptions/weld", "0.01");
        typist.touch("dialog/importoptions/scale");
        enter(typist, "2");
        typist.tap(key::kEnter);
        typist.finish();
        CHECK(typist.document().shapes.size() == 1);
    });
}

TEST_CASE("Slow frames: sizes of new drawings in the preferences") {
    expectSame(
        "sizes of new drawings",
        [](Typist &typist) {
            typist.context().actions.run("edit.preferences", typist.context());
            typist.settle();
            typist.touch("dialog/preferences/page/New drawings");
            typist.touch("dialog/preferences/new/size");
            tabbed(typist, "0.25");
            tabbed(typist, "0.1");
            tabbed(typist, "40");
            enter(typist, "3");
        },
        [](Typist &typist) {
            const Settings &settings = typist.context().settings;
            CHECK(settings.newSize == 0.25);
            CHECK(settings.newGradation == 0.1);
            CHECK(settings.newPerTurn == 40.0);
            CHECK(settings.newAcross == 3.0);
            return std::string();
        });
}

TEST_CASE("Slow frames: a field takes all that has been typed since the last frame") {
    Typist typist(true);
    typist.write("c");
    enter(typist, "5,5");
    enter(typist, "2");
    typist.write("v");
    typist.finish();
    typist.tap('P', kControl);
    typist.finish();
    for (const char c : std::string_view("a long name that has forty-six characters here")) {
        const int code = c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c;
        typist.editor().input().push({.kind = InputKind::Key, .code = code, .pressed = true});
        typist.editor().input().push({.kind = InputKind::Text, .code = static_cast<unsigned char>(c)});
        typist.editor().input().push({.kind = InputKind::Key, .code = code});
    }
    typist.frames(2);
    CHECK(typist.editor().input().empty());
    CHECK(typist.has("palette/none"));
}

TEST_CASE("InputQueue: a held key repeats at most once a frame, and not after its release") {
    InputQueue queue;
    queue.push({.kind = InputKind::Key, .code = key::kBackspace, .pressed = true});
    for (int k = 0; k < 9; ++k) {
        queue.push({.kind = InputKind::Key, .code = key::kBackspace, .pressed = true, .repeated = true});
    }
    queue.push({.kind = InputKind::Key, .code = key::kBackspace});
    CHECK(queue.takeFrame().size() == 1);
    CHECK(queue.takeFrame().size() == 1);
    CHECK(queue.empty());
}

TEST_CASE("Fields: a key that is held down repeats as the keyboard says, not as long as a frame lasts") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 8});
    driver.key('V');
    driver.click("inspector/name");
    driver.type("abcdef");
    driver.platform().setFrameSeconds(0.3);
    InputQueue &input = driver.editor().input();
    input.push({.kind = InputKind::Key, .code = key::kBackspace, .pressed = true});
    driver.frames(4); // the release comes late
    input.push({.kind = InputKind::Key, .code = key::kBackspace});
    driver.frames(2);
    input.push({.kind = InputKind::Key, .code = key::kBackspace, .pressed = true});
    driver.frames(1);
    input.push({.kind = InputKind::Key, .code = key::kBackspace, .pressed = true, .repeated = true});
    driver.frames(1);
    input.push({.kind = InputKind::Key, .code = key::kBackspace});
    driver.frames(1);
    driver.key(key::kEnter);
    CHECK(driver.document().shapes[0]->name == "abc");
}

} // namespace forefront::test
