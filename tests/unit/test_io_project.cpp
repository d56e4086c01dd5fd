#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/drawing_files/project/tile_code.hpp"
#include "core/engine/spacing/part_list.hpp"
#include "core/files/common/names.hpp"
#include "core/files/files.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <fstream>
#include <random>
#include <sstream>

using namespace forefront;
using namespace forefront::testing;

namespace {

Diagnostics projectFaults(const std::string &text) {
    const auto document = parseProject(text, "test.json");
    return document ? Diagnostics{} : document.faults();
}

const std::string kHead = "{\"format\": \"forefront\", \"version\": 1,\n \"shapes\": [";

} // namespace

TEST_CASE("Project: round trip of a document that uses every field") {
    const Document document = fullDocument();
    const std::string text = projectText(document);
    const auto back = parseProject(text, "full.json");
    REQUIRE_MESSAGE(back.ok(), messages(back.faults()));
    CHECK(sameContent(document, *back));
    CHECK(back->nextId == 12);
    CHECK(back->circleTolerance == 0.01);
    CHECK(projectText(*back) == text);
}

TEST_CASE("Project: every kind of spacing part is written, and read back") {
    const Document full = fullDocument();
    const std::string text = projectText(full);
    const auto back = parseProject(text, "full.json");
    REQUIRE(back.ok());
    const SpacingSpec given = spacingOf(full), read = spacingOf(*back);
    CHECK(given.placed == read.placed);
    CHECK_FALSE(given.placed.elements.empty());
    for (const SpacingPartKind &kind : spacingPartKinds()) {
        if (kind.name != "function") { // which no file can hold
            CAPTURE(kind.name);
            REQUIRE(kind.given(given)); // add a new kind to fullDocument()
            CHECK(kind.same(given, read));
            CHECK_FALSE(kind.same(given, SpacingSpec{}));
        }
    }
}

TEST_CASE("Project: limits are written only if there are some") {
    Document document;
    CHECK(projectText(document).find("limits") == std::string::npos);
    document.limits[MeshLimit::MinAngle] = 25.0;
    const std::string text = projectText(document);
    CHECK(text.find("\"limits\": {\"minAngle\": 25}") != std::string::npos);
    CHECK(parseProject(text, "limits.json")->limits == document.limits);
    CHECK_FALSE(sameContent(document, Document{}));
}

TEST_CASE("Project: round trip of an empty document") {
    const auto back = parseProject(projectText(Document{}), "empty.json");
    REQUIRE(back.ok());
    CHECK(sameContent(Document{}, *back));
}

TEST_CASE("Project: the level of improvement is a word; the flag of older projects is understood") {
    const auto levelOf = [](const char *value) {
        const auto document = parseProject(kHead + "],\n\"options\": {\"improve\": " + value + "}}", "test.json");
        REQUIRE_MESSAGE(document.ok(), messages(document.faults()));
        return document->options.improve;
    };
    CHECK(levelOf("true") == ImproveLevel::Default);
    CHECK(levelOf("false") == ImproveLevel::None);
    CHECK(levelOf("\"none\"") == ImproveLevel::None);
    CHECK(levelOf("\"default\"") == ImproveLevel::Default);
    CHECK(levelOf("\"best\"") == ImproveLevel::Best);
}

TEST_CASE("Project: a newer version is refused with the advice to update") {
    const Diagnostics faults =
        projectFaults("{\"format\": \"forefront\",\n  \"version\": 3, \"shapes\": \"who knows\"}");
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].code == "newer-version");
    CHECK(faults[0].line == 2);
    CHECK(faults[0].column == 14);
    CHECK(faults[0].advice == "update Forefront");
}

TEST_CASE("Project: unknown members are ignored and reported") {
    const std::string text = kHead + "], \"colour\": {\"a\": [1, null, true]}}";
    ImportNotes notes;
    SourceText source = sourceOf(text, "new.forefront");
    source.notes = &notes;
    REQUIRE(readProjectText(source).ok());
    REQUIRE(notes.entries().size() == 1);
    CHECK(notes.entries()[0].message == "unknown member 'colour' is ignored");
    CHECK(notes.entries()[0].line == 2);
}

