#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/svg/svg.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/mesh/edge_table.hpp"
#include "core/files/abaqus/abaqus.hpp"
#include "core/files/common/names.hpp"
#include "core/files/files.hpp"
#include "core/files/gmsh/gmsh.hpp"
#include "core/files/gmsh/msh_groups.hpp"
#include "core/files/inner_edges.hpp"
#include "core/files/medit/medit.hpp"
#include "core/files/obj/obj.hpp"
#include "core/files/su2/su2.hpp"
#include "core/files/svg/svg_picture.hpp"
#include "core/files/vtk/vtk.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <sstream>
#include <tuple>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// A name as a user may type it: any length up to 40 characters, blanks and quotes inside, other scripts.
std::string randomName(samples::Random &random) {
    static constexpr std::array kParts = {"a", "B",   "9",    "_", " ", "\"",       "'",
                                          "%", "%41", "$End", "&", "<", "\xc3\x96", "\xe6\xb9\x96",
                                          ":", ",",   "=",    "*", "#", "\\"};
    std::string name;
    for (std::size_t k = random.below(40) + 1; k > 0; --k) {
        name += kParts[random.below(kParts.size())];
    }
    return cleanName(name);
}

std::int32_t randomTag(samples::Random &random) {
    constexpr std::int32_t kGreatest = std::numeric_limits<std::int32_t>::max();
    return random() < 0.05  ? kGreatest - static_cast<std::int32_t>(random.below(3))
           : random() < 0.2 ? static_cast<std::int32_t>(random.below(5000)) + 1
                            : static_cast<std::int32_t>(random.below(6)) + 1;
}

/// A mesh whose regions, edges and points have random tags, often the same, and random names, sometimes the same.
TriMesh randomTaggedMesh(samples::Random &random) {
    TriMesh mesh = samples::square(random.below(5) + 1, random.below(5) + 1, 0.2, {random(-1e3, 1e3), 1.0 / 3.0},
                                   random.below(1000));
    mesh.edges.clear();
    mesh.boundaryNames.clear();
    if (random() < 0.8) {
        const std::int32_t few[] = {randomTag(random), randomTag(random), randomTag(random)};
        for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
            mesh.regions.push_back(few[random.below(3)]);
        }
    }
    EdgeTable(mesh).forEach([&](NodeId a, NodeId b, std::span<const HalfEdge>) {
        if (random() < 0.4) {
            mesh.edges.push_back({a, b, randomTag(random)});
        }
    });
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        if (random() < 0.1) {
            mesh.points.push_back({samples::node(n), randomTag(random)});
        }
    }
    const std::string shared = randomName(random);
    const TagList tags = tagsOf(mesh);
    for (const auto &[used, names] :
         {std::pair{&tags.edges, &mesh.boundaryNames}, std::pair{&tags.points, &mesh.boundaryNames},
          std::pair{&tags.regions, &mesh.regionNames}}) {
        for (const auto &[tag, name] : *used) {
            if (random() < 0.7) {
                names->emplace(tag, random() < 0.3 ? shared : randomName(random));
            }
        }
    }
    std::erase_if(mesh.boundaryNames, [](const auto &entry) { return entry.second.empty(); });
    std::erase_if(mesh.regionNames, [](const auto &entry) { return entry.second.empty(); });
    return mesh;
}

/// The parts of a mesh that a file must keep, independently of the order of elements, edges and points.
auto content(const TriMesh &mesh) {
    std::set<std::tuple<Element, std::int32_t>> elements;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        Element nodes = mesh.elements[e];
        std::rotate(nodes.begin(), std::min_element(nodes.begin(), nodes.end()), nodes.end());
        elements.emplace(nodes, mesh.region(e));
    }
    std::set<std::tuple<NodeId, NodeId, std::int32_t>> edges;
    for (const TaggedEdge &edge : mesh.edges) {
        edges.emplace(std::min(edge.a, edge.b), std::max(edge.a, edge.b), edge.tag);
    }
    std::set<std::pair<NodeId, std::int32_t>> points;
    for (const TaggedNode &point : mesh.points) {
        points.emplace(point.node, point.tag);
    }
    const TagList tags = tagsOf(mesh);
    return std::tuple(mesh.nodes, elements, edges, points, tags.edges, tags.points, tags.regions);
}

