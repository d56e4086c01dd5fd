#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/ui/two_faces.hpp"

#include <doctest/doctest.h>
#include <imgui.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

namespace forefront::test {

namespace {

/// A user who tries the right button everywhere.
class RightClicker : public Draughtsman {
  public:
    void rightClickAt(Pixel at) {
        moveTo(at);
        press(at, MouseButton::Right);
        release(at, MouseButton::Right);
        settle();
    }
    void rightClickPlace(Vec2 place) { rightClickAt(pixel(place)); }
    void rightClick(std::string_view widget) {
        const auto *found = context().widgets.find(widget);
        REQUIRE_MESSAGE(found != nullptr, std::string(widget));
        rightClickAt(found->rect.centre());
    }
    bool offers(std::string_view command) { return has("contextmenu/" + std::string(command)); }
    void choose(std::string_view command) {
        const std::string item = "contextmenu/" + std::string(command);
        REQUIRE_MESSAGE(has(item), item);
        click(item);
        settle();
    }
    void leave() {
        key(key::kEscape);
        settle();
    }
    void twoFaces() {
        drawTwoFaces(*this);
        context().selection.clear();
        settle();
    }
    /// Adds a point source, which has no name.
    void source(Vec2 at) {
        context().document.apply(*addSource(document(), {.shape = SourceShape::Point, .a = at, .size = 0.1}), "Add");
        settle();
    }
    /// Types a name into the field that is open, and presses Enter.
    void typeName(std::string_view name) {
        REQUIRE(has("naming/name"));
        key('A', {Modifiers::kControl});
        type(name);
        key(key::kEnter);
        settle();
    }
};

} // namespace

TEST_CASE("Right click: with the region tool, a face is made a region, named, given a size, selected and deleted") {
    RightClicker user;
    user.twoFaces();
    user.key('G');
    user.rightClickPlace({3, 4});
    CHECK_FALSE(user.offers("region/rename"));
    user.choose("region/make");
    REQUIRE(user.document().regionMarkers.size() == 1);
    user.rightClickPlace({4, 6}); // away from the marker
    CHECK_FALSE(user.offers("region/make"));
    user.choose("nameFace");
    user.typeName("steel");
    CHECK(user.document().regionNames.at(2) == "steel");
    user.rightClickPlace({4, 6});
    user.choose("region/size");
    user.type("0.3");
    user.key(key::kEnter);
    user.settle();
    CHECK(user.document().regionMarkers[0].size == 0.3);
    user.context().selection.clear();
    user.key('G');
    user.rightClickPlace({4, 6});
    user.choose("region/select");
    CHECK(user.context().selection.markers == std::set<std::uint32_t>{0});
    CHECK(std::string_view(user.context().tools.current().id()) == "select");
    user.key('G');
    user.rightClickPlace({4, 6});
    user.choose("region/delete");
    CHECK(user.document().regionMarkers.empty());
    CHECK(user.undoLabel() == "Delete region");
}

TEST_CASE("Right click: with the select tool, a face that is a region offers its commands beside those of its shape") {
    RightClicker user;
    user.twoFaces();
    user.context().document.apply(*addRegionMarker(user.document(), {{2.4, 3.4}, 2}), "Region");
    user.settle();
    user.key('V');
    user.rightClickPlace({4, 6});
    CHECK(user.offers("edit.setTag")); // of the rectangle
    user.choose("region/rename");
    user.typeName("resin");
    CHECK(user.document().regionNames.at(2) == "resin");
    user.rightClickPlace({7, 4}); // a face without a region
    CHECK_FALSE(user.offers("region/rename"));
    CHECK_FALSE(user.offers("region/make"));
}

TEST_CASE("Right click: a source is renamed, duplicated and deleted from its row and on the canvas; F2 renames it") {
    RightClicker user;
    user.twoFaces();
    user.source({6, 4});
    user.showPanel("spacing");
    user.settle();
    user.rightClick("spacing/source/0");
    CHECK(user.context().selection.sources == std::set<std::uint32_t>{0});
    CHECK(user.offers("view.zoomSelection"));
    user.choose("edit.rename");
    user.typeName("wake");
    CHECK(user.document().spacing.sources[0].name == "wake");
    CHECK(user.undoLabel() == "Name source");
    user.rightClick("spacing/source/0");
    user.choose("edit.duplicate");
    CHECK(user.document().spacing.sources.size() == 2);
    user.rightClick("spacing/source/1");
    user.choose("edit.delete");
    REQUIRE(user.document().spacing.sources.size() == 1);
    user.key('V');
    user.context().selection.clear();
    user.rightClickPlace({6, 4});
    CHECK(user.offers("edit.rename"));
    user.leave();
    user.key(key::kF1 + 1);
    user.settle();
    user.typeName("jet");
    CHECK(user.document().spacing.sources[0].name == "jet");
}

TEST_CASE("Right click: a segment gets a node where it was clicked, and turns into a curve and back") {
    RightClicker user;
    user.polygon({{1, 1}, {9, 1}, {9, 8}, {1, 8}});
    user.key('V');
    user.key(key::kEscape);
    user.rightClickPlace({4, 1});
    user.choose("segment/insert");
    REQUIRE(user.document().shapes[0]->nodes.size() == 5);
    user.key(key::kEscape);
    user.rightClickPlace({9, 4});
    user.choose("segment/form");
    CHECK(user.undoLabel() == "Segment to curve");
    user.key(key::kEscape);
    user.rightClickPlace({9, 4.5});
    user.choose("segment/form");
    CHECK(user.undoLabel() == "Segment to line");
}

TEST_CASE("Right click: each boundary part of a shape with two tags can be given an element size") {
    RightClicker user;
    user.rectangle({1, 1}, {9, 8});
    const std::uint32_t id = user.document().shapes[0]->id;
    Document named = *setSegmentTag(user.document(), {{id, 0}}, 2);
    named = *setBoundaryName(named, 2, "inlet");
    user.context().document.apply(named, "Tag");
    user.key('V');
    user.context().selection.clear();
    user.settle();
    user.rightClickPlace({5, 5});
    CHECK(user.offers("edit.setSize")); // for all segments
    user.choose("partSize/2");
    user.type("0.2");
    user.key(key::kEnter);
    user.settle();
    CHECK(user.document().shapes[0]->segmentSizes ==
          std::map<std::uint32_t, SegmentSize>{{0, {.size = 0.2, .elements = 0, .growth = 0.2}}});
    CHECK(user.document().spacing.partSizes.empty());
    CHECK(user.document().boundaryNames.size() == 1);
}

TEST_CASE("Right click: a finished measurement offers its values") {
    RightClicker user;
    user.rectangle({1, 1}, {9, 8});
    user.key('M');
    user.clickPlace({2, 2});
    user.clickPlace({5, 6});
    user.rightClickPlace({5, 6});
    CHECK(user.offers("clear"));
    user.leave();
    user.rightClickPlace({3.5, 4});
    REQUIRE(user.offers("copy/"));
    user.choose("copy/");
    CHECK(user.platform().clipboard() == "5");
    user.key(key::kEscape);
    user.dragPlaces({2, 2}, {5, 6});
    user.rightClickPlace({5, 6});
    CHECK(user.offers("copy/"));
}

TEST_CASE("Right click: the button of a tool leads to its key; the bars offer panels and preferences") {
    RightClicker user;
    user.rightClick("tool/rectangle");
    user.choose("tool/choose");
    CHECK(std::string_view(user.context().tools.current().id()) == "rectangle");
    user.key('C');
    user.frames(2);
    user.rightClick("tool/circle");
    user.choose("tool/key");
    CHECK(user.has("dialog/preferences/key/tool.circle"));
    CHECK_FALSE(user.has("dialog/preferences/key/tool.rectangle"));
    user.leave();
    const PixelRect menus = user.context().widgets.find("menu/Help")->rect;
    user.rightClickAt({menus.x + menus.width + 30.0, menus.centre().y});
    CHECK(user.offers("edit.preferences"));
    user.choose("view.panels");
    CHECK_FALSE(user.context().view.panels);
    user.rightClick("status/pointer");
    CHECK(user.offers("edit.preferences"));
    user.choose("view.panels");
    CHECK(user.context().view.panels);
    user.rectangle({1, 1}, {9, 8});
    user.key(key::kF5);
    user.settle();
    user.rightClick("status/counts");
    user.choose("status/hash");
    CHECK(user.platform().clipboard().size() == 16);
}

TEST_CASE("Right click: sections are hidden, shown, moved and pinned, and the settings keep that") {
    const TemporaryFolder place;
    EditorSetup setup;
    setup.settingsFolder = place.path;
    const auto choose = [](Draughtsman &user, const std::string &panel, const std::string &command) {
        const Pixel at = user.context().widgets.find("panel/" + panel)->rect.centre();
        user.moveTo(at);
        user.press(at, MouseButton::Right);
        user.release(at, MouseButton::Right);
        user.settle();
        user.click("contextmenu/panel/" + command);
        user.settle();
    };
    const auto top = [](Draughtsman &user, const std::string &panel) {
        return user.context().widgets.find("panel/" + panel)->rect.y;
    };
    {
        Draughtsman user(setup);
        choose(user, "parameters", "hide");
        CHECK_FALSE(user.has("panel/parameters"));
        REQUIRE(top(user, "inspector") > top(user, "shapes"));
        choose(user, "inspector", "up");
        CHECK(top(user, "inspector") < top(user, "shapes"));
        choose(user, "shapes", "pin");
    }
    Draughtsman again(setup);
    CHECK_FALSE(again.has("panel/parameters"));
    CHECK(top(again, "inspector") < top(again, "shapes"));
    again.workspace(WorkspaceKind::Judge);
    CHECK(again.has("panel/shapes"));
    CHECK_FALSE(again.has("panel/inspector"));
    choose(again, "shapes", "pin");
    CHECK_FALSE(again.has("panel/shapes"));
    again.workspace(WorkspaceKind::Draw);
    choose(again, "shapes", "reset");
    CHECK(again.has("panel/parameters"));
    CHECK(top(again, "inspector") > top(again, "shapes"));
}

TEST_CASE("Right click: fields are cut, copied and pasted, and a formula is replaced by its value") {
    RightClicker user;
    user.rectangle({1, 1}, {9, 8});
    user.context().document.apply(*setParameters(user.document(), {{"h", "0.4"}}), "Parameters");
    user.showPanel("spacing");
    user.settle();
    user.fill("spacing/size", "h/2");
    REQUIRE(user.document().formulas.at("spacing/size"_number) == "h/2");
    user.rightClick("spacing/size");
    CHECK(user.offers("field/cut"));
    user.choose("field/copy");
    CHECK(user.platform().clipboard() == "h/2");
    user.rightClick("spacing/size");
    user.choose("field/value");
    CHECK(user.document().spacing.size == doctest::Approx(0.2));
    CHECK_FALSE(user.document().formulas.contains("spacing/size"_number));
    user.rightClick("spacing/maximum");
    CHECK_FALSE(user.offers("field/cut")); // empty
    user.choose("field/paste");
    CHECK(user.document().spacing.maximum == doctest::Approx(0.2));
    CHECK(user.document().formulas.at("spacing/maximum"_number) == "h/2");
    user.rightClick("spacing/size");
    user.choose("field/cut");
    CHECK_FALSE(user.document().spacing.size.has_value());
    user.rightClick("spacing/size");
    user.choose("field/selectAll");
    CHECK(ImGui::GetIO().WantTextInput);
}

} // namespace forefront::test
