#include "core/files/files.hpp"
#include "core/files/medit/medit.hpp"
#include "core/files/netgen/netgen.hpp"
#include "core/files/triangle/triangle.hpp"
#include "core/files/vtk/vtk.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

using Names = std::map<std::int32_t, std::string>;

/// What a reader made of the tags of a text: those of edges or segments, of points and of regions.
struct TagsRead {
    std::vector<std::int32_t> edges, points, regions;
    Names boundaryNames, regionNames;
    std::string notes;
};

std::string textOf(const ImportNotes &notes) {
    std::string text;
    for (const ImportNote &note : notes.entries()) {
        text += note.code + ": " + note.message + '\n';
    }
    return text;
}

TagsRead tagsIn(const TriMesh &mesh, const ImportNotes &notes) {
    TagsRead tags;
    for (const TaggedEdge &edge : mesh.edges) {
        tags.edges.push_back(edge.tag);
    }
    for (const TaggedNode &point : mesh.points) {
        tags.points.push_back(point.tag);
    }
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        tags.regions.push_back(mesh.region(e));
    }
    tags.boundaryNames = mesh.boundaryNames;
    tags.regionNames = mesh.regionNames;
    tags.notes = textOf(notes);
    return tags;
}

TagsRead tagsOfMesh(Result<Mesh> (*read)(const SourceText &), const std::string &text) {
    ImportNotes notes;
    SourceText source = sourceOf(text);
    source.notes = &notes;
    const Result<TriMesh> mesh = triangles(read(source));
    REQUIRE_MESSAGE(mesh.ok(), messages(mesh.faults()));
    return tagsIn(*mesh, notes);
}

TagsRead tagsOfPoly(const std::string &text) {
    ImportNotes notes;
    SourceText source = sourceOf(text);
    source.notes = &notes;
    const Result<DomainFile> file = readPoly(source);
    REQUIRE_MESSAGE(file.ok(), messages(file.faults()));
    const Domain *const domain = &file->domain;
    TagsRead tags;
    for (const DomainSegment &segment : domain->segments) {
        tags.edges.push_back(segment.tag);
    }
    for (const ConstraintPoint &point : domain->points) {
        tags.points.push_back(point.tag);
    }
    for (const RegionMarker &marker : domain->regionMarkers) {
        tags.regions.push_back(marker.tag);
    }
    tags.boundaryNames = domain->boundaryNames;
    tags.regionNames = domain->regionNames;
    tags.notes = textOf(notes);
    return tags;
}

using Tags = std::vector<std::int32_t>;

std::string squareMedit(const std::string &edges, const std::string &regions) {
    return "MeshVersionFormatted 2\nDimension 2\nVertices 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + edges + "Triangles 2\n" +
           regions + "End\n";
}

std::string squareVtu(const std::string &data) {
    return R"(<VTKFile type="UnstructuredGrid"><UnstructuredGrid>)" + data.substr(0, data.find('|')) +
           R"(<Piece NumberOfPoints="4" NumberOfCells="4"><Points>
<DataArray type="Float64" NumberOfComponents="3">0 0 0 1 0 0 1 1 0 0 1 0</DataArray></Points><Cells>
<DataArray type="Int64" Name="connectivity">0 1 2 0 2 3 0 1 1 2</DataArray>
<DataArray type="Int64" Name="offsets">3 6 8 10</DataArray>
<DataArray type="UInt8" Name="types">5 5 3 3</DataArray></Cells><CellData>)" +
           data.substr(data.find('|') + 1) + "</CellData></Piece></UnstructuredGrid></VTKFile>";
}

} // namespace

