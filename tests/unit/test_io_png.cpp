#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "core/files/common/cell_grid.hpp"
#include "core/files/files.hpp"
#include "core/files/png/png.hpp"
#include "core/files/png/png_pixels.hpp"
#include "core/files/text/base64.hpp"
#include "tests/support/png_sample.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/edit_support.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<double> greysOf(const std::string &file) {
    const auto picture = readGreyPicture(sourceOf(file), kMaxGridValues);
    REQUIRE_MESSAGE(picture.ok(), messages(picture.faults()));
    CHECK(picture->values.size() == picture->columns * picture->rows);
    return picture->values;
}

std::string pngFault(const std::string &file) {
    const auto picture = readGreyPicture(sourceOf(file), kMaxGridValues);
    REQUIRE_FALSE(picture.ok());
    CHECK(allLocated(picture.faults()));
    return picture.faults().front().code + ": " + picture.faults().front().message;
}

SourceText pictureSource(const std::string &file, const PictureSizes &sizes) {
    SourceText source = sourceOf(file);
    source.options.picture = sizes;
    return source;
}

void checkNear(const std::vector<double> &values, const std::vector<double> &expected) {
    REQUIRE(values.size() == expected.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
        CHECK(values[k] == doctest::Approx(expected[k]));
    }
}

} // namespace

TEST_CASE("PNG: grey values of every depth, with and without alpha, with a transparent value") {
    checkNear(greysOf(greyPng(3, 1, {0, 51, 255})), {0, 0.2, 1});
    checkNear(greysOf(pngFile({.columns = 10, .depth = 1, .bytes = {0, 0xA0, 0x40}})), {1, 0, 1, 0, 0, 0, 0, 0, 0, 1});
    checkNear(greysOf(pngFile({.columns = 5, .depth = 2, .bytes = {0, 0x1B, 0x80}})),
              {0, 1.0 / 3, 2.0 / 3, 1, 2.0 / 3});
    checkNear(greysOf(pngFile({.columns = 3, .depth = 4, .bytes = {0, 0x3F, 0x60}})), {0.2, 1, 0.4});
    checkNear(greysOf(pngFile({.columns = 2, .depth = 16, .bytes = {0, 0x80, 0, 0, 1}})),
              {32768.0 / 65535, 1.0 / 65535});
    checkNear(greysOf(pngFile({.columns = 3, .colour = 4, .bytes = {0, 51, 255, 51, 1, 51, 0}})), {0.2, 0.2, kNoGrey});
    checkNear(greysOf(pngFile({.columns = 2, .bytes = {0, 51, 102}, .transparency = std::string("\0f", 2)})),
              {0.2, kNoGrey});
}

TEST_CASE("PNG: colours become their luminance, those of a palette too") {
    const std::vector<double> channels{0.2126, 0.7152, 0.0722};
    checkNear(greysOf(pngFile({.columns = 3, .colour = 2, .bytes = {0, 255, 0, 0, 0, 255, 0, 0, 0, 255}})), channels);
    checkNear(greysOf(pngFile({.columns = 2, .colour = 6, .bytes = {0, 51, 51, 51, 9, 7, 7, 7, 0}})), {0.2, kNoGrey});
    PngSample indexed{.columns = 4, .depth = 2, .colour = 3, .bytes = {0, 0x1B}};
    indexed.palette = std::string("\xff\0\0\0\xff\0\0\0\xff\x33\x33\x33", 12);
    checkNear(greysOf(pngFile(indexed)), {0.2126, 0.7152, 0.0722, 0.2});
    indexed.transparency = std::string("\xff\0", 2);
    checkNear(greysOf(pngFile(indexed)), {0.2126, kNoGrey, 0.0722, 0.2});
}

