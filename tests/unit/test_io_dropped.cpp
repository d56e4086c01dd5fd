#include "core/engine/mesh/verify.hpp"
#include "core/files/abaqus/abaqus.hpp"
#include "core/files/files.hpp"
#include "core/files/gmsh/gmsh.hpp"
#include "core/files/medit/medit.hpp"
#include "core/files/netgen/netgen.hpp"
#include "core/files/obj/obj.hpp"
#include "core/files/triangle/triangle.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Returns the notes of a reader on a text, one per line with its count.
template <class T>
std::string notesOn(Result<T> (*read)(const SourceText &), const std::string &text, Result<T> *result = nullptr) {
    ImportNotes notes;
    SourceText source = sourceOf(text);
    source.notes = &notes;
    Result<T> got = read(source);
    REQUIRE_MESSAGE(got.ok(), messages(got.faults()));
    std::string list;
    for (const ImportNote &note : notes.entries()) {
        list += note.code + ' ' + std::to_string(note.count) + '\n';
    }
    if (result != nullptr) {
        *result = std::move(got);
    }
    return list;
}

const std::string kNodes2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n";

} // namespace

TEST_CASE("MSH: lines and triangles in several physical groups are kept once, with a note") {
    const std::string elements = "$Elements\n6\n1 1 2 5 1 1 2\n2 1 2 6 1 1 2\n3 2 2 7 1 1 2 3\n4 2 2 8 1 1 2 3\n"
                                 "5 2 2 7 1 1 3 4\n6 2 2 8 1 1 3 4\n$EndElements\n";
    const std::string data =
        "$ElementData\n1\n\"flux\"\n1\n0\n3\n0\n1\n4\n3 1.5\n4 1.5\n5 2.5\n6 2.5\n$EndElementData\n";
    Result<MeshFields> read = error("unread", "not read yet");
    CHECK(notesOn(readMshFields, kNodes2 + elements + data, &read) == "several-groups 3\n");
    CHECK(read->mesh.elementCount() == 2);
    CHECK(read->mesh.blocks.front().regions == std::vector<std::int32_t>{7, 7});
    REQUIRE(read->mesh.edges.size() == 1);
    CHECK(read->mesh.edges[0].tag == 5);
    CHECK(read->elementFields.at("flux") == std::vector<double>{1.5, 2.5});
    CHECK(verify(read->mesh).empty());
    // A mesh with one group and a triangle given twice is a faulty mesh.
    const std::string twice = "$Elements\n2\n3 2 2 7 1 1 2 3\n4 2 2 7 1 1 2 3\n$EndElements\n";
    Result<Mesh> faulty = error("unread", "not read yet");
    CHECK(notesOn(readMsh, kNodes2 + twice, &faulty).empty());
    CHECK(hasErrors(verify(*faulty)));
    const std::string msh4 =
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 1 0\n1 0 0 0 1 1 0 2 4 9 0\n$EndEntities\n"
        "$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n$EndNodes\n"
        "$Elements\n1 1 1 1\n2 1 2 1\n1 1 2 3\n$EndElements\n";
    CHECK(notesOn(readMsh, msh4) == "several-groups 1\n");
}

TEST_CASE("MSH: time steps and fields that are not read are noted") {
    const std::string triangle = "$Elements\n1\n1 2 2 7 1 1 2 3\n$EndElements\n";
    const auto data = [](const std::string &name) {
        return "$NodeData\n1\n\"" + name + "\"\n1\n0\n3\n0\n1\n3\n1 1\n2 1\n3 2\n$EndNodeData\n";
    };
    CHECK(notesOn(readMshFields, kNodes2 + triangle + data("T") + data("T")) == "time-steps 1\n");
    CHECK(notesOn(readMshFields, kNodes2 + triangle + data("T") + data("u")).empty());
    CHECK(notesOn(readMshSpacing, kNodes2 + triangle + data("T") + data("u")) == "other-fields 1\n");
    CHECK(notesOn(readMshSpacing, kNodes2 + triangle + data("T")).empty());
}

