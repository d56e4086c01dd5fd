#include "core/drawing_files/project/project.hpp"
#include "tests/support/png_sample.hpp"
#include "tests/ui/slow_entry.hpp"
#include "ui/lessons/lesson_player.hpp"
#include "ui/workspace/run/run_control.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace forefront::test {

namespace {

void chooseTool(Typist &typist, std::string_view tool) {
    typist.finish();
    typist.context().tools.choose(tool, typist.context());
    typist.context().animate();
    typist.settle();
}

std::filesystem::path greyPicture(const TemporaryFolder &place) {
    const std::filesystem::path file = place / "sizes.png";
    std::ofstream(file, std::ios::binary) << testing::greyPng(4, 2, {0, 0, 255, 255, 0, 0, 255, 255});
    return file;
}

/// Drops a picture on a rectangle, and chooses the tool for it.
void placePicture(Typist &typist, const TemporaryFolder &place) {
    typedRectangle(typist);
    typist.finish();
    typist.editor().input().push({.kind = InputKind::Drop, .paths = {greyPicture(place).string()}});
    typist.frames(2);
    typist.settle();
    chooseTool(typist, "picture");
}

/// Returns what the fields of the dialog show.
std::string filmText(Typist &typist) {
    std::string text;
    for (const char *field : {"from", "to", "frames", "width", "speed"}) {
        typist.touch(std::string("dialog/film/") + field);
        typist.finish();
        const auto &entry = typist.context().widgets.fields.entry;
        text += (entry ? entry->initial : std::string("none")) + ' ';
    }
    return text;
}

} // namespace

TEST_CASE("Slow frames: tags and numbers of the next shape in the options bar") {
    expectSame("tag of the next shape", [](Typist &typist) {
        typist.write("r");
        typist.touch("options/tag");
        enter(typist, "4");
        typist.touch("options/cornerradius");
        enter(typist, "0.5");
        tabbed(typist, "1");
        enter(typist, "2");
        tabbed(typist, "6");
        enter(typist, "5");
    });
    expectSame("grid step", [](Typist &typist) {
        typist.write("p");
        typist.finish();
        typist.context().snapping.toGrid = true;
        typist.settle();
        typist.touch("options/snap/step");
        enter(typist, "0.5");
        typist.finish();
        CHECK(typist.context().snapping.gridStep == 0.5);
        typist.clickPlace({1.1, 1.1});
        typist.clickPlace({4.1, 1.1});
        typist.clickPlace({4.1, 3.1});
        typist.tap(key::kEnter);
        typist.finish();
        REQUIRE(typist.document().shapes.size() == 1);
        CHECK(typist.document().shapes[0]->nodes[0] == Vec2{1, 1});
    });
    expectSame("freehand tolerance", [](Typist &typist) {
        typist.write("p");
        typist.touch("options/pen/Freehand");
        typist.touch("options/tolerance");
        enter(typist, "0.4");
        typist.finish();
        typist.dragPlaces({2, 2}, {6, 3});
    });
    expectSame("brush", [](Typist &typist) {
        typedRectangle(typist);
        typist.write("b");
        typeOver(
            typist,
            {{"options/brush/strength", "0.5"}, {"options/brush/falloff", "0.25"}, {"options/brush/spacing", "0.06"}});
        typist.finish();
        typist.dragPlaces({3, 3}, {4, 4});
    });
    expectSame("sizes of the next source", [](Typist &typist) {
        typedRectangle(typist);
        typist.write("s");
        typist.touch("options/source/shape/Line");
        typeOver(typist, {{"options/source/size", "0.2"}, {"options/source/endsize", "0.3"}});
        replaceText(typist, "options/source/growth", "0.25");
        enter(typist, "2,3");
        enter(typist, "5,5");
        typist.finish();
        CHECK(typist.document().spacing.sources.size() == 1);
    });
    expectSame("region of the next click", [](Typist &typist) {
        typedRectangle(typist);
        chooseTool(typist, "region");
        typeOver(typist, "options/region/tag", "3");
        typist.touch("options/region/name");
        enter(typist, "steel");
        typist.finish();
        typist.clickPlace({4, 4});
        typist.settle();
    });
    expectSame("place of the picture", [](Typist &typist) {
        static const TemporaryFolder place;
        placePicture(typist, place);
        typeOver(typist, {{"options/picture/x", "1"},
                          {"options/picture/y", "2"},
                          {"options/picture/width", "6"},
                          {"options/picture/angle", "10"}});
        typist.write("v");
    });
    expectSame("calibration of the picture", [](Typist &typist) {
        static const TemporaryFolder place;
        placePicture(typist, place);
        typist.touch("options/picture/mode/Calibrate");
        typist.finish();
        const BackgroundPicture picture = *typist.document().picture;
        typist.clickPlace(picture.corner + Vec2{0.25 * picture.size.x, 0.5 * picture.size.y});
        typist.clickPlace(picture.corner + Vec2{0.75 * picture.size.x, 0.5 * picture.size.y});
        typist.settle();
        typeOver(typist, {{"options/picture/distance", "3"},
                          {"options/picture/x1", "2"},
                          {"options/picture/y1", "3"},
                          {"options/picture/x2", "6"},
                          {"options/picture/y2", "4"}});
        typist.write("v");
    });
    expectSame("size in the options of meshing", [](Typist &typist) {
        typedRectangle(typist);
        typist.finish();
        typist.workspace(WorkspaceKind::Mesh);
        typist.settle();
        typist.touch("options/mesh/size");
        enter(typist, "0.5");
        typist.write("v");
    });
    expectSame("point by typed numbers", [](Typist &typist) {
        typedRectangle(typist);
        chooseTool(typist, "point");
        enter(typist, "3,4");
        enter(typist, "4,5");
        typist.write("v");
        typist.finish();
        CHECK(typist.document().shapes.size() == 3);
    });
    expectSame("polyline by typed numbers", [](Typist &typist) {
        typist.write("l");
        enter(typist, "1,1");
        enter(typist, "4,2");
        typist.tap(key::kEnter);
    });
}