/// The lines of $PhysicalNames: dimension, number and name.
std::vector<std::tuple<int, std::int32_t, std::string>> physicalNames(const std::string &text) {
    std::istringstream lines(text.substr(text.find("$PhysicalNames")));
    std::string line;
    std::getline(lines, line);
    std::getline(lines, line);
    std::vector<std::tuple<int, std::int32_t, std::string>> names;
    while (std::getline(lines, line) && line != "$EndPhysicalNames") {
        std::istringstream words(line);
        int dimension = 0;
        std::int32_t number = 0;
        std::string name;
        words >> dimension >> number;
        std::getline(words, name);
        names.emplace_back(dimension, number, name);
    }
    return names;
}

bool isAscii(const std::string &text) {
    return std::all_of(text.begin(), text.end(),
                       [](char c) { return (c >= ' ' && c <= '~') || c == '\n' || c == '\t'; });
}

} // namespace

TEST_CASE("Formats: random meshes keep elements, tags and names in every format") {
    const TemporaryFolder folder;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        samples::Random random(seed);
        const TriMesh mesh = randomTaggedMesh(random);
        const auto expected = content(mesh);
        for (const FileFormat &format : allFormats().list()) {
            const bool keepsKinds = format.hasOpenBoundaries; // of boundaries alone, without tags
            if (!format.writesMesh || !format.readsMesh || keepsKinds) {
                continue;
            }
            CAPTURE(seed);
            CAPTURE(format.id);
            const auto path = folder / (std::string("mesh") + format.extension);
            const Status status = writeMesh(path, mesh, format.id);
            REQUIRE_MESSAGE(status.empty(), messages(status));
            auto back = triangles(allFormats().readMesh(path));
            REQUIRE_MESSAGE(back.ok(), messages(back.faults()));
            undoRounding(*back, mesh, exportNotes(path, mesh, format.id));
            CHECK(content(*back) == expected);
        }
    }
}

TEST_CASE("MSH: names and numbers of physical groups differ across dimensions") {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        samples::Random random(seed);
        const TriMesh mesh = randomTaggedMesh(random);
        for (const auto write : {writeMsh2, writeMsh4, writeMsh4Binary}) {
            std::set<std::int32_t> numbers;
            std::set<std::string> names;
            for (const auto &[dimension, number, name] : physicalNames(written(write, mesh))) {
                CHECK(number >= 1);
                CHECK(numbers.insert(number).second);
                CHECK(names.insert(name).second);
                CHECK(name.size() <= 130); // 127 bytes, the quotes and the blank before them
            }
        }
    }
}

TEST_CASE("MSH: edges keep tag and name; regions and points that share them are renumbered and renamed") {
    TriMesh mesh = samples::square(2, 2);
    mesh.regions.assign(mesh.elements.size(), 1);
    mesh.regions.back() = 7;
    mesh.points = {{samples::node(4), 3}};
    mesh.boundaryNames = {{1, "lake"}, {3, "gauge"}};
    mesh.regionNames = {{1, "lake"}, {7, "island"}};
    const std::vector<std::tuple<int, std::int32_t, std::string>> expected = {
        {0, 2003, " \"gauge_point\""}, {1, 1, " \"lake\""},           {1, 2, " \"boundary_2\""}, {1, 3, " \"gauge\""},
        {1, 4, " \"boundary_4\""},     {2, 1001, " \"lake_region\""}, {2, 1007, " \"island\""}};
    CHECK(physicalNames(written(writeMsh2, mesh)) == expected);
    CHECK(physicalNames(written(writeMsh4, mesh)) == expected);
    const std::string text = written(writeMsh2, mesh);
    CHECK(text.find("$Comments") > text.find("$EndElements")); // deal.II expects only $PhysicalNames before $Nodes
    const auto back = triangles(readMsh(sourceOf(text)));
    REQUIRE(back.ok());
    CHECK(content(*back) == content(mesh));
}

TEST_CASE("MSH: tags that are distinct across dimensions are the physical numbers, without comments") {
    TriMesh mesh = samples::square(2, 2);
    mesh.regions.assign(mesh.elements.size(), 8);
    mesh.boundaryNames = {{1, "wall"}};
    const std::string text = written(writeMsh2, mesh);
    CHECK(text.find("$Comments") == std::string::npos);
    CHECK(text.find("2 8 \"region_8\"") != std::string::npos);
}