TEST_CASE("Tags below 1: the segments, points and regions of a .poly file stay apart") {
    const std::string nodes = "5 2 0 1\n0 0 0 0\n1 4 0 0\n2 4 2 0\n3 0 2 0\n4 1 1 -7\n";
    const TagsRead tags =
        tagsOfPoly(nodes + "4 1\n0 0 1 -2\n1 1 2 -3\n2 2 3 0\n3 3 0 -2\n0\n3\n0 1 1 0 -1\n1 2 1 1\n2 3 1 2.5\n");
    CHECK(tags.edges == Tags{1, 2, 3, 1});
    CHECK(tags.points == Tags{4});
    CHECK(tags.regions == Tags{2, 1, 3});
    CHECK(tags.boundaryNames == Names{{1, "boundary_-2"}, {2, "boundary_-3"}, {3, "boundary_0"}, {4, "boundary_-7"}});
    CHECK(tags.regionNames == Names{{2, "region_0"}, {3, "region_2.5"}});
    CHECK(tags.notes == "raised-tags: tags must be whole numbers from 1 on; other ones are renumbered: boundary_-2 is "
                        "1, boundary_-3 is 2, boundary_0 is 3, boundary_-7 is 4, region_0 is 2, region_2.5 is 3\n");
    // Other tags are kept, and their numbers are not given away.
    const TagsRead mixed = tagsOfPoly(nodes + "4 1\n0 0 1 1\n1 1 2 0\n2 2 3 9\n3 3 0 -1\n0\n");
    CHECK(mixed.edges == Tags{1, 10, 9, 11});
    CHECK(mixed.points == Tags{12});
    // Where every marker is 0, or there are none, the file has no tags.
    const std::string square = "4 2 0 0\n0 0 0\n1 4 0\n2 4 2\n3 0 2\n";
    for (const std::string text :
         {"4 1\n0 0 1 0\n1 1 2 0\n2 2 3 0\n3 3 0\n0\n", "4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n"}) {
        const TagsRead none = tagsOfPoly(square + text);
        CHECK(none.edges == Tags{1, 1, 1, 1});
        CHECK(none.boundaryNames.empty());
        CHECK(none.notes.empty());
    }
}

TEST_CASE("Tags below 1: free numbers are found even where the greatest is in use") {
    const std::string most = std::to_string(std::numeric_limits<std::int32_t>::max());
    const TagsRead tags = tagsOfPoly("4 2 0 0\n0 0 0\n1 4 0\n2 4 2\n3 0 2\n4 1\n0 0 1 " + most +
                                     "\n1 1 2 1\n2 2 3 -5\n3 3 0 -6\n0\n# boundary 2 \"inlet\"\n");
    CHECK(tags.edges == Tags{std::numeric_limits<std::int32_t>::max(), 1, 3, 4});
    CHECK(tags.boundaryNames == Names{{2, "inlet"}, {3, "boundary_-5"}, {4, "boundary_-6"}});
}

TEST_CASE("Tags below 1: triangles and edges of Triangle stay apart") {
    const std::string nodes = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n", edges = "3 1\n1 1 2 -2\n2 1 3 0\n3 2 3 4\n";
    const auto read = [&](const std::string &elements) {
        ImportNotes notes;
        SourceText ofElements = sourceOf(elements);
        ofElements.notes = &notes;
        const SourceText ofNodes = sourceOf(nodes), ofEdges = sourceOf(edges);
        const Result<TriMesh> mesh = triangles(readTriangleParts(ofNodes, ofElements, &ofEdges));
        REQUIRE_MESSAGE(mesh.ok(), messages(mesh.faults()));
        return tagsIn(*mesh, notes);
    };
    const TagsRead tags = read("2 3 1\n1 1 2 3 0\n2 1 3 4 1\n");
    CHECK(tags.edges == Tags{5, 4}); // 0: an inner edge
    CHECK(tags.regions == Tags{2, 1});
    CHECK(tags.boundaryNames == Names{{5, "boundary_-2"}});
    CHECK(tags.regionNames == Names{{2, "region_0"}});
    CHECK(tags.notes.find("boundary_-2 is 5, region_0 is 2") != std::string::npos);
    CHECK(read("2 3 1\n1 1 2 3 0.5\n2 1 3 4 -1.5\n").regionNames == Names{{1, "region_0.5"}, {2, "region_-1.5"}});
    CHECK(read("2 3 1\n1 1 2 3 0\n2 1 3 4 0\n").regions == Tags{1, 1});
    CHECK(read("2 3 1\n1 1 2 3 0\n2 1 3 4 0\n").regionNames.empty());
    CHECK(read("2 3 0\n1 1 2 3\n2 1 3 4\n").regions == Tags{1, 1});
}

