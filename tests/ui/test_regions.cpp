#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/ui/edit_driver.hpp"
#include "tests/ui/two_faces.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/gl/face_raster.hpp"
#include "ui/style/measure_colours.hpp"

#include <doctest/doctest.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

namespace forefront::test {

namespace {

constexpr Modifiers kCtrl{Modifiers::kControl};

/// Two faces: a rectangle, and one in it that is a constraint.
class TwoFaces : public Draughtsman {
  public:
    TwoFaces() {
        drawTwoFaces(*this);
        showLayer(context().layers, "size", false);
        showLayer(context().layers, "mesh", false);
        moveTo({4, 790});
        settle();
    }

    /// Returns the colour of the pixel at a place.
    std::array<int, 3> colourAt(Vec2 place) {
        const Picture shot = picture();
        const Pixel p = pixel(place);
        const auto first = 4 * (static_cast<std::size_t>(p.y) * static_cast<std::size_t>(shot.size.width) +
                                static_cast<std::size_t>(p.x));
        return {shot.rgba[first], shot.rgba[first + 1], shot.rgba[first + 2]};
    }
    /// Returns the rectangle of a label on the canvas.
    std::optional<PixelRect> labelOf(std::string_view text) {
        for (const CanvasPainter::Placed &label : editor().canvas().labels()) {
            if (label.text == text) {
                return label.rect;
            }
        }
        return std::nullopt;
    }
    std::uint32_t faceAtPixel(Pixel p) { return context().preview->faces->faceAt(context().view.camera.toPlane(p)); }
    static int difference(const std::array<int, 3> &a, const std::array<int, 3> &b) {
        return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
    }
};

Camera wholeView(double size, double zoom) {
    Camera camera;
    camera.centre = {5, 5};
    camera.zoom = zoom;
    camera.viewport = {0, 0, size, size};
    return camera;
}

} // namespace

TEST_CASE("Regions: a click makes a face a region with a free name, and a click in a region selects it") {
    TwoFaces driver;
    driver.key('G');
    driver.clickPlace({3, 4});
    REQUIRE(driver.document().regionMarkers.size() == 1);
    CHECK(driver.document().regionMarkers[0].tag == 2);
    CHECK(driver.undoLabel() == "Fill region_2");
    driver.clickPlace({7, 4});
    REQUIRE(driver.document().regionMarkers.size() == 2);
    CHECK(driver.document().regionMarkers[1].tag == 3);
    CHECK(driver.context().selection.markers == std::set<std::uint32_t>{1});
    const std::uint64_t revision = driver.context().document.revision();
    driver.clickPlace({4, 6});
    CHECK(driver.context().document.revision() == revision);
    CHECK(driver.context().selection.markers == std::set<std::uint32_t>{0});
    // A chosen tag replaces the region of a face.
    driver.fill("options/region/tag", "3");
    driver.clickPlace({3, 5});
    REQUIRE(driver.document().regionMarkers.size() == 2);
    CHECK(std::all_of(driver.document().regionMarkers.begin(), driver.document().regionMarkers.end(),
                      [](const MarkedRegion &marker) { return marker.tag == 3; }));
    driver.click("options/region/new");
    driver.clickPlace({7, 5});
    CHECK(driver.document().regionMarkers.size() == 2);
    CHECK(driver.context().selection.markers.size() == 1);
}

TEST_CASE("Regions: the face under the pointer is highlighted while the region tool is active") {
    TwoFaces driver;
    driver.key('G');
    const auto plain = driver.colourAt({4, 6});
    driver.moveToPlace({3, 4});
    driver.settle();
    CHECK(driver.context().view.facePlace.has_value());
    CHECK(TwoFaces::difference(driver.colourAt({4, 6}), plain) > 10); // far from the pointer
    CHECK(driver.labelOf("new region_2   area 12"));
    CHECK_FALSE(driver.labelOf("node")); // nothing is snapped to
    driver.moveToPlace({7, 4});
    driver.settle();
    CHECK(driver.colourAt({4, 6}) == plain);
    driver.key('V');
    CHECK_FALSE(driver.context().view.facePlace.has_value());
}

TEST_CASE("Regions: a layer tints the faces of regions; colours of values keep the middle of the faces") {
    TwoFaces driver;
    const auto before = driver.colourAt({4, 4}), outside = driver.colourAt({7, 4});
    driver.context().document.apply(*addRegionMarker(driver.document(), {{2.4, 3.4}, 2}), "Region");
    driver.settle();
    CHECK(TwoFaces::difference(driver.colourAt({4, 4}), before) > 10);
    CHECK(driver.colourAt({7, 4}) == outside);
    driver.unfoldLayers();
    driver.click("layer/regions");
    driver.moveTo({4, 790});
    driver.settle();
    CHECK(driver.colourAt({4, 4}) == before);
    showLayer(driver.context().layers, "size", true);
    driver.settle();
    const auto value = driver.colourAt({3.5, 5}), rim = driver.colourAt({4.9, 5});
    showLayer(driver.context().layers, "regions", true);
    driver.settle();
    CHECK(driver.colourAt({3.5, 5}) == value);
    CHECK(TwoFaces::difference(driver.colourAt({4.9, 5}), rim) > 10);
}

TEST_CASE("Regions: the inspector names a region, shows its area, and sets its size and growth") {
    TwoFaces driver;
    driver.context().document.apply(*addRegionMarker(driver.document(), {{2.4, 3.4}, 2}), "Region");
    driver.settle();
    driver.key('V');
    driver.clickPlace({2.4, 3.4});
    REQUIRE(driver.context().selection.markers == std::set<std::uint32_t>{0});
    driver.settle();
    CHECK(driver.has("inspector/swatch"));
    CHECK(driver.has("inspector/area"));
    const auto &faces = *driver.context().preview->faces;
    CHECK(faces.faces()[faces.faceOf(driver.document().regionMarkers[0])].area == doctest::Approx(12.0));
    driver.click("inspector/regiongrowth");
    CHECK_FALSE(ImGui::GetIO().WantTextInput); // without a size there is nothing to grow
    driver.fill("inspector/regionsize", "0.1");
    CHECK(driver.document().regionMarkers[0].size == 0.1);
    CHECK(driver.undoLabel() == "Change size of region");
    driver.fill("inspector/regiongrowth", "0.5");
    CHECK(driver.document().regionMarkers[0].growth == 0.5);
    driver.settle();
    CHECK(driver.context().preview->spacing->at({4, 6}) == doctest::Approx(0.1));
    CHECK(driver.context().preview->spacing->sample({4, 6}).describe == "size of region 'region_2'");
    driver.fill("inspector/regionsize", "-1");
    CHECK(driver.document().regionMarkers[0].size == 0.1);
    CHECK(driver.logHas("bad-source"));
    driver.click("inspector/regionsize");
    driver.key('A', kCtrl);
    driver.key(key::kDelete);
    driver.key(key::kEnter);
    CHECK(driver.document().regionMarkers[0].size == 0.0);
}

TEST_CASE("Regions: the size of a region takes an expression of parameters") {
    TwoFaces driver;
    Document document = *setParameters(driver.document(), {{"h", "0.4"}});
    document = *addRegionMarker(document, {{2.4, 3.4}, 2});
    driver.context().document.apply(document, "Region");
    driver.settle();
    driver.key('V');
    driver.clickPlace({2.4, 3.4});
    driver.fill("inspector/regionsize", "h/2");
    CHECK(driver.document().regionMarkers[0].size == doctest::Approx(0.2));
    CHECK(driver.document().formulas.at("region/0/size"_number) == "h/2");
}

TEST_CASE("Regions: with the select tool, a click on a label selects the region") {
    TwoFaces driver;
    driver.context().document.apply(*addRegionMarker(driver.document(), {{2.4, 3.4}, 2}), "Region");
    driver.settle();
    driver.key('V');
    driver.settle();
    const auto label = driver.labelOf("region_2");
    REQUIRE(label.has_value());
    CHECK(driver.faceAtPixel({label->x, label->y}) == driver.faceAtPixel({label->x + label->width, label->y}));
    driver.clickAt({label->x + label->width - 6.0, label->centre().y});
    driver.frames(30);
    CHECK(driver.context().selection.markers == std::set<std::uint32_t>{0});
    CHECK(driver.context().view.facePlace == Vec2{2.4, 3.4});
}

TEST_CASE("Face raster: faces get their tints, rims fade inwards, and curves are curves") {
    Document document;
    Shape disc;
    disc.form = CircleForm{};
    disc.nodes = {{5, 5}, {9, 5}};
    Shape hole = disc;
    hole.nodes = {{5, 5}, {6, 5}};
    document = *addShapes(document, {disc, hole});
    document.circleTolerance = 0.2; // coarse chords
    const auto map = faceMapOf(std::make_shared<const Domain>(toDomain(document)));
    REQUIRE(map->faces().size() == 1);
    const Camera camera = wholeView(400, 40.0);
    std::vector<FaceTint> tints(1);
    tints[0].colour = rgb(0xff0000);
    tints[0].fill = 0.5;
    const std::vector<Colour> filled = rasteriseFaces(*map, tints, camera, 10.0);
    double covered = 0.0;
    for (const Colour &pixel : filled) {
        covered += pixel.a / 127.5;
    }
    constexpr double kRing = 15.0 * 3.14159265 * 1600.0; // pixels
    CHECK(covered == doctest::Approx(kRing).epsilon(0.005));
    const auto at = [](const std::vector<Colour> &picture, int x, int y) {
        return picture[static_cast<std::size_t>(y) * 400 + static_cast<std::size_t>(x)];
    };
    CHECK(at(filled, 200, 200).a == 0);
    CHECK(at(filled, 300, 200) == Colour(glm::u8vec4(128, 0, 0, 128)));
    tints[0].fill = 0.0;
    tints[0].rim = 0.8;
    const std::vector<Colour> rims = rasteriseFaces(*map, tints, camera, 10.0);
    CHECK(at(rims, 300, 200).a == 0);
    CHECK(at(rims, 357, 200).a > 100);
    CHECK(at(rims, 352, 200).a < at(rims, 357, 200).a);
    // On the diagonal, the rim is as wide as along the axes.
    int straight = 0, diagonal = 0;
    for (int k = 0; k < 160; ++k) {
        straight += at(rims, 200 + k, 200).a;
        const int x = static_cast<int>(200.0 + k / std::sqrt(2.0));
        diagonal += at(rims, x, x).a;
    }
    CHECK(diagonal == doctest::Approx(straight).epsilon(0.15));
    CHECK(rasteriseFaces(FaceMap(), {}, camera, 10.0).size() == 160000);
}

TEST_CASE("Regions: a label that makes way for a node is clicked where it is, not where it was") {
    Draughtsman driver;
    driver.rectangle({1, 1}, {9, 9});
    driver.context().document.apply(*addRegionMarker(driver.document(), {{4, 5}, 2}), "Region");
    driver.key('V');
    driver.settle();
    const PixelRect before = driver.context().widgets.find("label/region/0")->rect;
    Shape node;
    node.form = PointForm{};
    node.use = ShapeUse::Constraint;
    node.nodes = {driver.context().view.camera.toPlane({before.x + 8.0, before.centre().y})};
    driver.context().document.apply(*addShape(driver.document(), node), "Point");
    const auto selectNode = [&] {
        driver.context().selection = {.shapes = {2}};
        driver.settle();
        return driver.context().widgets.find("label/region/0")->rect;
    };
    const Pixel free{before.x + before.width - 8.0, before.centre().y};
    REQUIRE_FALSE(selectNode().contains(free));
    driver.clickAt(free);
    driver.frames(30);
    CHECK(driver.context().selection.markers.empty());
    driver.clickAt(selectNode().centre());
    driver.frames(30);
    CHECK(driver.context().selection.markers == std::set<std::uint32_t>{0});
}

TEST_CASE("Regions: the menu of the region tool names a face, also one without a region") {
    TwoFaces driver;
    driver.key('G');
    const auto name = [&](std::string_view text) {
        driver.press(driver.pixel({3, 4}), MouseButton::Right);
        driver.release(driver.pixel({3, 4}), MouseButton::Right);
        driver.settle();
        REQUIRE(driver.has("contextmenu/nameFace"));
        driver.click("contextmenu/nameFace");
        driver.settle();
        REQUIRE(driver.has("naming/name"));
        driver.type(text);
        driver.key(key::kEnter);
        driver.settle();
    };
    name("oil");
    REQUIRE(driver.document().regionMarkers.size() == 1);
    CHECK(driver.document().regionNames.at(driver.document().regionMarkers[0].tag) == "oil");
    name("water");
    REQUIRE(driver.document().regionMarkers.size() == 1);
    CHECK(driver.document().regionNames.at(driver.document().regionMarkers[0].tag) == "water");
    driver.press(driver.pixel({9.6, 9}), MouseButton::Right);
    driver.release(driver.pixel({9.6, 9}), MouseButton::Right);
    driver.settle();
    CHECK_FALSE(driver.has("contextmenu/nameFace"));
}

} // namespace forefront::test
