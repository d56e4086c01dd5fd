#include "core/drawing_files/project/project.hpp"
#include "core/drawing_files/world_file/world_file.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace forefront;

namespace {

std::string faultOfWorldFile(const std::string &text) {
    const Result<PicturePlace> place = parseWorldFile(text, 400, 300, "/maps/lake.pgw");
    return place ? std::string() : place.faults().front().message + "; " + place.faults().front().advice;
}

} // namespace

TEST_CASE("World file: the place of a picture, from the middle of its upper left pixel") {
    const Result<PicturePlace> place = parseWorldFile("0.5\n0\n0\n-0.5\n1000.25\n2000.75\n", 400, 300, "lake.pgw");
    REQUIRE(place.ok());
    CHECK(place->size == Vec2{200.0, 150.0});
    CHECK(place->corner == Vec2{1000.0, 1851.0});
    CHECK(place->angle == 0.0);
}

TEST_CASE("World file: a turned picture has its corners where the file says") {
    const double c = 2.0 * std::cos(0.3), s = 2.0 * std::sin(0.3);
    const std::string text = std::to_string(c) + "\r\n" + std::to_string(s) + "\r\n" + std::to_string(s) + "\r\n" +
                             std::to_string(-c) + "\r\n100,5\r\n-7";
    const Result<PicturePlace> place = parseWorldFile(text, 40, 30, "lake.jgw");
    REQUIRE(place.ok());
    BackgroundPicture picture;
    picture.corner = place->corner;
    picture.size = place->size;
    picture.angle = place->angle;
    CHECK(place->angle == doctest::Approx(0.3 * 180.0 / 3.14159265358979).epsilon(1e-5));
    const Vec2 first = placeIn(picture, {0.5 / 40.0, 29.5 / 30.0}); // the middle of the upper left pixel
    CHECK(distance(first, {100.5, -7.0}) < 1e-4);
    const Vec2 last = placeIn(picture, {39.5 / 40.0, 0.5 / 30.0});
    CHECK(distance(last, Vec2{100.5, -7.0} + 39.0 * Vec2{c, s} + 29.0 * Vec2{s, -c}) < 1e-3);
}

TEST_CASE("World file: what does not fit a picture is refused with the reason") {
    CHECK(faultOfWorldFile("1 0 0 -1 5").find("expected 6 numbers, got 5") != std::string::npos);
    CHECK(faultOfWorldFile("1 0 zero -1 5 6").find("line 3: expected a number, got 'zero'") != std::string::npos);
    CHECK(faultOfWorldFile("1 0 0.4 -1 5 6").find("shears") != std::string::npos);
    CHECK(faultOfWorldFile("1 0 0 1 5 6").find("mirrors") != std::string::npos);
    CHECK(faultOfWorldFile("0 0 0 -1 5 6").find("no width") != std::string::npos);
    CHECK(faultOfWorldFile("1 0 0 -1 nan 6").find("line 5") != std::string::npos);
}

TEST_CASE("World file: the names beside a picture") {
    const auto names = worldFileNames("/maps/lake.jpeg");
    CHECK(names[0] == "/maps/lake.jgw");
    CHECK(std::find(names.begin(), names.end(), "/maps/lake.jpegw") != names.end());
    CHECK(std::find(names.begin(), names.end(), "/maps/lake.wld") != names.end());
    CHECK(worldFileNames("lake.png")[0] == "lake.pgw");
    CHECK(worldFileNames("lake.tif")[0] == "lake.tfw");
}

TEST_CASE("Background picture: placed by two points, it is turned and scaled, and its points are there") {
    BackgroundPicture picture;
    picture.corner = {3.0, -2.0};
    picture.size = {40.0, 30.0};
    picture.angle = 10.0;
    const Vec2 a{0.1, 0.2}, b{0.8, 0.9};
    const BackgroundPicture placed = placedBy(picture, a, b, {1000.0, 2000.0}, {1100.0, 1950.0});
    CHECK(distance(placeIn(placed, a), {1000.0, 2000.0}) < 1e-9);
    CHECK(distance(placeIn(placed, b), {1100.0, 1950.0}) < 1e-9);
    CHECK(placed.size.x / placed.size.y == doctest::Approx(4.0 / 3.0));
    CHECK(distance(shareOf(placed, placeIn(placed, b)), b) < 1e-12);
    CHECK(covers(placed, placeIn(placed, {0.99, 0.01})));
    CHECK_FALSE(covers(placed, placeIn(placed, {1.01, 0.5})));
    CHECK(boundsOf(placed).contains(placeIn(placed, {1.0, 0.0})));

    Document document;
    document.picture = placed;
    document.picture->file = "/maps/lake.png";
    const Result<Document> back = parseProject(projectText(document), "lake.json");
    REQUIRE(back.ok());
    CHECK(back->picture == document.picture);
}