TEST_CASE("Tags below 1: references of MEDIT stay apart") {
    const TagsRead tags =
        tagsOfMesh(readMedit, squareMedit("Edges 4\n1 2 -2\n2 3 -3\n3 4 0\n4 1 5\n", "1 2 3 -1\n1 3 4 0\n"));
    CHECK(tags.edges == Tags{6, 7, 8, 5});
    CHECK(tags.regions == Tags{1, 2});
    CHECK(tags.boundaryNames == Names{{6, "boundary_-2"}, {7, "boundary_-3"}, {8, "boundary_0"}});
    CHECK(tags.regionNames == Names{{1, "region_-1"}, {2, "region_0"}});
    CHECK(tags.notes.find("raised-tags") == 0);
    CHECK(tags.notes.find('\n') + 1 == tags.notes.size());
    const TagsRead none = tagsOfMesh(readMedit, squareMedit("Edges 1\n1 2 0\n", "1 2 3 0\n1 3 4 0\n"));
    CHECK(none.edges == Tags{1});
    CHECK(none.regions == Tags{1, 1});
    CHECK(none.notes.empty());
}

TEST_CASE("Tags below 1: the arrays of VTU and VTK stay apart, and numbers too large to be tags, too") {
    const std::string tags = R"(|<DataArray type="Int64" Name="region">0 1 0 0</DataArray>
<DataArray type="Int64" Name="boundary">0 0 -2 5000000000</DataArray>)";
    const TagsRead vtu = tagsOfMesh(readVtu, squareVtu(tags));
    CHECK(vtu.edges == Tags{1, 2});
    CHECK(vtu.regions == Tags{2, 1});
    CHECK(vtu.boundaryNames == Names{{1, "boundary_-2"}, {2, "boundary_5e+09"}});
    CHECK(vtu.regionNames == Names{{2, "region_0"}});
    CHECK(vtu.notes.find("boundary_-2 is 1, boundary_5e+09 is 2, region_0 is 2") != std::string::npos);
    // A name that the file has for such a tag is kept.
    const TagsRead named =
        tagsOfMesh(readVtu, squareVtu(R"(<FieldData><DataArray type="Int32" Name="boundary:inlet">-2</DataArray>
<DataArray type="Int32" Name="region:air">0</DataArray></FieldData>)" +
                                      tags));
    CHECK(named.boundaryNames == Names{{1, "inlet"}, {2, "boundary_5e+09"}});
    CHECK(named.regionNames == Names{{2, "air"}});
    const std::string vtk = "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
                            "0 0 0 1 0 0 1 1 0 0 1 0\nCELLS 3 11\n3 0 1 2\n3 0 2 3\n2 0 1\nCELL_TYPES 3\n5 5 3\n"
                            "CELL_DATA 3\nSCALARS CellEntityIds int 1\nLOOKUP_TABLE default\n0 1 -4\n";
    const TagsRead legacy = tagsOfMesh(readVtk, vtk);
    CHECK(legacy.edges == Tags{1});
    CHECK(legacy.regions == Tags{2, 1});
    CHECK(legacy.boundaryNames == Names{{1, "boundary_-4"}});
    // An array of tags that does not fit is not dropped without a word.
    const TagsRead shorter =
        tagsOfMesh(readVtu, squareVtu(R"(|<DataArray type="Int64" Name="gmsh:physical">3 4</DataArray>)"));
    CHECK(shorter.notes == "array-length: the array 'gmsh:physical' is ignored: it has 2 values for 4 cells\n");
}

TEST_CASE("Tags below 1: surfaces and boundary conditions of Netgen stay apart") {
    const TagsRead tags =
        tagsOfMesh(readNetgen, "mesh3d\ndimension\n2\nsurfaceelements\n2\n1 0 0 0 3 1 2 3\n1 2 0 0 3 1 3 4\n"
                               "edgesegments\n2\n0 0 1 2\n3 0 2 3\npoints\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                               "bcnames\n1\n3 wall\nendmesh\n");
    CHECK(tags.edges == Tags{4, 3});
    CHECK(tags.regions == Tags{3, 2});
    CHECK(tags.boundaryNames == Names{{3, "wall"}, {4, "boundary_0"}});
    CHECK(tags.regionNames == Names{{3, "region_0"}});
}
