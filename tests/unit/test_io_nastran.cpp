#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/nastran/nastran.hpp"
#include "core/files/nastran/nastran_real.hpp"
#include "tests/unit/block_samples.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

const std::string kBulk = "GRID,1,,0.,0.,0.\nGRID,2,,4.,0.,0.\nGRID,3,,4.,4.,0.\nGRID,4,,0.,4.,0.\n";

std::string nastranRefusal(const std::string &text) {
    const Result<Mesh> mesh = readNastran(sourceOf(text));
    REQUIRE_FALSE(mesh.ok());
    CHECK_MESSAGE(allLocated(mesh.faults()), messages(mesh.faults()));
    return messages(mesh.faults());
}

} // namespace

TEST_CASE("Nastran: the text of a small mesh; properties of boundary parts are none of regions") {
    samples::BlockMaker maker({{0, 0}, {4, 0}, {4, 4}, {0, 1e-7}});
    maker.add(CellKind::Quadrilateral8, {samples::node(0), samples::node(1), samples::node(2), samples::node(3)}, 2);
    maker.tag(samples::node(0), samples::node(1), 2);
    maker.mesh.points = {{samples::node(2), 7}};
    const std::string text = written(writeNastran, maker.mesh);
    CHECK(text.find("$ group 2 boundary 2 \"boundary_2\"\n$ group 1002 region 2 \"region_2\"\n"
                    "$ group 7 point 7 \"boundary_7\"\n$ point 3 7\nBEGIN BULK\n"
                    "GRID*                  1                              0.              0.*\n"
                    "*                     0.\n") != std::string::npos);
    CHECK(text.find("GRID*                  4                              0.       0.0000001*\n") !=
          std::string::npos);
    CHECK(text.ends_with("CQUAD8         1    1002       1       2       3       4       5       6+\n"
                         "+              7       8\nCROD           2       2       1       2\nENDDATA\n"));
    const Result<Mesh> back = readNastran(sourceOf(text));
    REQUIRE_MESSAGE(back.ok(), messages(back.faults()));
    CHECK(back->edges.at(0).middle == NodeId{4});
    CHECK(back->edges.at(0).tag == 2);
    CHECK(back->blocks.at(0).regions == std::vector<std::int32_t>{2});
    CHECK(back->nodes == maker.mesh.nodes);
    CHECK(noteNastranChanges(maker.mesh).empty());
}

TEST_CASE("Nastran: small, large and free fields with continuations") {
    const std::string text = "SOL 101\nCEND\nGRID rubbish\nBEGIN BULK\n$ comment\n"
                             "GRID           1              0.      0.      1.\n"
                             "grid*                  2                          4.0+00            0.D0*A\n"
                             "*A                    1.\n"
                             "GRID,3,,4.,4.,1.$ here\n"
                             "GRID,4,0,0.0,.4E1\n,1.\n"
                             "GRID,5,,2.,0.,1.\nGRID,6,,4.,2.,1.\nGRID,7,,2.,4.,1.\nGRID,8,,0.,2.,1.\n"
                             "CQUAD8   11      3       1       2       3       4       5       6      +B\n"
                             "+B      7       8\nCBAR,12,9,1,2,0.,0.,1.\nPLOTEL,13,2,3\nPSHELL,3,1,.1\n"
                             "CTRIA6,14,,1,2,3\nENDDATA\nGRID,1\n";
    ImportNotes notes;
    SourceText source = sourceOf(text);
    source.notes = &notes;
    const Result<Mesh> mesh = readNastran(source);
    CHECK_FALSE(mesh.ok()); // the free line of GRID 4 has more fields than its card: z is field 9
    const std::string right = std::string(text).replace(text.find(",.4E1\n,1."), 9, ",.4E1,1.");
    source.text = right;
    const Result<Mesh> read = readNastran(source);
    REQUIRE_MESSAGE(read.ok(), messages(read.faults()));
    CHECK(read->nodes.size() == 8);
    CHECK(read->nodes[1] == Vec2{4, 0});
    CHECK(read->nodes[3] == Vec2{0, 4});
    const MeshView view(*read);
    REQUIRE(view.elementCount() == 2);
    CHECK(view.kindOf(0) == CellKind::Quadrilateral8);
    CHECK(view.kindOf(1) == CellKind::Triangle3); // its middle nodes are left out
    CHECK(view.region(0) == 3);
    CHECK(view.region(1) == 14); // the property is the number of the element
    REQUIRE(read->edges.size() == 2);
    CHECK(read->edges[0].tag == 9);
    CHECK(read->edges[0].middle == NodeId{4});
    CHECK(messages(notes.diagnostics()).find("card 'PSHELL' is ignored") != std::string::npos);
}

