#include "tests/ui/edit_driver.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/workspace/coordinate_text.hpp"
#include "ui/workspace/typed_length.hpp"

#include <doctest/doctest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace forefront::test {

namespace {

/// Returns the highest place that shows what the window with that name drew in the last frame, in pixels.
float topOf(const std::string &window) {
    float top = 1e9F;
    const ImDrawData &drawn = *ImGui::GetDrawData();
    for (int k = 0; k < drawn.CmdListsCount; ++k) {
        const ImDrawList &list = *drawn.CmdLists[k];
        if (list._OwnerName == nullptr || window != list._OwnerName) {
            continue;
        }
        for (const ImDrawCmd &command : list.CmdBuffer) {
            for (unsigned n = 0; n < command.ElemCount; ++n) {
                const int at = list.IdxBuffer[static_cast<int>(command.IdxOffset + n)];
                const float y = list.VtxBuffer[static_cast<int>(command.VtxOffset) + at].pos.y;
                top = std::min(top, std::max(y, command.ClipRect.y));
            }
        }
    }
    return top;
}

} // namespace

TEST_CASE("Coordinates: as many decimals as tell a hundredth of a pixel in a view of the drawing, wherever it lies") {
    CHECK(coordinateText(687123.25, 1200.0) == "687123.25");
    CHECK(coordinateText(5312345.5, 1200.0) == "5312345.5");
    CHECK(coordinateText(687123.251234, 1200.0) == "687123.25");
    CHECK(coordinateText(687123.251234, 0.5) == "687123.251234");
    CHECK(coordinateText(0.72000000001, 120.0) == "0.72");
    CHECK(coordinateText(-12.345678, 120.0) == "-12.3457"); // six digits are not fewer
    CHECK(coordinateText(3.0, 0.0) == "3");
    CHECK(coordinateDecimals(0.0) == 0);
    for (double diagonal = 1e-3; diagonal < 1e7; diagonal *= 1.7) {
        CAPTURE(diagonal);
        const double step = diagonal / 1e5; // a hundredth of one of 1000 pixels
        CHECK(std::pow(10.0, -coordinateDecimals(diagonal)) <= std::max(1.0, step * (1.0 + 1e-9)));
        for (const double place : {0.3, 4.0e5, -5.3e6}) {
            CHECK(std::abs(std::stod(coordinateText(place + step / 3.0, diagonal)) - (place + step / 3.0)) <=
                  0.5001 * std::max(1.0, step));
        }
    }
}

TEST_CASE("Coordinates: the drawing is measured again when it changes") {
    Draughtsman driver;
    CHECK(driver.context().extent.diagonal(driver.context().document) == 0.0);
    driver.rectangle({1, 1}, {4, 5});
    CHECK(driver.context().extent.diagonal(driver.context().document) == doctest::Approx(5.0));
    driver.key('Z', {Modifiers::kControl});
    CHECK(driver.context().extent.diagonal(driver.context().document) == 0.0);
}

TEST_CASE("Rulers: no label reaches into the corner with the unit") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {4, 5});
    driver.key('R', {Modifiers::kControl});
    driver.settle();
    const WidgetRegistry::Widget *const ruler = driver.context().widgets.find("canvas/ruler/y");
    REQUIRE(ruler != nullptr);
    const auto top = static_cast<float>(ruler->rect.y);
    for (int k = 0; k < 40; ++k) {
        driver.context().view.camera.centre.y += 0.037;
        driver.context().animate();
        driver.frames(1);
        CAPTURE(k);
        CHECK(topOf("##rulerY") >= top - 1.0F);
        CHECK(topOf("##rulerY") < top + 40.0F); // it is drawn
    }
}

TEST_CASE("Menu bar: the button Export is there in small windows, too, beside the switch of workspaces") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {4, 5});
    for (const PixelSize size : {PixelSize{1024, 700}, PixelSize{900, 700}, PixelSize{1280, 800}}) {
        driver.platform().resize(size, 1.0);
        driver.settle();
        CAPTURE(size.width);
        const WidgetRegistry::Widget *const button = driver.context().widgets.find("menu/export");
        const WidgetRegistry::Widget *const choice = driver.context().widgets.find("workspace");
        REQUIRE(button != nullptr);
        REQUIRE(choice != nullptr);
        CHECK(choice->rect.x + choice->rect.width <= button->rect.x);
        CHECK(button->rect.x + button->rect.width <= size.width);
        CHECK(choice->rect.width >= 80.0);
    }
}

TEST_CASE("Status line: a finished mesh is told in words, and in symbols where the front is watched") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {4, 5});
    driver.key(key::kF5);
    driver.settle();
    driver.workspace(WorkspaceKind::Mesh);
    driver.settle();
    CHECK(shell::stateText(driver.context()) == "The domain is meshed and the mesh improved.");
    driver.workspace(WorkspaceKind::Step);
    driver.settle();
    CHECK(shell::stateText(driver.context()) == "\xce\x93 = \xe2\x88\x85: the domain is meshed and the mesh improved.");
}

TEST_CASE("Units: an area has the square of the unit") {
    CHECK(areaSuffix(LengthUnit::Metre) == " m\xc2\xb2");
    CHECK(areaSuffix(LengthUnit::None).empty());
}

} // namespace forefront::test
