#include "core/files/abaqus/abaqus.hpp"
#include "core/files/common/cell_sets.hpp"
#include "core/files/dxf/dxf_write.hpp"
#include "core/files/esri/esri_grid.hpp"
#include "core/files/femm/femm.hpp"
#include "core/files/format.hpp"
#include "core/files/geotiff/geotiff.hpp"
#include "core/files/gmsh/gmsh.hpp"
#include "core/files/hydro/hydro.hpp"
#include "core/files/hydro/selafin.hpp"
#include "core/files/medit/medit.hpp"
#include "core/files/mfem/mfem.hpp"
#include "core/files/nastran/nastran.hpp"
#include "core/files/netgen/netgen.hpp"
#include "core/files/obj/obj.hpp"
#include "core/files/openfoam/openfoam.hpp"
#include "core/files/png/png.hpp"
#include "core/files/points/points.hpp"
#include "core/files/sms/two_dm.hpp"
#include "core/files/su2/su2.hpp"
#include "core/files/surfaces/surfaces.hpp"
#include "core/files/svg/svg_picture.hpp"
#include "core/files/triangle/triangle.hpp"
#include "core/files/ugrid/ugrid.hpp"
#include "core/files/unv/unv.hpp"
#include "core/files/vtk/vtk.hpp"
#include "core/files/water_formats.hpp"
#include "core/files/xdmf/xdmf.hpp"

#include <array>