TEST_CASE("Meshes as domains: values of nodes and elements are left out, with a note in every format that has them") {
    const std::string head = kNodes2 + "$Elements\n2\n1 2 2 7 1 1 2 3\n2 2 2 7 1 1 3 4\n$EndElements\n";
    const std::string msh = head + "$NodeData\n1\n\"heat\"\n1\n0\n3\n0\n1\n4\n1 1\n2 1\n3 2\n4 2\n$EndNodeData\n"
                                   "$ElementData\n1\n\"flux\"\n1\n0\n3\n0\n1\n2\n1 3\n2 4\n$EndElementData\n";
    const std::string vtk =
        "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n0 0 0\n"
        "1 0 0\n0 1 0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\nPOINT_DATA 3\nSCALARS heat double 1\n"
        "LOOKUP_TABLE default\n1\n2\n3\nCELL_DATA 1\nSCALARS flux double 1\nLOOKUP_TABLE default\n3\n";
    const std::string vtu =
        "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"3\" "
        "NumberOfCells=\"1\"><PointData>"
        "<DataArray type=\"Float64\" Name=\"heat\">1 2 3</DataArray></PointData><CellData><DataArray type=\"Float64\" "
        "Name=\"flux\">3</DataArray></CellData><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\">0 0 0 1 0 "
        "0 0 1 "
        "0</DataArray></Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\">0 1 2</DataArray><DataArray "
        "type=\"Int32\" Name=\"offsets\">3</DataArray><DataArray type=\"UInt8\" "
        "Name=\"types\">5</DataArray></Cells></Piece>"
        "</UnstructuredGrid></VTKFile>";
    const auto notesOf = [](const std::string &name, const std::string &text) {
        ImportNotes notes;
        const Result<DomainFile> read = readDomain(MemoryFile{text, name}, {}, &notes);
        REQUIRE_MESSAGE(read.ok(), messages(read.faults()));
        CHECK(read->domain.segments.size() >= 3);
        std::string list;
        for (const ImportNote &note : notes.entries()) {
            list += note.code + ": " + note.message + '\n';
        }
        return list;
    };
    const std::string expected = "dropped-fields: values of nodes and elements are left out: 'heat', 'flux'\n";
    CHECK(notesOf("msh2", msh) == expected);
    CHECK(notesOf("vtk", vtk) == expected);
    CHECK(notesOf("vtu", vtu) == expected);
    CHECK(notesOf("msh2", head).empty());
}

TEST_CASE("Abaqus: elements outside every set share no tag with a set") {
    const std::string nodes = "*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n";
    Result<Mesh> mesh = error("unread", "not read yet");
    CHECK(notesOn(readAbaqus,
                  nodes + "*ELEMENT, TYPE=T3D2\n8, 1, 2\n*ELEMENT, TYPE=T3D2, ELSET=wall\n9, 2, 3\n"
                          "*ELEMENT, TYPE=CPS3\n1, 1, 2, 3\n2, 1, 3, 4\n*ELSET, ELSET=steel\n2\n",
                  &mesh)
              .empty());
    REQUIRE(mesh->blocks.front().regions.size() == 2);
    CHECK(mesh->regionNames == std::map<std::int32_t, std::string>{{mesh->blocks.front().regions[1], "steel"}});
    CHECK(mesh->blocks.front().regions[0] != mesh->blocks.front().regions[1]);
    REQUIRE(mesh->edges.size() == 2);
    CHECK(mesh->boundaryNames == std::map<std::int32_t, std::string>{{mesh->edges[1].tag, "wall"}});
    CHECK(mesh->edges[0].tag != mesh->edges[1].tag);
    // Sets that serve a surface are no regions.
    const std::string surface = "*ELEMENT, TYPE=CPS3\n1, 1, 2, 3\n2, 1, 3, 4\n*ELSET, ELSET=_s_S1, INTERNAL\n1\n"
                                "*SURFACE, NAME=s, TYPE=ELEMENT\n_s_S1, S1\n";
    CHECK(notesOn(readAbaqus, nodes + surface, &mesh).empty());
    CHECK(mesh->regionNames.empty());
    CHECK(mesh->blocks.front().regions == std::vector<std::int32_t>{1, 1});
    CHECK(mesh->edges.size() == 1);
}