TEST_CASE("PNG: the colours and opacities of every kind, also interlaced, and faults") {
    const auto coloursIn = [](const std::string &file) {
        PngDecoder decoder(file);
        REQUIRE(decoder.open());
        return coloursOf(decoder).value_or(Bytes{});
    };
    CHECK(coloursIn(greyPng(2, 1, {0, 51})) == Bytes{0, 0, 0, 255, 51, 51, 51, 255});
    CHECK(coloursIn(pngFile({.columns = 1, .depth = 16, .bytes = {0, 0x80, 7}})) == Bytes{0x80, 0x80, 0x80, 255});
    CHECK(coloursIn(pngFile({.columns = 2, .colour = 4, .bytes = {0, 51, 255, 9, 1}})) ==
          Bytes{51, 51, 51, 255, 9, 9, 9, 1});
    CHECK(coloursIn(pngFile({.columns = 2, .colour = 2, .bytes = {0, 1, 2, 3, 4, 5, 6}})) ==
          Bytes{1, 2, 3, 255, 4, 5, 6, 255});
    CHECK(coloursIn(pngFile({.columns = 1, .colour = 6, .bytes = {0, 1, 2, 3, 4}})) == Bytes{1, 2, 3, 4});
    PngSample indexed{.columns = 2, .depth = 2, .colour = 3, .bytes = {0, 0x10}};
    indexed.palette = std::string("\xff\1\2\3\xfe\4", 6);
    indexed.transparency = std::string("\x80", 1);
    CHECK(coloursIn(pngFile(indexed)) == Bytes{255, 1, 2, 128, 3, 254, 4, 255});
    const Bytes passes{0, 0, 0, 20, 0, 2, 22, 0, 10, 0, 12, 0, 1, 11, 21}; // see below
    const Bytes interlaced = coloursIn(pngFile({.columns = 3, .rows = 3, .interlaced = true, .bytes = passes}));
    REQUIRE(interlaced.size() == 36);
    for (std::size_t k = 0; k < 9; ++k) {
        CHECK(interlaced[4 * k] == 10 * (k % 3) + k / 3);
        CHECK(interlaced[4 * k + 3] == 255);
    }
    const std::string cut = greyPng(2, 1, {0, 51});
    PngDecoder decoder(std::string_view(cut).substr(0, cut.size() - 20));
    REQUIRE(decoder.open());
    CHECK_FALSE(coloursOf(decoder).has_value());
    CHECK(std::string(decoder.fault()) != "");
}

TEST_CASE("PNG: filters, interlacing and compression with its own codes are undone") {
    const Bytes filtered{0, 10, 20, 30, 1, 5, 5, 5, 2, 5, 250, 5, 3, 10, 10, 10, 4, 1, 2, 3};
    const std::vector<int> plain{10, 20, 30, 5, 10, 15, 10, 4, 20, 15, 19, 29, 16, 21, 32};
    std::vector<double> expected;
    std::transform(plain.begin(), plain.end(), std::back_inserter(expected), [](int v) { return v / 255.0; });
    checkNear(greysOf(pngFile({.columns = 3, .rows = 5, .bytes = filtered})), expected);

    // Passes over 3 x 3 pixels, with the columns times 10 plus the rows as values.
    const Bytes passes{0, 0, 0, 20, 0, 2, 22, 0, 10, 0, 12, 0, 1, 11, 21};
    checkNear(greysOf(pngFile({.columns = 3, .rows = 3, .interlaced = true, .bytes = passes})),
              {0, 10 / 255.0, 20 / 255.0, 1 / 255.0, 11 / 255.0, 21 / 255.0, 2 / 255.0, 12 / 255.0, 22 / 255.0});

    const auto stream =
        fromBase64("eNp1iVsKwEAIxHzd/8zdrB+ljh0wBuL2M3/5RZ8rWnwBERNc2XZDLDB+LDAkFITAJtxiX4dUEBKbOOFIKgiJTbjlvg6l"
                   "IBQ2ccKRUhAKm3gAOAgDdw==");
    REQUIRE(stream.has_value());
    const std::vector<double> product = greysOf(pngFile({.columns = 24, .rows = 20}, *stream));
    for (std::size_t k = 0; k < product.size(); ++k) {
        CHECK(product[k] == doctest::Approx(static_cast<double>(k % 24 * (k / 24) / 5) / 255.0));
    }
}