TEST_CASE("Project: unknown members of shapes, markers, options and limits are reported, too") {
    const std::string text = kHead + R"(
{"id": 1, "kind": "polygon", "nodes": [[0, 0], [1, 0], [0, 1]], "curvs": []}],
"regionMarkers": [{"at": [0.1, 0.1], "tag": 2, "maxarea": 3}],
"options": {"methd": "fast"},
"limits": {"minAngel": 20}})";
    ImportNotes notes;
    SourceText source = sourceOf(text, "new.forefront");
    source.notes = &notes;
    REQUIRE(readProjectText(source).ok());
    std::string all;
    for (const auto &note : notes.entries()) {
        all += note.message + '\n';
    }
    for (const char *const word : {"'curvs'", "'maxarea'", "'methd'", "'minAngel'"}) {
        CHECK_MESSAGE(all.find(word) != std::string::npos, word);
    }
}

TEST_CASE("Project: unknown members of the spacing, its sources and the sizes of nodes are reported at their places") {
    const std::string text = kHead + R"(
{"id": 1, "kind": "polygon", "nodes": [[0, 0], [1, 0], [0, 1]],
 "nodeSizes": [{"node": 0, "size": 0.1, "grwth": 0.3}]}],
"spacing": {"sise": 1,
 "sources": [{"shape": "line", "a": [0, 0], "b": [1, 0], "size": 0.1, "endsize": 0.2}],
 "partSizes": [{"tag": 1, "size": 0.1, "grow": 1}],
 "paint": {"origin": [0, 0], "pitch": 1, "tiles": [], "brush": 1}}})";
    ImportNotes notes;
    SourceText source = sourceOf(text, "new.forefront");
    source.notes = &notes;
    REQUIRE(readProjectText(source).ok());
    std::string all;
    for (const auto &note : notes.entries()) {
        all += std::to_string(note.line) + ':' + std::to_string(note.column) + ' ' + note.message + '\n';
    }
    CHECK(all == "4:41 unknown member 'grwth' is ignored\n"
                 "6:71 unknown member 'endsize' is ignored\n"
                 "7:40 unknown member 'grow' is ignored\n"
                 "8:55 unknown member 'brush' is ignored\n"
                 "5:13 unknown member 'sise' is ignored\n");
}

TEST_CASE("Project: shapes with numbers near the limit are renumbered, so that new shapes can be saved and read") {
    const std::string shape = R"("kind": "point", "use": "constraint", "nodes": [[0, 0]]})";
    const auto document = parseProject(kHead + R"({"id": 4294967294, )" + shape + "]}", "a.forefront");
    REQUIRE(document.ok());
    CHECK(document->shapes[0]->id == 1);
    CHECK(document->nextId == 2);
    const auto last = parseProject(kHead + R"({"id": 7, )" + shape + R"(], "nextId": 4294967295})", "a.forefront");
    REQUIRE(last.ok());
    CHECK(last->nextId == 2);
}

TEST_CASE("Project: several wrong fields are all reported, each at its line and column") {
    const Diagnostics faults =
        projectFaults(kHead + "\n{\"id\": 1, \"kind\": \"hexagon\", \"nodes\": [[0, 0]]},\n"
                              "{\"id\": 1, \"kind\": \"point\", \"tag\": 0, \"nodes\": [[0, 1e999]]}]\n}");
    REQUIRE(faults.size() == 4);
    CHECK(faults[0].line == 3);
    CHECK(faults[0].column == 19);
    CHECK(faults[0].code == "bad-field");
    CHECK(hasCode(faults, "duplicate-id"));
    CHECK(faults[3].line == 4);
    CHECK(faults[3].code == "bad-number");
    CHECK(allLocated(faults));
}