TEST_CASE("Abaqus: sets that are not used, or overrule each other, are noted") {
    const std::string nodes = "*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n";
    const std::string plain = "*ELEMENT, TYPE=CPS3\n1, 1, 2, 3\n2, 1, 3, 4\n";
    CHECK(notesOn(readAbaqus, nodes + plain + "*ELSET, ELSET=a\n1, 2\n*ELSET, ELSET=b\n2\n") == "element-set 1\n");
    CHECK(notesOn(readAbaqus, nodes + "*ELEMENT, TYPE=CPS3, ELSET=own\n1, 1, 2, 3\n*ELSET, ELSET=a\n1\n") ==
          "element-set 1\n");
    CHECK(notesOn(readAbaqus, nodes + plain + "*ELEMENT, TYPE=T3D2\n7, 1, 2\n*ELSET, ELSET=line\n7\n") ==
          "element-set 1\n");
    CHECK(notesOn(readAbaqus, nodes + plain + "*NSET, NSET=fixed\n1, 4\n*NSET, NSET=free\n2\n") == "node-set 2\n");
    CHECK(notesOn(readAbaqus, written(writeAbaqus, twoRegionMesh())).empty()); // what we write is read as a whole
}

TEST_CASE("OBJ: all points of a statement are read; further values of vertices are noted; comments are comments") {
    Result<Mesh> mesh = error("unread", "not read yet");
    const std::string text = "# tag along\nv 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\ng fixed\np 1 2 -1\n";
    CHECK(notesOn(readObj, text, &mesh) == "vertex-values 3\n");
    REQUIRE(mesh->points.size() == 3);
    CHECK(mesh->points[2].node == NodeId{2});
}

TEST_CASE("Netgen: sections that are not used are noted") {
    CHECK(notesOn(readNetgen,
                  "mesh3d\ndimension\n2\ngeomtype\n0\nsurfaceelements\n1\n1 1 0 0 3 1 2 3\npoints\n3\n0 0 0\n"
                  "1 0 0\n0 1 0\ncd2names\n1\n1 corner\nface_colours\n0\nidentifications\n1\n1 2 1\nendmesh\n") ==
          "section 1\nsection 1\n");
}

TEST_CASE("Triangle: attributes and labels that are not used are noted; comments are comments") {
    const auto notesOnParts = [](const std::string &nodes, const std::string &elements) {
        ImportNotes notes;
        SourceText ofNodes = sourceOf(nodes), ofElements = sourceOf(elements);
        ofNodes.notes = ofElements.notes = &notes;
        const Result<Mesh> mesh = readTriangleParts(ofNodes, ofElements, nullptr);
        REQUIRE_MESSAGE(mesh.ok(), messages(mesh.faults()));
        std::string list;
        for (const ImportNote &note : notes.entries()) {
            list += note.code + ' ' + std::to_string(note.count) + '\n';
        }
        return list;
    };
    CHECK(notesOnParts("3 2 1 1\n1 0 0 5 1\n2 1 0 5 7\n3 0 1 5 0\n# point cloud of the site\n",
                       "1 3 2\n1 1 2 3 4 0.5\n") == "node-attributes 3\nattributes 1\nnode-markers 1\n");
    CHECK(notesOnParts("3 2 0 1\n1 0 0 1\n2 1 0 1\n3 0 1 0\n", "1 3 0\n1 1 2 3\n").empty());
    const TemporaryFolder folder;
    REQUIRE(writeMesh(folder / "a.node", twoRegionMesh(), "triangle").empty());
    ImportNotes notes;
    REQUIRE(readMesh(folder / "a.node", {}, &notes).ok());
    CHECK(notes.empty()); // what we write is read as a whole
    // A file of edges that cannot be read is not passed over.
    std::filesystem::remove(folder / "a.edge");
    std::filesystem::create_directory(folder / "a.edge");
    CHECK_FALSE(readMesh(folder / "a.node").ok());
}

TEST_CASE("MEDIT: references of vertices that no edge or point has are noted") {
    const std::string text = "MeshVersionFormatted 2\nDimension 2\nVertices 3\n0 0 8\n1 0 4\n0 1 0\nEdges 1\n1 2 4\n"
                             "Triangles 1\n1 2 3 1\nEnd\n";
    CHECK(notesOn(readMedit, text) == "vertex-references 1\n");
    CHECK(notesOn(readMedit, written(writeMedit, twoRegionMesh())).empty());
}
