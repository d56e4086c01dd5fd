#include "tests/ui/driver.hpp"
#include "ui/style/icon_raster.hpp"
#include "ui/style/icons.hpp"

#include <doctest/doctest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

namespace forefront::test {

namespace {

using Cover = std::vector<std::uint8_t>;

/// Returns the mean difference of two pictures of icons relative to what both cover: 0 if they are equal, 1 if they
/// have nothing in common.
double unlike(const Cover &a, const Cover &b) {
    double apart = 0.0, all = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        apart += std::abs(static_cast<double>(a[k]) - static_cast<double>(b[k]));
        all += static_cast<double>(std::max(a[k], b[k]));
    }
    return apart / all;
}

double covered(const Cover &cover) {
    double sum = 0.0;
    for (const std::uint8_t value : cover) {
        sum += value / 255.0;
    }
    return sum;
}

} // namespace

TEST_CASE("Icons: no two look alike, none is empty, and each has one meaning") {
    constexpr int kSize = 20;
    std::vector<Cover> pictures;
    std::set<std::string> texts, meanings;
    for (const IconShape &shape : iconShapes()) {
        CAPTURE(std::string(shape.meaning));
        CHECK(texts.insert(shape.text).second);
        CHECK(meanings.insert(shape.meaning).second);
        pictures.push_back(drawIcon(shape, IconPart::Whole, kSize));
        CHECK(covered(pictures.back()) > 8.0);
        for (std::size_t k = 0; k + 1 < pictures.size(); ++k) {
            CAPTURE(std::string(iconShapes()[k].meaning));
            CHECK(unlike(pictures.back(), pictures[k]) > 0.12);
        }
    }
    CHECK(pictures.size() >= 44);
}

TEST_CASE("Icons: every tool has its own") {
    Driver driver;
    std::set<std::string> icons;
    for (const auto &tool : driver.context().tools.tools) {
        CAPTURE(tool->id());
        CHECK(icons.insert(tool->icon()).second);
    }
}

TEST_CASE("Icons: are as heavy at every size and stay within their square") {
    for (const IconShape &shape : iconShapes()) {
        CAPTURE(std::string(shape.meaning));
        const double share = covered(drawIcon(shape, IconPart::Whole, 80)) / (80.0 * 80.0);
        for (const int size : {16, 20, 25, 30, 40, 60}) {
            CAPTURE(size);
            const Cover cover = drawIcon(shape, IconPart::Whole, size);
            CHECK(covered(cover) / (size * size) == doctest::Approx(share).epsilon(0.12));
            const auto at = [&](int row, int column) {
                return cover[static_cast<std::size_t>(row) * static_cast<std::size_t>(size) +
                             static_cast<std::size_t>(column)];
            };
            for (int k = 0; k < size; ++k) {
                const int edge = std::max({at(0, k), at(size - 1, k), at(k, 0), at(k, size - 1)});
                CHECK(edge < 96); // the outermost pixels are the margin
            }
        }
    }
}

TEST_CASE("Icons: lines have round ends, arcs and curves meet their ends, and dashes have gaps") {
    const auto at = [](const Cover &cover, int size, double x, double y) {
        const auto pixel = [&](double place) { return static_cast<std::size_t>(place * size / 20.0); };
        return cover[pixel(y) * static_cast<std::size_t>(size) + pixel(x)];
    };
    constexpr int kSize = 200;
    const Cover line = drawIcon({.text = "", .meaning = "", .stroke = "M5 10H15"}, IconPart::Whole, kSize);
    CHECK(at(line, kSize, 4.5, 10.0) == 255);
    CHECK(at(line, kSize, 4.35, 9.35) == 0); // the corner of a square end
    CHECK(at(line, kSize, 10.0, 10.6) == 255);
    CHECK(at(line, kSize, 10.0, 10.9) == 0);
    const Cover ring = drawIcon({.text = "", .meaning = "", .stroke = "M17 10A7 7 0 1 1 3 10A7 7 0 1 1 17 10Z"},
                                IconPart::Whole, kSize);
    for (int k = 0; k < 40; ++k) {
        const double angle = 0.1 + k * 0.157;
        CHECK(at(ring, kSize, 10.0 + 7.0 * std::cos(angle), 10.0 + 7.0 * std::sin(angle)) == 255);
    }
    CHECK(at(ring, kSize, 10.0, 10.0) == 0);
    const Cover bow = drawIcon({.text = "", .meaning = "", .stroke = "M4 14A6 6 0 0 1 16 14"}, IconPart::Whole, kSize);
    CHECK(at(bow, kSize, 10.0, 8.0) == 255); // clockwise with y down: above its chord
    CHECK(at(bow, kSize, 10.0, 18.0) == 0);
    const Cover curve = drawIcon({.text = "", .meaning = "", .stroke = "M4 10C4 2 16 2 16 10"}, IconPart::Whole, kSize);
    CHECK(at(curve, kSize, 10.0, 4.0) == 255);
    const Cover dashes =
        drawIcon({.text = "", .meaning = "", .stroke = "", .dashed = "M2 10H18"}, IconPart::Whole, kSize);
    CHECK(at(dashes, kSize, 2.5, 10.0) == 255);
    CHECK(at(dashes, kSize, 4.9, 10.0) == 0);
    CHECK(at(dashes, kSize, 6.5, 10.0) == 255);
}

TEST_CASE("Icons: are characters of the fonts, at the same pixels as they were drawn, at every scale") {
    for (const double scale : {1.0, 1.5, 2.0}) {
        Driver driver({}, {1280, 800}, scale);
        const ImFontAtlas &atlas = *ImGui::GetIO().Fonts;
        const Fonts &fonts = driver.context().fonts;
        for (const auto &[font, design] : {std::pair{fonts.icons, 20.0}, {fonts.body, 16.0}, {fonts.small, 16.0}}) {
            const auto size = static_cast<int>(std::lround(design * scale));
            for (const IconShape &shape : iconShapes()) {
                CAPTURE(std::string(shape.meaning));
                const ImFontGlyph *const glyph = font->FindGlyphNoFallback(static_cast<ImWchar>(codeOf(shape.text)));
                REQUIRE(glyph != nullptr);
                CHECK(std::lround(glyph->X1 - glyph->X0) == size);
                CHECK(std::lround((glyph->U1 - glyph->U0) * static_cast<float>(atlas.TexWidth)) == size);
                const double middle = 0.5 * static_cast<double>(glyph->Y0 + glyph->Y1);
                CHECK(std::abs(middle - 0.5 * static_cast<double>(font->FontSize)) <= 1.0);
                const bool nodes = *shape.nodes != '\0';
                const auto code = static_cast<ImWchar>(codeOf(nodesOf(shape.text).c_str()));
                CHECK((font->FindGlyphNoFallback(code) != nullptr) == nodes);
            }
        }
    }
}

} // namespace forefront::test