TEST_CASE("Project: wrong values of every kind are refused") {
    for (const char *field :
         {R"("spacing": {"size": 0})",
          R"("spacing": {"size": -1})",
          R"("spacing": {"size": "0.1"})",
          R"("spacing": {"gradation": 0})",
          R"("spacing": {"sources": [{"shape": "point", "a": [0, 0]}]})",
          R"("spacing": {"sources": [{"shape": "line", "a": [0, 0], "b": [1, 0], "size": 1, "endSize": 0}]})",
          R"("spacing": {"sources": [{"shape": "ring", "a": [0, 0], "size": 1}]})",
          R"("spacing": {"sources": [{"shape": "point", "a": [0], "size": 1}]})",
          R"("spacing": {"paint": {"origin": [0, 0], "pitch": 0, "tiles": []}})",
          R"("spacing": {"paint": {"origin": [0, 0], "pitch": 1, "tiles": [[0, 0, "AAAA"]]}})",
          R"("spacing": {"background": {"nodes": [[0, 0]], "elements": [[0, 0, 1]], "values": [1]}})",
          R"("spacing": {"background": {"nodes": [[0, 0]], "elements": [], "values": []}})",
          R"("spacing": {"background": {"nodes": [[0, 0]], "elements": [], "values": [0]}})",
          R"("options": {"grid": "quadtree"})",
          R"("options": {"threads": 1.5})",
          R"("options": {"improve": 1})",
          R"("options": {"improve": "better"})",
          R"("limits": [25])",
          R"("limits": {"minAngle": "25"})",
          R"("limits": {"minAngle": 91})",
          R"("limits": {"maxGrowth": 0.5})",
          R"("limits": {"minLength": 0})",
          R"("circleTolerance": 0)",
          R"("circleTolerance": 1e-30)",
          R"("boundaryNames": {"0": "x"})",
          R"("regionNames": {"1a": "x"})",
          R"("regionMarkers": [{"at": [0, 0], "tag": 0}])",
          R"("regionMarkers": [{"at": [0, 0, 0], "tag": 1}])",
          R"("nextId": -4)"}) {
        CAPTURE(field);
        const Diagnostics faults = projectFaults(kHead + "],\n" + field + "}");
        CHECK(!faults.empty());
        CHECK(allLocated(faults));
    }
}

TEST_CASE("Project: refuses shapes with the wrong number of nodes or tags") {
    const auto shape = [](const char *rest) { return projectFaults(kHead + "{\"id\": 3, " + rest + "}]}"); };
    CHECK(shape(R"("kind": "circle", "nodes": [[0, 0], [1, 0]])").empty());
    CHECK(hasCode(shape(R"("kind": "circle", "nodes": [[0, 0]])"), "bad-count"));
    CHECK(hasCode(shape(R"("kind": "rectangle", "nodes": [[0, 0], [1, 1], [2, 2]])"), "bad-count"));
    CHECK(hasCode(shape(R"("kind": "polygon", "nodes": [])"), "bad-count"));
    CHECK(
        hasCode(shape(R"("kind": "polygon", "nodes": [[0, 0], [1, 1], [0, 1]], "segmentTags": [1, 2])"), "bad-count"));
    CHECK(shape(R"("kind": "polyline", "nodes": [[0, 0], [1, 1], [0, 1]], "segmentTags": [1, 2])").empty());
}