TEST_CASE("PNG: large pictures become means of their pixels") {
    CHECK(averagedCounts(500, 500, 250'000).columns == 500);
    CHECK(averagedCounts(501, 500, 250'000).columns == 251);
    CHECK(averagedCounts(4000, 4000, 1'000'000).rows == 1000);
    CHECK(averagedCounts(100'000'000, 1, 250'000).columns == 250'000);
    const std::string file = greyPng(4, 4, {0, 255, 10, 10, 255, 0, 10, 10, 1, 2, 20, 21, 3, 4, 22, 23});
    const auto picture = readGreyPicture(sourceOf(file), 4);
    REQUIRE(picture.ok());
    checkNear(picture->values, {0.5, 10 / 255.0, 2.5 / 255.0, 21.5 / 255.0});

    // Where more than half of the pixels are transparent, there is no value; otherwise the others count.
    PngSample holes{.columns = 4, .rows = 2, .colour = 4};
    holes.bytes = {0, 51, 255, 9, 0, 51, 255, 9, 0, 0, 51, 255, 9, 0, 9, 0, 9, 0};
    const auto sparse = readGreyPicture(sourceOf(pngFile(holes)), 2);
    REQUIRE(sparse.ok());
    checkNear(sparse->values, {0.2, kNoGrey});

    ImportNotes notes;
    const std::string large = greyPng(600, 500, Bytes(300'000, 128));
    SourceText source = pictureSource(large, {1.0, 2.0, {{0, 0}, {6, 5}}});
    source.notes = &notes;
    const auto spacing = readPngSpacing(source);
    REQUIRE_MESSAGE(spacing.ok(), messages(spacing.faults()));
    CHECK(spacing->background->nodes.size() == 302 * 252);
    REQUIRE(notes.diagnostics().size() == 1);
    CHECK(notes.diagnostics()[0].message == "the picture has 600 x 500 pixels; averaged to 300 x 250");
}

TEST_CASE("PNG: sizes lie between those of black and white, at the centres of the pixels") {
    const std::string file = greyPng(3, 2, {0, 255, 51, 255, 0, 102});
    const auto spacing = readPngSpacing(pictureSource(file, {0.5, 3.0, {{10, 20}, {16, 24}}}));
    REQUIRE_MESSAGE(spacing.ok(), messages(spacing.faults()));
    const Document document = edit_test::documentOf({edit_test::makeShape(ShapeKind::Rectangle, {{10, 20}, {16, 24}})});
    SpacingSpec steep = *spacing;
    steep.gradation = 10.0; // these sizes change too fast for the default
    const auto field = SpacingField::build(steep, toDomain(document));
    REQUIRE_MESSAGE(field.ok(), messages(field.faults()));
    CHECK((*field)->at({11, 23}) == doctest::Approx(0.5)); // the first row is the highest
    CHECK((*field)->at({13, 23}) == doctest::Approx(3.0));
    CHECK((*field)->at({15, 23}) == doctest::Approx(1.0));
    CHECK((*field)->at({15, 21}) == doctest::Approx(1.5));
    CHECK((*field)->at({12, 23}) == doctest::Approx(1.75));

    // White may be finer than black.
    const auto reversed = readPngSpacing(pictureSource(file, {3.0, 0.5, {{10, 20}, {16, 24}}}));
    REQUIRE(reversed.ok());
    CHECK(*std::min_element(reversed->background->values.begin(), reversed->background->values.end()) == 0.5);
}

TEST_CASE("PNG: around a box a picture keeps its proportions and covers it") {
    CHECK(pictureBoxAround({{0, 0}, {4, 2}}, 100, 100) == Box2{{0, -1}, {4, 3}});
    CHECK(pictureBoxAround({{0, 0}, {4, 2}}, 400, 100) == Box2{{-2, 0}, {6, 2}});
    CHECK(pictureBoxAround({}, 200, 100) == Box2{{0, 0}, {2, 1}});
    CHECK(pictureBoxAround({{3, 5}, {3, 5}}, 1, 1) == Box2{{2.5, 4.5}, {3.5, 5.5}});
    const auto spacing = readPngSpacing(pictureSource(
        greyPng(2, 2, {0, 0, 0, 0}), {.black = 1.0, .white = 2.0, .box = {{0, 0}, {4, 2}}, .around = true}));
    REQUIRE(spacing.ok());
    Box2 covered;
    for (const Vec2 node : spacing->background->nodes) {
        covered.add(node);
    }
    CHECK(covered == Box2{{0, -1}, {4, 3}});
}

TEST_CASE("PNG: faults of the file say what is wrong") {
    const std::string good = greyPng(4, 3, Bytes(12, 7));
    CHECK(pngFault("GIF89a") == "bad-picture: the file is not a PNG picture");
    for (std::size_t size = 8; size < good.size(); ++size) {
        CHECK(pngFault(good.substr(0, size)).starts_with("bad-picture: cannot decode the picture: "));
    }
    CHECK(pngFault(good.substr(0, 60)) == "bad-picture: cannot decode the picture: the file ends early");
    std::string flipped = good;
    flipped[flipped.find("IDAT") + 8] ^= 1;
    CHECK(pngFault(flipped).starts_with("bad-picture: cannot decode the picture: IDAT"));
    std::string unknown = good;
    unknown.insert(33, pngChunk("ABcD", ""));
    CHECK(pngFault(unknown).find("ABcD") != std::string::npos);
    const auto refused = [](const PngSample &sample, const char *part) {
        CHECK(pngFault(pngFile(sample)).find(part) != std::string::npos);
    };
    refused({.columns = 4, .bytes = {0, 1, 2, 3}}, "Not enough");
    refused({.columns = 9000, .rows = 9000, .bytes = {0}}, "Not enough");
    refused({.columns = 20'000, .rows = 20'000},
            "large-picture: the picture has 20000 x 20000 pixels; expected at most");
    refused({.columns = 2'000'000'000}, "bad-picture: cannot decode");
    refused({.depth = 16, .colour = 3}, "Invalid");
    refused({.columns = 0}, "Invalid");
    refused({.bytes = {5, 1}}, "filter");
    refused({.colour = 3, .bytes = {0, 1}}, "PLTE");
    refused({.colour = 3, .bytes = {0, 1}, .palette = "abc"}, "a colour that the palette lacks");
    for (const char *stream :
         {"", "\x78\x01\x07", "\x78\x01\x03\x02", "\x78\x01\x05\xff\xff\xff\xff\xff\xff", "\x78\x01\x63"}) {
        CHECK(pngFault(pngFile(PngSample{.bytes = {0, 1}}, stream)).starts_with("bad-picture: cannot decode"));
    }
}

TEST_CASE("PNG: as spacing it needs two sizes and a rectangle, and a document keeps the result") {
    const std::string file = greyPng(2, 2, {0, 255, 255, 0});
    const auto faultOf = [&](const SourceText &source) {
        const auto spacing = readPngSpacing(source);
        REQUIRE_FALSE(spacing.ok());
        return spacing.faults().front().code;
    };
    CHECK(faultOf(sourceOf(file)) == "missing-sizes");
    CHECK(faultOf(pictureSource(file, {0.0, 1.0, {{0, 0}, {1, 1}}})) == "bad-size");
    CHECK(faultOf(pictureSource(file, {1.0, -1.0, {{0, 0}, {1, 1}}})) == "bad-size");
    CHECK(faultOf(pictureSource(file, {1.0, 1.0, {{0, 0}, {1, 0}}})) == "bad-box");
    CHECK(faultOf(pictureSource(file, {1.0, 1.0, {}})) == "bad-box");
    const std::string clear = pngFile({.columns = 2, .colour = 4, .bytes = {0, 1, 0, 1, 0}});
    CHECK(faultOf(pictureSource(clear, {1.0, 1.0, {{0, 0}, {1, 1}}})) == "no-values");

    const TemporaryFolder folder;
    std::ofstream(folder / "sizes.png", std::ios::binary) << file;
    const auto spacing =
        allFormats().readSpacing(folder / "sizes.png", {.picture = PictureSizes{0.5, 1.0, {{0, 0}, {4, 4}}}});
    REQUIRE_MESSAGE(spacing.ok(), messages(spacing.faults()));
    Document document;
    document.spacing = *spacing;
    const Result<Document> read = parseProject(projectText(document), "test");
    REQUIRE(read.ok());
    CHECK(*read->spacing.background == *document.spacing.background);
    CHECK(allFormats().readDomain(folder / "sizes.png").faults().front().message == "PNG picture cannot be read here");
}