TEST_CASE("MSH: broken comments about groups are skipped") {
    const std::string lines = "group\ngroup 2 1001 tag 1\ngroup 3 5 tag 1 \"solid\"\ngroup 2 1001 tag 0 \"zero\"\n"
                              "group 2 x tag 1 \"x\"\ngroup 2 1001tag 1 \"x\"\ngroup 2 99999999999 tag 1 \"x\"\n"
                              "group 2 1001 tag 4 \"a%20b\"\ngroup 1 2 tag \"";
    const std::vector<MshGroup> origins = readMshOrigins(lines);
    REQUIRE(origins.size() == 1);
    CHECK(origins[0].number == 1001);
    CHECK(origins[0].tag == 4);
    CHECK(origins[0].name == "a b");
}

TEST_CASE("VTK legacy: FIELD blocks have one value per cell; names are look-up tables") {
    TriMesh mesh = twoRegionMesh();
    mesh.boundaryNames[4] = std::string(300, 'x');
    const std::string text = written(writeVtk, mesh);
    const std::size_t points = text.find("POINTS");
    CHECK(text.find("DATASET UNSTRUCTURED_GRID\nPOINTS") != std::string::npos);
    CHECK(text.find("FIELD") > text.find("CELL_DATA"));
    const std::size_t cells = mesh.elements.size() + mesh.edges.size() + mesh.points.size();
    CHECK(text.find("region 1 " + std::to_string(cells) + " int") != std::string::npos);
    CHECK(text.find("CELL_DATA " + std::to_string(cells) + "\nSCALARS MaterialID int 1\n") != std::string::npos);
    CHECK(text.find("LOOKUP_TABLE boundary:1:sea%20bed 1\n") != std::string::npos);
    std::istringstream words(text.substr(points));
    std::size_t longest = 0;
    for (std::string word; words >> word;) {
        longest = std::max(longest, word.size());
    }
    CHECK(longest < 256);
    CHECK(isAscii(text));
}

TEST_CASE("VTK legacy: names in a field block, as earlier versions wrote them, and foreign look-up tables are read") {
    const std::string head = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\n";
    const std::string grid = "POINTS 3 double\n0 0 0 1 0 0 0 1 0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\nCELL_DATA 1\n"
                             "SCALARS region int 1\nLOOKUP_TABLE warm\n4\n";
    const auto old = triangles(readVtk(sourceOf(head + "FIELD FieldData 1\nregion:sea%20bed 1 1 int\n4\n" + grid)));
    REQUIRE_MESSAGE(old.ok(), messages(old.faults()));
    CHECK(regionName(old->regionNames, 4) == "sea bed");
    const auto foreign = triangles(readVtk(sourceOf(head + grid + "LOOKUP_TABLE warm 2\n0 0 0 1\n1 0.5 0 1\n")));
    REQUIRE_MESSAGE(foreign.ok(), messages(foreign.faults()));
    CHECK(foreign->regionNames.empty());
    const auto cut = triangles(readVtk(sourceOf(head + grid + "LOOKUP_TABLE warm 2\n0 0 0 1\n1 0.5\n")));
    CHECK(hasCode(cut.faults(), "bad-number"));
}