TEST_CASE("Project: version 1 is read as before, and written as version 2") {
    const std::string old = R"({"format": "forefront", "version": 1, "shapes": [
    {"id": 1, "kind": "polygon", "use": "boundary", "tag": 1, "name": "", "nodes": [[0, 0], [4, 0], [4, 3]],
     "segmentTags": [1, 2, 1]},
    {"id": 2, "kind": "circle", "use": "boundary", "tag": 1, "name": "hole", "nodes": [[3, 1], [3.25, 1]]},
    {"id": 3, "kind": "polyline", "use": "constraint", "tag": 2, "name": "", "nodes": [[1, 0.1], [2, 0.1]]}],
  "regionMarkers": [], "boundaryNames": {"2": "inlet"}, "regionNames": {}, "spacing": {"fromBoundary": true},
  "options": {"method": "fast"}, "circleTolerance": 0.002, "nextId": 4})";
    const auto document = parseProject(old, "old.json");
    REQUIRE_MESSAGE(document.ok(), messages(document.faults()));
    REQUIRE(document->shapes.size() == 3);
    CHECK(document->shapes[0]->path().curves.empty());
    CHECK(document->shapes[0]->segmentTags == std::vector<std::int32_t>{1, 2, 1});
    CHECK(document->shapes[1]->kind() == ShapeKind::Circle);
    const std::string text = projectText(*document);
    CHECK(text.find("\"version\": 2") != std::string::npos);
    const auto back = parseProject(text, "new.json");
    REQUIRE(back.ok());
    CHECK(sameContent(*document, *back));
}

TEST_CASE("Project: invalid curves are refused with their line and column") {
    const auto faultOf = [](const std::string &members) {
        const Diagnostics faults = projectFaults(
            kHead + "\n{\"id\": 1, \"kind\": \"polygon\", \"nodes\": [[0, 0], [2, 0]],\n" + members + "}]}");
        CHECK(allLocated(faults));
        return faults.empty() ? Diagnostic() : faults.front();
    };
    const std::string arc =
        R"("curves": [{"arc": {"centre": [1, 0], "u": [-1, 0], "v": [0, -1], "start": 0, "sweep": )";
    const std::string half = "3.141592653589793}}, null]";
    CHECK(faultOf(arc + half).code.empty());
    CHECK(faultOf(R"("curves": [{"cubic": [[0, 1], [2, 1]]}, null], "cuts": [[0.25, 0.5], []])").code.empty());

    Diagnostic fault = faultOf(R"("curves": [{"cubic": [[0, 1]]}, null])");
    CHECK(fault.message == "a cubic has 2 control points, found 1");
    CHECK(fault.line == 4);
    CHECK(fault.column == 22);
    fault =
        faultOf(R"("curves": [null, {"arc": {"centre": [1, 0], "u": [0, 0], "v": [0, 1], "start": 0, "sweep": 3}}])");
    CHECK(fault.message == "the arc has no radius: its semi-axes \"u\" and \"v\" enclose no area");
    CHECK(fault.column == 26);
    CHECK(faultOf(arc + "0}}, null]").message.starts_with("invalid sweep 0"));
    CHECK(faultOf(arc + "7}}, null]").message.starts_with("invalid sweep 7"));
    CHECK(faultOf(arc + "3}}, null]").message.find("expected (0, 0) to (2, 0)") != std::string::npos);
    CHECK(faultOf(arc + "1e999}}, null]").code == "bad-number");
    CHECK(faultOf(arc + "NaN}}, null]").line == 4);
    CHECK(faultOf(R"("curves": [{"arc": {"centre": [1, 0], "u": [-1, 0]}}, null])").code == "missing-field");
    CHECK(faultOf(R"("curves": [{"spline": []}, null])").code == "bad-curve");
    CHECK(faultOf(R"("curves": [null])").code == "bad-count");
    CHECK(faultOf(R"("curves": {})").code == "bad-field");
    CHECK(faultOf(R"("cuts": [[0.5, 0.25], []])").code == "bad-number");
    CHECK(faultOf(R"("cuts": [[1.5], []])").code == "bad-number");
    CHECK(faultOf(R"("cuts": [[0.5], [], []])").code == "bad-count");
    CHECK(faultOf(R"("radius": -1)").code == "bad-number");
    CHECK(faultOf(R"("curves": [{"cubic": [[0, 1e61], [2, 1]]}, null])").message == "a control point lies beyond 1e60");
    CHECK(hasCode(projectFaults(kHead + R"({"id": 1, "kind": "circle", "nodes": [[0, 0], [1, 0]], "curves": []}]})"),
                  "bad-curve"));
    CHECK(hasCode(projectFaults(kHead + R"({"id": 1, "kind": "ellipse", "nodes": [[0, 0], [1, 0]]}]})"), "bad-count"));
}