TEST_CASE("Nastran: what cannot be read is refused with its place") {
    const auto refuses = [](const std::string &text, const char *words) {
        const std::string said = nastranRefusal(text);
        CHECK_MESSAGE(said.find(words) != std::string::npos, said);
    };
    refuses("CTRIA3,1,1,1,2,3\n", "no GRID cards");
    refuses(kBulk + "CTETRA,1,1,1,2,3,4\n", "elements CTETRA cannot be read");
    refuses(kBulk + "CTRIA3,1,1,1,2,9\n", "grid point 9, which does not exist");
    refuses(kBulk + "CTRIA3,1,1,1,2,2\n", "refers to a node twice");
    refuses(kBulk + "CTRIA3,1,1,1,2\n", "field 6 is empty");
    refuses(kBulk + "CTRIA3,1,x,1,2,3\n", "found 'x'");
    refuses(kBulk + "CTRIA6,1,1,1,2,3,4\n", "is empty");
    refuses(kBulk + "GRID,5,7,0.,0.,0.\n", "coordinate system 7");
    refuses(kBulk + "GRID,5,,abc,0.,0.\n", "found 'abc'");
    refuses(kBulk + "GRID,5,,1.+999,0.,0.\n", "must be finite");
    refuses(kBulk + "GRID,5,,1.,0.,3.\n", "not lie in one plane");
    refuses(kBulk + "GRID,2,,1.,0.,0.\n", "repeats the number");
    refuses(kBulk + "INCLUDE 'a.bdf'\n", "included files");
    refuses(kBulk + "GRDSET,,5\n", "GRDSET");
    refuses("+ 1 2\n" + kBulk, "does not follow a card");
    refuses(kBulk + "CTRIA3\t1\t1\t1\t2\t3\n", "has tabs");
}

TEST_CASE("Nastran: real numbers have as many digits as fit, always with a point") {
    const auto text = [](double value) { return nastranReal(value, 16).text; };
    CHECK(text(0.0) == "0.");
    CHECK(text(-0.0) == "0.");
    CHECK(text(2.0) == "2.");
    CHECK(text(-0.25) == "-0.25");
    CHECK(text(123456.0) == "123456.");
    CHECK(text(1e-7) == "0.0000001");
    CHECK(text(1e-17) == "1.E-17");
    CHECK(text(1e300) == "1.E300");
    CHECK(text(1.0 / 3.0) == ".333333333333333");
    CHECK(text(-2.0 / 3.0) == "-.66666666666667");
    CHECK(nastranReal(1.0 / 3.0, 16).rounded);
    CHECK_FALSE(nastranReal(0.1, 16).rounded);
    samples::Random random(5);
    for (int k = 0; k < 2000; ++k) {
        const double value = random(-1.0, 1.0) * std::pow(10.0, random(-30.0, 30.0));
        const NastranReal real = nastranReal(value, 16);
        CAPTURE(real.text);
        CHECK(real.text.size() <= 16);
        CHECK(real.text.find('.') != std::string::npos);
        const auto back = readNastranReal(real.text);
        REQUIRE(back);
        CHECK(std::fabs(*back - value) <= 1e-9 * std::fabs(value));
        CHECK(real.rounded == (*back != value));
    }
    CHECK(readNastranReal("1.5-3") == 1.5e-3);
    CHECK(readNastranReal("-1.+2") == -100.0);
    CHECK(readNastranReal("-2.5E-3") == -2.5e-3);
    CHECK_FALSE(readNastranReal("1-x"));
    CHECK_FALSE(readNastranReal(""));
}

TEST_CASE("Nastran: rounded coordinates are noted; the content shows the format") {
    CHECK(messages(noteNastranChanges(twoRegionMesh())).find("rounded to the 16 characters") != std::string::npos);
    CHECK(looksLikeNastran("ID x\nBegin Bulk\n"));
    CHECK(looksLikeNastran("$ a\nGRID*  1"));
    CHECK(looksLikeNastran("GRID,1"));
    CHECK_FALSE(looksLikeNastran("GRIDS 1"));
    CHECK_FALSE(looksLikeNastran("<GRID >"));
}