namespace forefront {
namespace {

constexpr const char *kGroups = "Keeps regions, boundary parts and points as physical groups, with their names.";
constexpr const char *kVtuData =
    "Keeps regions, boundary parts and points as their numbers in the cell arrays region and boundary, with boundary "
    "edges and points as cells of their own; their names are field data, one array for each name.";
constexpr const char *kVtkData =
    "Keeps regions, boundary parts and points as their numbers in the cell arrays region, boundary and MaterialID, "
    "with boundary edges and points as cells of their own; their names are those of look-up tables.";

/// Returns the common description of all Gmsh formats.
constexpr Format gmsh(const char *id, const char *name, const char *program,
                      void (*writeWith)(const MeshView &, const ExportOptions &, TextWriter &)) {
    return {.about = {.id = id,
                      .name = name,
                      .extension = ".msh",
                      .readsDomain = true,
                      .readsMesh = true,
                      .writesMesh = true,
                      .readsSpacing = true,
                      .readsFields = true,
                      .holds = kAllCells,
                      .tellsTagsApart = true,
                      .holdsElevations = true,
                      .namesUnit = true,
                      .program = program,
                      .keeps = kGroups},
            .recognise = looksLikeMsh,
            .readMesh = readMsh,
            .readSpacing = readMshSpacing,
            .readFields = readMshFields,
            .writeWith = writeWith,
            .noteChanges = [](const MeshView &mesh) { return noteMshChanges(mesh, false); },
            .noteKeptChanges = [](const MeshView &mesh) { return noteMshChanges(mesh, true); }};
}

/// Returns `format` as one that holds extruded meshes too, written by `write`.
constexpr Format withSolids(Format format, void (*write)(const SolidMesh &, TextWriter &)) {
    format.about.holdsSolids = true;
    format.writeSolid = write;
    return format;
}

// Every format with its name, its capabilities and its functions.
constexpr std::array kFormats = {
    Format{.about = {.id = "poly",
                     .name = "Triangle domain",
                     .extension = ".poly",
                     .kind = FileKind::Domain,
                     .readsDomain = true},
           .readDomain = readPoly,
           .filesBeside = filesBesidePoly},
    Format{.about = {.id = "femm",
                     .name = "FEMM problem",
                     .extension = ".fem",
                     .otherExtensions = ".fee .feh .fec",
                     .kind = FileKind::Domain,
                     .readsDomain = true,
                     .readsCurves = true},
           .recognise = looksLikeFemm,
           .readDomain = readFemm},
    Format{.about = {.id = "csv",
                     .name = "table of points (CSV)",
                     .extension = ".csv",
                     .otherExtensions = ".xy",
                     .kind = FileKind::Domain,
                     .readsDomain = true},
           .readDomain = readCsv},
    Format{.about = {.id = "airfoil",
                     .name = "airfoil (Selig, Lednicer)",
                     .extension = ".dat",
                     .kind = FileKind::Domain,
                     .readsDomain = true},
           .readDomain = readAirfoil},
    Format{.about = {.id = "svg",
                     .name = "SVG drawing",
                     .extension = ".svg",
                     .kind = FileKind::Drawing,
                     .writesMesh = true,
                     .holds = kAllCells,
                     .namesUnit = true,
                     .keeps = "A drawing of the mesh; cannot be read back as a mesh."},
           .writeWith = writeSvgWith},
    Format{.about = {.id = "dxf",
                     .name = "DXF drawing",
                     .extension = ".dxf",
                     .kind = FileKind::CadDrawing,
                     .writesMesh = true,
                     .holds = kFirstOrder,
                     .namesUnit = true,
                     .keeps = "Keeps elements as faces, boundary parts as polylines and points, each on the layer of "
                              "its name. Read back, the polylines are a drawing."},
           .writeWith = writeDxfWith,
           .noteChanges = noteDxfChanges},
    Format{.about = {.id = "dxf-outline",
                     .name = "DXF drawing, outline",
                     .extension = ".dxf",
                     .kind = FileKind::CadDrawing,
                     .writesMesh = true,
                     .holds = kAllCells,
                     .dropsRegionNames = true,
                     .namesUnit = true,
                     .keeps = "Keeps boundary parts as polylines with arcs, and points, on the layers of their names; "
                              "elements are left out."},
           .writeWith = writeDxfOutlineWith,
           .noteChanges = noteDxfChanges},
    withSolids(gmsh("msh2", "Gmsh MSH 2.2", "", writeMsh2With), writeMsh2Solid),
    gmsh("msh41", "Gmsh MSH 4.1", "Gmsh", writeMsh4With),
    gmsh("msh41-binary", "Gmsh MSH 4.1, binary", "", writeMsh4BinaryWith),
    Format{.about = {.id = "vtu",
                     .name = "VTK unstructured grid",
                     .extension = ".vtu",
                     .readsDomain = true,
                     .readsMesh = true,
                     .writesMesh = true,
                     .readsFields = true,
                     .holds = kAllCells,
                     .holdsSolids = true,
                     .holdsElevations = true,
                     .program = "ParaView",
                     .keeps = kVtuData},
           .recognise = looksLikeVtu,
           .readMesh = readVtu,
           .readFields = readVtuFields,
           .writeMesh = writeVtu,
           .writeSolid = writeVtuSolid},
    Format{.about = {.id = "vtk",
                     .name = "VTK legacy",
                     .extension = ".vtk",
                     .readsDomain = true,
                     .readsMesh = true,
                     .writesMesh = true,
                     .readsFields = true,
                     .holds = kAllCells,
                     .keeps = kVtkData},
           .recognise = looksLikeVtk,
           .readMesh = readVtk,
           .readFields = readVtkFields,
           .writeMesh = writeVtk},
    Format{.about = {.id = "xdmf",
                     .name = "XDMF with HDF5",
                     .extension = ".xdmf",
                     .otherExtensions = ".xmf",
                     .readsDomain = true,
                     .readsMesh = true,
                     .writesMesh = true,
                     .readsFields = true,
                     .holds = kAllCells,
                     .holdsElevations = true,
                     .files = kXdmfExtensions,
                     .component = "hdf5",
                     .program = "FEniCSx",
                     .keeps = "Writes .xdmf and .h5. Keeps regions, boundary parts and points as numbers in the arrays "
                              "region, boundary and points of the grids mesh, boundary and points, and their names as "
                              "information."},
           .recognise = looksLikeXdmf,
           .readMesh = readXdmf,
           .readFields = readXdmfFields,
           .writeFiles = writeXdmf},
    Format{.about = {.id = "medit",
                     .name = "MEDIT",
                     .extension = ".mesh",
                     .readsDomain = true,
                     .readsMesh = true,
                     .writesMesh = true,
                     .holds = kMeditCells,
                     .holdsSolids = true,
                     .program = "FreeFem++",
                     .keeps = "Keeps the numbers of regions, boundary parts and points, for readmesh; names only as "
                              "comments."},
           .recognise = looksLikeMedit,
           .readMesh = readMedit,
           .writeMesh = writeMedit,
           .writeSolid = writeMeditSolid},
    Format{.about = {.id = "mfem",
                     .name = "MFEM mesh",
                     .extension = ".mesh",
                     .readsDomain = true,
                     .readsMesh = true,
                     .writesMesh = true,
                     .holds = kAllCells,
                     .keeps = "Keeps the numbers of regions and boundary parts as attributes; names and points only as "
                              "comments. Second order is a grid function of H1_2D_P2, so quadrilaterals of 8 nodes get "
                              "their centre, and in a mesh with both orders all elements are of second order."},
           .recognise = looksLikeMfem,
           .readMesh = readMfem,
           .writeMesh = writeMfem},
    Format{.about = {.id = "inp",
                     .name = "Abaqus and CalculiX",
                     .extension = ".inp",
                     .readsDomain = true,
                     .readsMesh = true,
                     .writesMesh = true,
                     .holds = kAbaqusCells,
                     .holdsSolids = true,
                     .namesUnit = true,
                     .program = "Abaqus, CalculiX",
                     .keeps = "Keeps regions as element sets, boundary parts as node sets NAME and surfaces S_NAME, "
                              "points as node sets, all with names that the solver accepts; NALL and EALL hold all "
                              "nodes and elements. Elements are CPS3, CPS4, CPS6 and CPS8, of solids C3D6 and C3D8. A "
                              "job reads the file by *INCLUDE."},
           .recognise = looksLikeAbaqus,
           .readMesh = readAbaqus,
           .writeWith = writeAbaqusWith,
           .noteChanges = noteAbaqusChanges,
           .writeSolid = writeAbaqusSolid},
    Format{.about = {.id = "su2",
                     .name = "SU2",
                     .extension = ".su2",
                     .readsDomain = true,
                     .readsMesh = true,
                     .writesMesh = true,
                     .holds = kFirstOrder,
                     .acceptsInnerEdges = false,
                     .program = "SU2",
                     .keeps = "Keeps boundary parts as markers, with their names; regions and points only as "
                              "comments."},
           .recognise = looksLikeSu2,
           .readMesh = readSu2,
           .writeMesh = writeSu2,
           .noteChanges = noteSu2Changes},
    Format{.about = {.id = "unv",
                     .name = "I-DEAS UNV",
                     .extension = ".unv",
                     .readsDomain = true,
                     .readsMesh = true,
                     .writesMesh = true,
                     .holds = kEightNodes,
                     .holdsSolids = true,
                     .keeps = "Keeps regions and boundary parts as permanent groups of elements, points as groups of "
                              "nodes, with names made identifiers."},
           .recognise = looksLikeUnv,
           .readMesh = readUnv,
           .writeMesh = writeUnv,
           .noteChanges = noteUnvChanges,
           .writeSolid = writeUnvSolid},
    Format{.about = {.id = "nastran",
                     .name = "Nastran bulk data",
                     .extension = ".bdf",
                     .otherExtensions = ".nas",
                     .readsDomain = true,
                     .readsMesh = true,
                     .writesMesh = true,
                     .holds = kEightNodes,
                     .holdsSolids = true,
                     .keeps = "Keeps regions as properties of elements, boundary parts as properties of rods (CROD); "
                              "names and points only as comments. Coordinates have at most 16 characters."},
           .recognise = looksLikeNastran,
           .readMesh = readNastran,
           .writeMesh = writeNastran,
           .noteChanges = noteNastranChanges,
           .writeSolid = writeNastranSolid},
    Format{.about = {.id = "openfoam",
                     .name = "OpenFOAM polyMesh",
                     .extension = ".foam",
                     .writesMesh = true,
                     .counterClockwise = true,
                     .holds = kFirstOrder,
                     .holdsSolids = true,
                     .solidsOnly = true,
                     .folder = kFoamFiles,
                     .program = "OpenFOAM",
                     .keeps = "Writes a folder with constant/polyMesh, one cell thick unless extruded further. Keeps "
                              "boundary parts as patches, regions as cell zones, tagged edges inside as face zones, "
                              "with names made identifiers; points are left out. Cannot be read back."},
           .noteChanges = noteOpenFoamChanges,
           .writeFiles = writeOpenFoam},
    Format{.about = {.id = "2dm",
                     .name = "SMS 2DM",
                     .extension = ".2dm",
                     .readsDomain = true,
                     .readsMesh = true,
                     .writesMesh = true,
                     .readsFields = true,
                     .holds = kAllCells,
                     .holdsElevations = true,
                     .keeps =
                         "Keeps regions as materials, boundary parts as node strings with their numbers; names and "
                         "points only as comments, elevations as z."},
           .recognise = looksLikeTwoDm,
           .readMesh = readTwoDm,
           .readFields = readTwoDmFields,
           .writeMesh = writeTwoDm,
           .noteChanges = noteTwoDmChanges},
    kAdcircFormat,
    kSchismFormat,
    Format{.about = {.id = "selafin",
                     .name = "TELEMAC SELAFIN",
                     .extension = ".slf",
                     .writesMesh = true,
                     .counterClockwise = true,
                     .holds = kTriangleGrid,
                     .acceptsInnerEdges = false,
                     .dropsBoundaryNames = true,
                     .dropsRegionNames = true,
                     .hasOpenBoundaries = true,
                     .holdsElevations = true,
                     .files = kSelafinExtensions,
                     .program = "TELEMAC",
                     .keeps =
                         "Writes .slf, in single precision, and .cli. Keeps triangles, elevations as BOTTOM, and the "
                         "boundary as walls (2 2 2) and open parts with a prescribed level (5 4 4); regions, names "
                         "and points are left out. Cannot be read back."},
           .noteChanges = noteSelafinChanges,
           .writeFiles = writeSelafin},
    Format{.about = {.id = "ugrid",
                     .name = "UGRID netCDF",
                     .extension = ".nc",
                     .writesMesh = true,
                     .counterClockwise = true,
                     .holds = kFirstOrder,
                     .holdsElevations = true,
                     .namesUnit = true,
                     .program = "Delft3D FM",
                     .keeps =
                         "Keeps elements as faces, elevations, and the numbers of regions and boundary parts, with "
                         "their names as meanings; points are left out. Cannot be read back."},
           .writeWith = writeUgrid,
           .noteChanges = noteUgridChanges},
    Format{.about = {.id = "mike",
                     .name = "MIKE mesh",
                     .extension = ".mesh",
                     .writesMesh = true,
                     .counterClockwise = true,
                     .holds = kFirstOrder,
                     .dropsInnerEdges = true,
                     .dropsBoundaryNames = true,
                     .dropsRegionNames = true,
                     .hasOpenBoundaries = true,
                     .holdsElevations = true,
                     .saysMetres = true,
                     .program = "MIKE 21 FM",
                     .keeps =
                         "Keeps elements, elevations, and the boundary as codes of nodes: 1 land, 2 and more the open "
                         "parts in their order; regions, names and points are left out. Cannot be read back."},
           .writeWith = writeMike,
           .noteChanges = noteDepths},
    Format{.about = {.id = "anuga",
                     .name = "ANUGA mesh",
                     .extension = ".tsh",
                     .writesMesh = true,
                     .counterClockwise = true,
                     .holds = kTriangleGrid,
                     .acceptsInnerEdges = false,
                     .holdsElevations = true,
                     .program = "ANUGA",
                     .keeps =
                         "Keeps triangles, elevations, regions and boundary parts with names made identifiers; points "
                         "are left out. Cannot be read back."},
           .writeMesh = writeAnuga,
           .noteChanges = noteAnugaChanges},
    Format{.about = {.id = "triangle",
                     .name = "Triangle .node/.ele/.edge",
                     .extension = ".node",
                     .otherExtensions = ".ele",
                     .readsDomain = true,
                     .readsMesh = true,
                     .writesMesh = true,
                     .holds = kTriangleCells,
                     .keepsCreation = true,
                     .oneElementKind = true,
                     .files = kTriangleExtensions,
                     .program = "Triangle",
                     .keeps = "Writes .node, .ele and .edge. Keeps boundary numbers as markers and regions as an "
                              "attribute."},
           .readMesh = readTriangle,
           .writeFiles = writeTriangle},
    Format{.about = {.id = "netgen",
                     .name = "Netgen",
                     .extension = ".vol",
                     .readsDomain = true,
                     .readsMesh = true,
                     .holds = kEightNodes},
           .recognise = looksLikeNetgen,
           .readMesh = readNetgen},
    Format{.about = {.id = "obj",
                     .name = "Wavefront OBJ",
                     .extension = ".obj",
                     .readsDomain = true,
                     .readsMesh = true,
                     .writesMesh = true,
                     .holds = kFirstOrder,
                     .keeps = "Keeps regions and boundary parts as groups, with their names."},
           .readMesh = readObj,
           .writeMesh = writeObj,
           .noteChanges = noteObjChanges},
    Format{.about = {.id = "ply",
                     .name = "Polygon file PLY",
                     .extension = ".ply",
                     .writesMesh = true,
                     .holds = kFirstOrder,
                     .dropsInnerEdges = true,
                     .dropsBoundaryNames = true,
                     .dropsRegionNames = true,
                     .holdsElevations = true,
                     .keeps = "Keeps elements as faces with the number of their region; boundary and points are left "
                              "out. Cannot be read back."},
           .writeMesh = writePly,
           .noteChanges = noteFlatSurface},
    Format{.about = {.id = "stl",
                     .name = "Stereolithography STL",
                     .extension = ".stl",
                     .writesMesh = true,
                     .holds = kTriangleGrid,
                     .dropsInnerEdges = true,
                     .dropsBoundaryNames = true,
                     .holdsElevations = true,
                     .keeps = "Keeps triangles, a solid for each region; boundary and points are left out. Cannot be "
                              "read back."},
           .writeMesh = writeStl,
           .noteChanges = noteStlChanges},
    Format{.about = {.id = "off",
                     .name = "Geomview OFF",
                     .extension = ".off",
                     .writesMesh = true,
                     .holds = kFirstOrder,
                     .dropsInnerEdges = true,
                     .dropsBoundaryNames = true,
                     .dropsRegionNames = true,
                     .holdsElevations = true,
                     .keeps = "Keeps elements as faces; regions, boundary and points are left out. Cannot be read "
                              "back."},
           .writeMesh = writeOff,
           .noteChanges = noteFlatSurface},
    Format{.about = {.id = "esri",
                     .name = "ESRI ASCII grid",
                     .extension = ".asc",
                     .kind = FileKind::Grid,
                     .readsSpacing = true},
           .recognise = looksLikeEsriGrid,
           .readSpacing = readEsriGrid,
           .readRaster = readEsriRaster},
    Format{.about = {.id = "geotiff",
                     .name = "GeoTIFF raster",
                     .extension = ".tif",
                     .otherExtensions = ".tiff",
                     .kind = FileKind::Grid,
                     .readsSpacing = true,
                     .component = "gdal"},
           .recognise = looksLikeTiff,
           .readSpacing = readGeoTiffSpacing,
           .readRaster = readGeoTiffRaster},
    Format{
        .about =
            {.id = "png", .name = "PNG picture", .extension = ".png", .kind = FileKind::Picture, .readsSpacing = true},
        .recognise = looksLikePng,
        .readSpacing = readPngSpacing},
};

} // namespace

const FormatList &engineFormats() {
    static constexpr FormatList kList(kFormats);
    return kList;
}

} // namespace forefront