TEST_CASE("Project: cubics that have shrunk to points are read and written as straight segments") {
    const Curve point = Curve::cubic({1, 1}, {1, 1}, {1, 1}, {1, 1}),
                bend = Curve::cubic({1, 1}, {2, 0}, {3, 0}, {4, 1});
    Document document;
    for (const std::vector<Curve> &curves : {std::vector{point, bend, Curve()}, std::vector{point, Curve(), Curve()}}) {
        Shape shape;
        shape.id = document.nextId++;
        shape.nodes = {{1, 1}, {1, 1}, {4, 1}};
        shape.path().curves = curves;
        document.shapes.push_back(std::make_shared<const Shape>(std::move(shape)));
    }
    const std::string text = projectText(document);
    const auto again = parseProject(text, "again");
    REQUIRE(again.ok());
    CHECK(again->shapes[0]->path().curves == std::vector{Curve(), bend, Curve()});
    CHECK(again->shapes[1]->path().curves.empty());
    CHECK(projectText(*again) == text);
    for (const std::size_t nodes : {1U, 2U, 3U}) { // with cuts, which straight segments do not need
        Shape shape;
        shape.id = 1;
        shape.nodes.assign(nodes, {1, 1});
        shape.path().curves.assign(nodes, point);
        shape.cuts.assign(nodes, {0.5, 1.0});
        Document one;
        one.nextId = 2;
        one.shapes.push_back(std::make_shared<const Shape>(std::move(shape)));
        const auto read = parseProject(projectText(one), "again");
        CHECK((read.ok() || !hasCode(read.faults(), "bad-count")));
        CHECK((nodes == 1 || (read.ok() && projectText(*read) == projectText(one))));
    }
}

TEST_CASE("Tile code: round trip of any tile bit for bit; packs runs and refuses damaged text") {
    std::mt19937 random(5);
    for (int round = 0; round < 50; ++round) {
        PaintedSpacing::Tile tile{};
        for (float &value : tile) {
            value = random() % 3 == 0 ? 0.0F : std::bit_cast<float>(static_cast<std::uint32_t>(random() % 0x7f000000U));
        }
        const std::string code = encodeTile(tile);
        CHECK(decodeTile(code) == tile);
        CHECK(!decodeTile(std::string_view(code).substr(4)));
        CHECK(!decodeTile(code.substr(0, code.size() - 4)));
    }
    CHECK(encodeTile({}).size() <= 16);
    CHECK(!decodeTile(""));
}