TEST_CASE("Slow frames: steps and values of the ways to stop") {
    expectSame(
        "breakpoints",
        [](Typist &typist) {
            selectedRectangle(typist);
            typist.workspace(WorkspaceKind::Step);
            typist.context().run.step(3);
            typist.settle();
            typist.touch("timeline/breakpoints");
            typist.finish();
            replaceText(typist, "breakpoints/" + std::to_string(static_cast<int>(StopKind::LowAlpha)) + "/value",
                        "0.8");
            typist.finish();
        },
        [](Typist &typist) { return std::to_string(typist.context().run.breakpoints().alphaBelow); });
}

TEST_CASE("Slow frames: fields of the file dialog") {
    const TemporaryFolder place;
    std::filesystem::create_directories(place / "other");
    expectSame(
        "file name",
        [&](Typist &typist) {
            typedRectangle(typist);
            typist.tap('S', {Modifiers::kControl | Modifiers::kShift});
            typist.tap('A', kControl);
            enter(typist, (place.path / (typist.slow() ? "b" : "a")).string());
            typist.write("c");
        },
        [&](Typist &typist) {
            return std::to_string(
                std::filesystem::exists(place.path / (typist.slow() ? "b.forefront" : "a.forefront")));
        });
    REQUIRE(writeProject(place.path / "other.forefront", Document()).empty());
    const auto fileOf = [](Typist &typist) { return typist.context().document.path().filename().string(); };
    for (const bool byMenu : {false, true}) {
        CAPTURE(byMenu);
        const auto run = [byMenu](Typist &typist, int key, const char *item) {
            if (byMenu) {
                typist.touch("menu/File");
                typist.touch(item);
            } else {
                typist.tap(key, kControl);
            }
        };
        expectSame(
            "file to open after saving",
            [&](Typist &typist) {
                typedRectangle(typist);
                run(typist, 'S', "menu/file.save");
                typist.tap('A', kControl);
                enter(typist, (place.path / (byMenu ? "e" : "f")).string() + (typist.slow() ? "1" : "0"));
                run(typist, 'O', "menu/file.open");
                enter(typist, "other.forefront");
                typist.write("c");
                typist.finish();
                CHECK(fileOf(typist) == "other.forefront");
            },
            fileOf);
    }
    expectSame(
        "folder of files",
        [&](Typist &typist) {
            typedRectangle(typist);
            typist.tap('S', {Modifiers::kControl | Modifiers::kShift});
            replaceText(typist, "dialog/save/path", (place.path / "other").string());
            replaceText(typist, "dialog/save/name", typist.slow() ? "d" : "c");
            typist.write("c");
        },
        [&](Typist &typist) {
            return std::to_string(
                std::filesystem::exists(place.path / "other" / (typist.slow() ? "d.forefront" : "c.forefront")));
        });
    expectSame(
        "new folder",
        [&](Typist &typist) {
            typedRectangle(typist);
            typist.tap('S', {Modifiers::kControl | Modifiers::kShift});
            replaceText(typist, "dialog/save/path", place.path.string());
            typist.touch("dialog/save/newfolder");
            replaceText(typist, "dialog/save/newfolder/name", typist.slow() ? "f" : "e");
            typist.finish();
            typist.tap(key::kEscape);
            typist.write("c");
        },
        [&](Typist &typist) {
            return std::to_string(std::filesystem::is_directory(place.path / (typist.slow() ? "f" : "e")));
        });
}