TEST_CASE("SVG: paths of a large mesh are short enough for readers that limit them") {
    const std::string text = written(writeSvg, samples::square(300, 250)); // 150,000 elements
    std::size_t longest = 0, paths = 0, elements = 0;
    for (std::size_t at = text.find("<path"); at != std::string::npos; at = text.find("<path", at + 1)) {
        longest = std::max(longest, text.find("</path>", at) - at);
        ++paths;
    }
    for (const char c : text) {
        elements += c == 'Z' ? 1 : 0;
    }
    CHECK(elements == 150000);
    CHECK(paths >= 150);
    CHECK(longest < 60'000);
}

TEST_CASE("SU2 and the other formats with names in comments are ASCII files") {
    TriMesh mesh = twoRegionMesh();
    mesh.regionNames[5] = "\xc3\x96l \xe6\xb9\x96 100 %";
    for (const auto write : {writeSu2, writeAbaqus, writeMedit, writeObj}) {
        const std::string text = written(write, mesh);
        CHECK(isAscii(text));
        CHECK(text.find("100 %25") != std::string::npos);
    }
}

TEST_CASE("percentEncoded: the inverse restores every text") {
    CHECK(percentEncoded("a b\"%\n") == "a b%22%25%0A");
    CHECK(percentEncoded("a b", " ") == "a%20b");
    CHECK(percentDecoded("%4") == "%4");
    CHECK(percentDecoded("%zz%41") == "%zzA");
    samples::Random random(5);
    for (int k = 0; k < 200; ++k) {
        const std::string name = randomName(random);
        CHECK(isAscii(percentEncoded(name)));
        CHECK(percentDecoded(percentEncoded(name)) == name);
    }
}

TEST_CASE("withoutInnerEdges: only edges on the boundary of the triangles stay") {
    TriMesh mesh = twoRegionMesh(8, 5);
    mesh.edgeStretches.resize(mesh.edges.size());
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        mesh.edgeStretches[e].t0 = mesh.edges[e].tag; // to be found again
    }
    const Mesh outline = withoutInnerEdges(mesh);
    REQUIRE(outline.edgeStretches.size() == outline.edges.size());
    for (std::size_t e = 0; e < outline.edges.size(); ++e) {
        CHECK(outline.edgeStretches[e].t0 == outline.edges[e].tag);
    }
    CHECK(outline.edges.size() == 26);
    CHECK(mesh.edges.size() == 26 + 5 + 1);
    CHECK(std::none_of(outline.edges.begin(), outline.edges.end(),
                       [](const TaggedEdge &edge) { return edge.tag == 9 || edge.tag == 6; }));
    CHECK(std::ranges::equal(outline.triangles(), mesh.elements));
    CHECK(outline.points.size() == mesh.points.size());
    for (const auto write : {writeMsh2, writeVtk, writeSu2}) {
        CHECK(written(write, outline).find("interface") == std::string::npos);
    }
}

TEST_CASE("acceptsInnerEdges: SU2, TELEMAC and ANUGA take every tagged edge for a boundary") {
    const std::set<std::string_view> boundariesAlone = {"su2", "selafin", "anuga"};
    for (const FileFormat &format : allFormats().list()) {
        if (format.writesMesh) {
            CAPTURE(format.id);
            CHECK(acceptsInnerEdges({}, format.id) == (boundariesAlone.count(format.id) == 0));
        }
    }
    CHECK_FALSE(acceptsInnerEdges("wing.SU2"));
    CHECK(acceptsInnerEdges("wing.su2", "msh2"));
    CHECK(acceptsInnerEdges("wing.msh"));
}

TEST_CASE("Abaqus: names of sets are distinct identifiers of at most 80 characters, and changes are reported") {
    const TemporaryFolder folder;
    TriMesh mesh = twoRegionMesh();
    mesh.boundaryNames = {{1, std::string(90, 'a')}, {2, std::string(95, 'a')}, {3, "nall"}, {9, "4th of July"}};
    mesh.regionNames = {{2, "water"}, {5, "Water"}};
    std::istringstream lines(written(writeAbaqus, mesh));
    std::set<std::string> names;
    for (std::string line; std::getline(lines, line);) {
        for (const char *key : {"ELSET=", "NSET=", "NAME="}) {
            const std::size_t at = line.find(std::string(", ") + key);
            if (line.starts_with('*') && !line.starts_with("**") && at != std::string::npos) {
                std::string name = line.substr(line.find('=', at) + 1);
                name = name.substr(0, name.find(','));
                CHECK(name.size() <= 80);
                CHECK(asIdentifier(name) == name);
                std::transform(name.begin(), name.end(), name.begin(),
                               [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
                CHECK_MESSAGE(names.insert(name).second, name);
            }
        }
    }
    // All nodes and elements, two regions, six boundary tags with a surface each, the point.
    CHECK(names.size() == 2 + 2 + 2 * 6 + 1);
    REQUIRE(writeMesh(folder / "a.inp", mesh).empty());
    const Diagnostics notes = exportNotes(folder / "a.inp", mesh);
    REQUIRE(notes.size() == 1);
    CHECK(notes[0].severity == Severity::Note);
    CHECK(notes[0].code == "changed-names");
    CHECK(notes[0].file.ends_with("a.inp"));
    for (const char *part :
         {"boundary 'nall' is nall_2", "region 'Water' is Water_region", "boundary '4th of July' is n_4th_of_July"}) {
        CHECK_MESSAGE(notes[0].message.find(part) != std::string::npos, notes[0].message);
    }
    CHECK(exportNotes("b.inp", samples::square(2, 2)).empty());
    CHECK(exportNotes("a.vtu", mesh).empty());
    const auto back = triangles(allFormats().readMesh(folder / "a.inp"));
    REQUIRE(back.ok());
    CHECK(content(*back) == content(mesh));
}
