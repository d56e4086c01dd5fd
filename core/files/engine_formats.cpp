#include "core/files/abaqus/abaqus.hpp"
#include "core/files/esri/esri_grid.hpp"
#include "core/files/format.hpp"
#include "core/files/gmsh/gmsh.hpp"
#include "core/files/medit/medit.hpp"
#include "core/files/netgen/netgen.hpp"
#include "core/files/obj/obj.hpp"
#include "core/files/png/png.hpp"
#include "core/files/su2/su2.hpp"
#include "core/files/svg/svg_picture.hpp"
#include "core/files/triangle/triangle.hpp"
#include "core/files/vtk/vtk.hpp"

#include <array>

namespace forefront {
namespace {

constexpr CellSet kFirstOrder = {CellKind::Point, CellKind::Edge2, CellKind::Triangle3, CellKind::Quadrilateral4};
// GMF has a keyword for quadrilaterals of 9 nodes, but none for those of 8.
constexpr CellSet kMeditCells = {CellKind::Point,         CellKind::Edge2,     CellKind::Edge3,
                                 CellKind::Triangle3,     CellKind::Triangle6, CellKind::Quadrilateral4,
                                 CellKind::Quadrilateral9};
// Abaqus has no plane element of 9 nodes. Edges are sides of elements, with the middle nodes of those.
constexpr CellSet kAbaqusCells = {CellKind::Point,         CellKind::Edge2,     CellKind::Edge3,
                                  CellKind::Triangle3,     CellKind::Triangle6, CellKind::Quadrilateral4,
                                  CellKind::Quadrilateral8};
// The middle nodes of edges are those of the triangles beside them.
constexpr CellSet kTriangleCells = {CellKind::Point, CellKind::Edge2, CellKind::Edge3, CellKind::Triangle3,
                                    CellKind::Triangle6};
constexpr CellSet kNetgenCells = {CellKind::Point,         CellKind::Edge2,     CellKind::Edge3,
                                  CellKind::Triangle3,     CellKind::Triangle6, CellKind::Quadrilateral4,
                                  CellKind::Quadrilateral8};

// Every format with its name, its capabilities and its functions.
constexpr std::array kFormats = {
    Format{.about = {"poly", "Triangle domain", ".poly", true, false, false}, .readDomain = readPoly},
    Format{.about = {"svg", "SVG drawing", ".svg", false, false, true, kAllCells}, .writeMesh = writeSvg},
    Format{.about = {"msh2", "Gmsh MSH 2.2", ".msh", true, true, true, kAllCells},
           .recognise = looksLikeMsh,
           .readMesh = readMsh,
           .readSpacing = readMshSpacing,
           .readFields = readMshFields,
           .writeMesh = writeMsh2,
           .noteChanges = noteMshChanges},
    Format{.about = {"msh41", "Gmsh MSH 4.1", ".msh", true, true, true, kAllCells},
           .recognise = looksLikeMsh,
           .readMesh = readMsh,
           .readSpacing = readMshSpacing,
           .readFields = readMshFields,
           .writeMesh = writeMsh4,
           .noteChanges = noteMshChanges},
    Format{.about = {"msh41-binary", "Gmsh MSH 4.1, binary", ".msh", true, true, true, kAllCells},
           .recognise = looksLikeMsh,
           .readMesh = readMsh,
           .readSpacing = readMshSpacing,
           .readFields = readMshFields,
           .writeMesh = writeMsh4Binary,
           .noteChanges = noteMshChanges},
    Format{.about = {"vtu", "VTK unstructured grid", ".vtu", true, true, true, kAllCells},
           .recognise = looksLikeVtu,
           .readMesh = readVtu,
           .readFields = readVtuFields,
           .writeMesh = writeVtu},
    Format{.about = {"vtk", "VTK legacy", ".vtk", true, true, true, kAllCells},
           .recognise = looksLikeVtk,
           .readMesh = readVtk,
           .readFields = readVtkFields,
           .writeMesh = writeVtk},
    Format{.about = {"medit", "MEDIT", ".mesh", true, true, true, kMeditCells},
           .recognise = looksLikeMedit,
           .readMesh = readMedit,
           .writeMesh = writeMedit},
    Format{.about = {"inp", "Abaqus and CalculiX", ".inp", true, true, true, kAbaqusCells},
           .recognise = looksLikeAbaqus,
           .readMesh = readAbaqus,
           .writeMesh = writeAbaqus,
           .noteChanges = noteAbaqusChanges},
    Format{.about = {"su2", "SU2", ".su2", true, true, true, kFirstOrder, false, false},
           .recognise = looksLikeSu2,
           .readMesh = readSu2,
           .writeMesh = writeSu2,
           .noteChanges = noteSu2Changes},
    Format{.about = {"triangle", "Triangle .node/.ele/.edge", ".node", true, true, true, kTriangleCells, false, true,
                     true},
           .otherExtensions = ".ele",
           .readMesh = readTriangle,
           .writeFiles = writeTriangle},
    Format{.about = {"netgen", "Netgen", ".vol", true, true, false, kNetgenCells},
           .recognise = looksLikeNetgen,
           .readMesh = readNetgen},
    Format{.about = {"obj", "Wavefront OBJ", ".obj", true, true, true, kFirstOrder},
           .readMesh = readObj,
           .writeMesh = writeObj,
           .noteChanges = noteObjChanges},
    Format{.about = {"esri", "ESRI ASCII grid", ".asc", false, false, false},
           .recognise = looksLikeEsriGrid,
           .readSpacing = readEsriGrid},
    Format{.about = {"png", "PNG picture", ".png", false, false, false},
           .recognise = looksLikePng,
           .readSpacing = readPngSpacing},
};

} // namespace

const FormatList &engineFormats() {
    static constexpr FormatList kList(kFormats);
    return kList;
}

} // namespace forefront