TEST_CASE("Files: writing is atomic, keeps permissions and follows links") {
    const TemporaryFolder folder;
    const auto path = folder / "a.json";
    CHECK(writeFileAtomically(path, "one").empty());
    std::filesystem::permissions(path, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    std::filesystem::create_symlink("a.json", folder / "link.json");
    CHECK(writeFileAtomically(folder / "link.json", "two").empty());
    CHECK(std::filesystem::is_symlink(folder / "link.json"));
    std::stringstream content;
    content << std::ifstream(path).rdbuf();
    CHECK(content.str() == "two");
    CHECK(std::filesystem::status(path).permissions() ==
          (std::filesystem::perms::owner_read | std::filesystem::perms::owner_write));
    CHECK(folder.fileCount() == 2);
}

TEST_CASE("Files: read and write failures are reported with path and reason") {
    const TemporaryFolder folder;
    const Status missing = writeFileAtomically(folder / "no/such/file", "x");
    REQUIRE(missing.size() == 1);
    CHECK(missing[0].code == "cannot-write");
    CHECK(missing[0].file == (folder / "no/such/file").string());
    CHECK(missing[0].message.find("No such file or directory") != std::string::npos);
    CHECK(hasCode(writeFileAtomically(folder.path, "x"), "cannot-write"));
    const auto absent = readFileBytes(folder / "absent", 10);
    REQUIRE(!absent.ok());
    CHECK(absent.faults()[0].message.find("No such file") != std::string::npos);
    CHECK(!readFileBytes(folder.path, 10).ok());
    REQUIRE(writeFileAtomically(folder / "long", "12345678901").empty());
    CHECK(hasCode(readFileBytes(folder / "long", 10).faults(), "too-large"));
    CHECK(readFileBytes(folder / "long", 11).value() == "12345678901");
}

TEST_CASE("Names: are cleaned, turned into identifiers and made unique") {
    CHECK(validUtf8("a\xff\xc3\xa4\xc3") == "a\xef\xbf\xbd\xc3\xa4\xef\xbf\xbd");
    CHECK(validUtf8("\xed\xa0\x80") == "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd");
    CHECK(cleanName("  in\tlet \n") == "inlet");
    CHECK(cleanName(" \t ").empty());
    CHECK(asIdentifier("4 mm Öffnung") == "n_4_mm__ffnung");
    CHECK(asIdentifier("") == "n_");
    CHECK(asIdentifier("abcdef", 3) == "abc");
    CHECK(asQuotable("a \"b\"\nc") == "a 'b' c");
    CHECK(asQuotable("aä", 2) == "a");
    UniqueNames names;
    CHECK(names.claim("Wall") == "Wall");
    CHECK(names.claim("wall") == "wall_2");
    CHECK(names.claim("WALL_2") == "WALL_2_2");
}

TEST_CASE("Project: the path of the background picture is relative to the project, and need not exist") {
    const TemporaryFolder place;
    std::filesystem::create_directories(place.path / "work");
    Document document;
    document.picture = BackgroundPicture{(place.path / "maps" / "lake.png").string(), {1.0, 2.0}, {40.0, 30.0}};
    const std::filesystem::path file = place.path / "work" / "lake.forefront";
    REQUIRE(writeProject(file, document).empty());
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    CHECK(text.str().find(R"("picture": {"file": "../maps/lake.png", "at": [1, 2], "size": [40, 30])") !=
          std::string::npos);

    std::filesystem::rename(place.path / "work", place.path / "moved");
    const auto back = readDocument(place.path / "moved" / "lake.forefront");
    REQUIRE_MESSAGE(back.ok(), messages(back.faults()));
    CHECK(back->picture == document.picture);
    CHECK(sameContent(*back, document));
    CHECK(sameDomain(*back, Document{}));
    // The recovery journal lies in another folder, so it keeps the whole path.
    CHECK(parseProject(projectText(document), "journal")->picture == document.picture);
}

TEST_CASE("Project: faults of the background picture have a place") {
    const auto faultOf = [](const std::string &members) {
        const Diagnostics faults = projectFaults(kHead + "],\n\"picture\": {" + members + "}}");
        REQUIRE_MESSAGE(faults.size() <= 1, messages(faults));
        return faults.empty() ? Diagnostic{} : faults.front();
    };
    const std::string place = R"("file": "a.png", "at": [0, 0], "size": [4, 3])";
    CHECK(faultOf(place).code.empty());
    CHECK(faultOf(place + R"(, "opacity": 1, "locked": true)").code.empty());
    const Diagnostic fault = faultOf(place + R"(, "opacity": 1.5)");
    CHECK(fault.message == "\"opacity\" must lie between 0 and 1");
    CHECK(fault.line == 3);
    CHECK(fault.column > 50);
    CHECK(faultOf(R"("at": [0, 0], "size": [4, 3])").code == "missing-field");
    CHECK(faultOf(R"("file": "", "at": [0, 0], "size": [4, 3])").code == "bad-field");
    CHECK(faultOf(R"("file": "a.png", "at": [0], "size": [4, 3])").line == 3);
    CHECK(faultOf(R"("file": "a.png", "at": [0, 0], "size": [4, 0])").code == "bad-number");
    CHECK(faultOf(place + R"(, "locked": 1)").line == 3);
}