TEST_CASE("Slow frames: films, pictures of moments and sizes from a picture") {
    expectSame(
        "film",
        [](Typist &typist) {
            meshedRectangle(typist);
            typist.context().actions.run("file.exportFilm", typist.context());
            typist.settle();
            typist.touch("dialog/film/from");
            typist.tap('A', kControl);
            tabbed(typist, "2");
            tabbed(typist, "9");
            tabbed(typist, "5");
            typeOver(typist, {{"dialog/film/width", "320"}, {"dialog/film/speed", "12"}});
        },
        filmText);
    expectSame("moment", [](Typist &typist) {
        meshedRectangle(typist);
        typist.context().actions.run("file.exportMoment", typist.context());
        typist.settle();
        typeOver(typist, "dialog/moment/width", "320");
        typist.tap(key::kEscape);
        typist.write("c");
    });
    const TemporaryFolder place;
    expectSame("sizes of a picture", [&](Typist &typist) {
        selectedRectangle(typist);
        typist.context().actions.run("file.importSpacing", typist.context());
        typist.frames(5);
        typist.chooseFile("importspacing", greyPicture(place));
        typist.touch("dialog/picturespacing/black");
        typist.tap('A', kControl);
        tabbed(typist, "0.25");
        tabbed(typist, "0.5");
        typeOver(typist, {{"dialog/picturespacing/corner/x", "1"},
                          {"dialog/picturespacing/corner/y", "2"},
                          {"dialog/picturespacing/width", "6"}});
        typist.touch("dialog/picturespacing/ok");
    });
}

TEST_CASE("Slow frames: adapting, lessons, keys and pasted nodes") {
    expectSame("adapt", [](Typist &typist) {
        meshedRectangle(typist);
        typist.showPanel("adapt");
        typist.touch("adapt/expression");
        tabbed(typist, "x*x");
        typeOver(typist,
                 {{"adapt/error", "7"}, {"adapt/rounds", "3"}, {"adapt/minimum", "0.1"}, {"adapt/maximum", "2"}});
        typist.write("c");
    });
    expectSame(
        "number of a lesson",
        [](Typist &typist) {
            typist.tap(key::kF1 + 3);
            typist.finish();
            typist.tap(key::k0 + 3, kAlt);
            typist.finish();
            REQUIRE(typist.context().lessons.open);
            goToPage(typist.context(), 2);
            typist.settle();
            typist.tap(key::k0, kAlt);
            typist.tap('A', kControl);
            enter(typist, "0.5");
            typist.tap('A', kControl);
            enter(typist, "0.99");
        },
        [](Typist &typist) { return std::to_string(typist.has("lesson/right")); });
    expectSame(
        "find a command",
        [](Typist &typist) {
            typist.context().actions.run("edit.preferences", typist.context());
            typist.settle();
            typist.touch("dialog/preferences/page/Keys");
            typist.touch("dialog/preferences/keys/find");
            typist.write("undo");
        },
        [](Typist &typist) {
            return std::to_string(typist.has("dialog/preferences/key/edit.undo")) +
                   std::to_string(typist.has("dialog/preferences/key/file.save"));
        });
    expectSame("snap step", [](Typist &typist) {
        typist.context().actions.run("edit.preferences", typist.context());
        typist.settle();
        typist.touch("dialog/preferences/page/Snapping");
        typeOver(typist, "dialog/preferences/snap/step", "0.5");
        typist.tap(key::kEscape);
    });
    expectSame("pasted nodes", [](Typist &typist) {
        typist.write("p");
        enter(typist, "1,1");
        enter(typist, "6,1");
        enter(typist, "6,5");
        typist.tap(key::kEnter);
        typist.write("v");
        typist.finish();
        typist.showPanel("nodes");
        typist.platform().setClipboard("1\t1\n7\t1\nsix\t5\n");
        typist.touch("nodes/paste");
        typist.touch("nodes/pasted/2");
        typist.tap('A', kControl);
        enter(typist, "6.5; 5.5");
        typist.write("c");
        typist.finish();
        CHECK(typist.document().shapes[0]->nodes[2] == Vec2{6.5, 5.5});
    });
}

} // namespace forefront::test
