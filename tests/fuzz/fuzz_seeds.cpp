#include "core/drawing_files/project/project.hpp"
#include "core/files/files.hpp"
#include "core/files/gmsh/gmsh.hpp"
#include "core/files/text/base64.hpp"
#include "tests/fuzz/fuzz_runs.hpp"
#include "tests/fuzz/fuzz_targets.hpp"
#include "tests/support/png_sample.hpp"

#include <map>
#include <random>
#include <span>
#include <vector>

namespace forefront::fuzz {

namespace {

/// Two triangles of different regions with every kind of tag.
TriMesh smallMesh() {
    const auto node = [](std::uint32_t n) { return NodeId{n}; };
    TriMesh mesh;
    mesh.nodes = {{0, 0}, {1, 0.25}, {1, 1}, {-0.5, 1}};
    mesh.elements = {{node(0), node(1), node(2)}, {node(0), node(2), node(3)}};
    mesh.regions = {1, 3};
    mesh.edges = {{node(0), node(1), 1}, {node(1), node(2), 2}, {node(0), node(2), 7}};
    mesh.points = {{node(3), 4}};
    mesh.boundaryNames = {{1, "in let"}, {7, "inner"}};
    mesh.regionNames = {{3, "sea"}};
    return mesh;
}

/// A triangle and a quadrilateral side by side, of second order if `middles`: then that has a node in its centre, too,
/// if `centre`.
Mesh smallCells(bool middles, bool centre = false) {
    const auto node = [](std::uint32_t n) { return NodeId{n}; };
    Mesh mesh;
    mesh.nodes = {{0, 0}, {2, 0},    {2, 2}, {0, 2},     {3, 1},     {1, 0},
                  {2, 1}, {1, 2.25}, {0, 1}, {2.5, 0.5}, {2.5, 1.5}, {1, 1}};
    const std::vector<NodeId> triangle = {node(1), node(4), node(2), node(9), node(10), node(6)};
    const std::vector<NodeId> quadrilateral = {node(0), node(1), node(2), node(3), node(5),
                                               node(6), node(7), node(8), node(11)};
    mesh.nodes.resize(!middles ? 5 : centre ? 12 : 11);
    const auto add = [&](CellKind kind, const std::vector<NodeId> &nodes, std::int32_t region) {
        mesh.block(kind).add(std::span(nodes).first(traitsOf(kind).nodes));
        mesh.block(kind).regions.push_back(region);
    };
    add(middles ? CellKind::Triangle6 : CellKind::Triangle3, triangle, 3);
    add(!middles ? CellKind::Quadrilateral4
        : centre ? CellKind::Quadrilateral9
                 : CellKind::Quadrilateral8,
        quadrilateral, 1);
    mesh.edges = {{node(0), node(1), 1, middles ? node(5) : kNoNode},
                  {node(1), node(2), 7, middles ? node(6) : kNoNode}};
    mesh.points = {{node(3), 4}};
    mesh.boundaryNames = {{1, "in let"}};
    mesh.regionNames = {{3, "sea"}};
    return mesh;
}

std::string text(void (*write)(const MeshView &, TextWriter &), const MeshView &mesh = smallMesh()) {
    StringSink sink;
    TextWriter out(sink);
    write(mesh, out);
    out.flush();
    return std::move(sink.text);
}

Document smallDocument() {
    Document document;
    Shape shape;
    shape.id = 1;
    shape.nodes = {{0, 0}, {4, 0}, {0, 3}};
    shape.segmentTags = {1, 2, 1};
    shape.name = "a";
    document.shapes.push_back(std::make_shared<const Shape>(shape));
    shape.id = 2;
    shape.nodes = {{5, 0}, {7, 0}, {7, 2}};
    shape.path().curves = {
        Curve::arc({6, 0}, {-1, 0}, {0, -1}, 0.0, 3.141592653589793), Curve::cubic({7, 0}, {8, 0}, {8, 2}, {7, 2}), {}};
    shape.cuts = {{0.5}, {0.25, 0.75}, {}};
    document.shapes.push_back(std::make_shared<const Shape>(shape));
    Shape box;
    box.id = 3;
    box.form = RectangleForm{};
    box.nodes = {{10, 0}, {12, 3}};
    box.as<RectangleForm>().radius = 0.5;
    document.shapes.push_back(std::make_shared<const Shape>(box));
    box.id = 4;
    box.form = EllipseForm{};
    box.nodes = {{15, 1}, {17, 1}, {15, 2}};
    document.shapes.push_back(std::make_shared<const Shape>(box));
    const auto constrain = [&document](ConstraintKind kind, std::vector<SketchPart> parts, double value = 0.0) {
        SketchConstraint constraint{document.nextId++, kind, "c", std::move(parts), value, -1, 1, 90};
        document.constraints.push_back(std::make_shared<const SketchConstraint>(std::move(constraint)));
    };
    document.nextId = 5;
    constrain(ConstraintKind::Horizontal, {{1, SketchPartKind::Segment, 0}});
    constrain(ConstraintKind::OnCurve, {{1, SketchPartKind::Node, 1}, {4, SketchPartKind::Segment, 0}});
    constrain(ConstraintKind::Radius, {{2, SketchPartKind::Segment, 0}}, 1.0);
    document.formulas = {{{NumberOwner::ofConstraint(7), Quantity::Value}, "1"}};
    document.regionMarkers = {{{1, 1}, 2, 0.5, 0.25, 0.1}};
    document.boundaryNames = {{2, "b"}};
    document.spacing.size = 0.1;
    document.spacing.expression = "0.1+x*x";
    document.spacing.sources = {{SourceShape::Line, {0, 0}, {1, 1}, 0.0, 0.1, 0.2, "s"},
                                {SourceShape::Box, {0, 0}, {1, 1}, 0.0, 0.1, 0.2, "", {}, 30.0}};
    PaintedSpacing::Tile tile{};
    tile[3] = 0.5F;
    document.spacing.paint.tiles.emplace(std::pair(0, -1), std::make_shared<const PaintedSpacing::Tile>(tile));
    document.spacing.background =
        std::make_shared<const BackgroundMesh>(BackgroundMesh{{{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}}, {1, 2, 3}});
    return document;
}

const char *const kValues = "$NodeData\n1\n\"size\"\n1\n0\n3\n0\n1\n4\n1 0.1\n2 0.2\n3 0.3\n4 0.4\n$EndNodeData\n";
const char *const kElementValues = "$ElementData\n1\n\"flux\"\n1\n0\n3\n0\n1\n2\n4 0.5\n5 -1\n$EndElementData\n";
const char *const kGeoJson =
    "{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"properties\":{\"name\":\"a\",\"tag\":2},"
    "\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[4,0],[4,4],[0,0]],[[2,1],[3,1],[3,2],[2,1]]]}},"
    "{\"type\":\"Feature\",\"geometry\":{\"type\":\"MultiPoint\",\"coordinates\":[[1,0.5,9]]}}]}";
const char *const kTopoJson =
    "{\"type\":\"Topology\",\"transform\":{\"scale\":[0.5,1],\"translate\":[1,2]},\"arcs\":[[[2,0],[0,3]],[[2,3],[-2,0]"
    ",[0,-3],"
    "[2,0]],[[2,0],[2,0],[0,3],[-2,0]],[[1,1],[0,1],[-1,0],[1,-1]]],\"objects\":{\"a\":{\"type\":"
    "\"GeometryCollection\","
    "\"geometries\":[{\"type\":\"Polygon\",\"properties\":{\"name\":\"w\",\"tag\":3},\"arcs\":[[0,1],[3]]},{\"type\":"
    "\"MultiPolygon\",\"arcs\":[[[2,-1]]]},{\"type\":\"LineString\",\"arcs\":[2]},{\"type\":\"Point\",\"coordinates\":["
    "1,1]},"
    "{\"type\":null}]},\"b\":{\"type\":\"MultiLineString\",\"arcs\":[[-2]]}}}";
const char *const kSvg =
    "<svg viewBox=\"0 0 9 9\"><g transform=\"rotate(30 5 5) scale(2) skewX(3) matrix(1 0 0 1 2 2)\">"
    "<path id=\"a\" d=\"M1 1h2v2C3 3 2 4 1 3zM6,6a1 2 30 1 0 1 1Q7 7 8 6t1 1s1 2 3 4z\"/></g>"
    "<circle r=\"2mm\"/><rect width=\"3\" height=\"2\" rx=\".5\"/><polyline points=\"1 2 3 4\"/></svg>";
const char *const kStyledSvg =
    "<svg width=\"20mm\" viewBox=\"0 0 9 9\"><style>/* c */ .a, rect#b { display: none } @media x { g { fill: red } }"
    "</style><symbol id=\"s\" viewBox=\"0 0 2 2\"><path class=\"a\" d=\"M0 0h2v2z\"/><rect width=\"50%\" height=\"1\"/>"
    "</symbol><use id=\"u\" href=\"#s\" x=\"1\" width=\"3\" height=\"2\"/><g id=\"r\"><use href=\"#u\" y=\"4\"/></g>"
    "<switch><g requiredExtensions=\"x\"/><line x2=\"3\" style=\"visibility : hidden\"/></switch>"
    "<line x1=\"5\" x2=\"6\" y2=\"1\"/><text>t</text></svg>";
const char *const kClippedSvg =
    "<svg viewBox=\"0 0 9 9\"><clipPath id=\"c\" clip-path=\"url(#d)\" clip-rule=\"evenodd\"><path d=\"M0 0h6v6h-6zM2 "
    "2h2v2z\"/>"
    "<use href=\"#r\" x=\"1\"/></clipPath><clipPath id=\"d\" clipPathUnits=\"objectBoundingBox\"><circle "
    "r=\".8\"/></clipPath>"
    "<mask id=\"m\" fill=\"#fff\" x=\".1\" width=\"50%\"><use href=\"#r\"/><circle r=\"1\" fill=\"black\"/></mask>"
    "<mask id=\"a\" style=\"mask-type:alpha\" maskUnits=\"userSpaceOnUse\" maskContentUnits=\"objectBoundingBox\">"
    "<g opacity=\".3\"><path d=\"M0 0h.5v.5z\" fill=\"url(#g)\" clip-path=\"url(#c)\"/></g></mask>"
    "<rect id=\"r\" width=\"5\" height=\"4\" mask=\"url(#m)\"/><g clip-path=\"url(#c)\"><circle r=\"4\" "
    "mask=\"url(#a)\"/>"
    "<line x2=\"9\" y2=\"8\" stroke=\"rgba(1 2 3 / 4%)\"/><svg width=\"3\" height=\"3\"><rect width=\"4\" "
    "height=\"1\"/></svg>"
    "</g></svg>";
const char *const kDxf =
    "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n9\n$DWGCODEPAGE\n3\nANSI_1252\n9\n$INSUNITS\n70\n"
    "4\n0\nENDSEC\n0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nb\n70\n1\n62\n-7\n0\nENDTAB\n"
    "0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nk\n10\n1\n20\n0\n0\nCIRCLE\n8\n0\n10\n1\n20\n0\n40\n"
    ".5\n0\nINSERT\n2\nm\n41\n2\n0\nENDBLK\n0\nBLOCK\n2\nm\n0\nARC\n10\n0\n20\n0\n40\n1\n50\n0\n51\n90\n"
    "0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\na\n90\n3\n70\n1\n10\n0\n20\n0\n"
    "42\n.5\n10\n9\n20\n0\n10\n9\n20\n9\n0\nINSERT\n8\na\n2\nk\n10\n4\n20\n2\n41\n1\n42\n.5\n50\n30\n"
    "70\n2\n71\n2\n44\n1\n45\n1\n230\n-1\n0\nLINE\n8\n\\U+00e9\n10\n1\n20\n1\n30\n2\n11\n3\n21\n2\n0\n"
    "TEXT\n1\nx\n0\nENDSEC\n0\nEOF\n";
const char *const kDxfCurves =
    "0\nSECTION\n2\nENTITIES\n0\nSPLINE\n70\n9\n71\n3\n11\n0\n21\n0\n11\n4\n21\n0\n11\n4\n21\n4\n0\nSPLINE\n"
    "71\n2\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n41\n1\n41\n.7\n41\n1\n10\n1\n20\n0\n10\n1\n20\n"
    "1\n10\n0\n20\n1\n0\nSPLINE\n71\n4\n40\n0\n40\n0\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n40\n1\n"
    "40\n1\n10\n0\n20\n0\n10\n1\n20\n3\n10\n2\n20\n0\n10\n3\n20\n3\n10\n4\n20\n0\n0\nELLIPSE\n10\n5\n"
    "20\n5\n11\n2\n21\n1\n40\n.5\n41\n0\n42\n6\n0\nPOLYLINE\n66\n1\n70\n5\n0\nVERTEX\n10\n0\n20\n0\n42\n"
    "-1\n0\nVERTEX\n70\n16\n10\n3\n20\n0\n0\nVERTEX\n10\n3\n20\n3\n0\nSEQEND\n0\nENDSEC\n0\nEOF\n";
const char *const kWkt =
    "SRID=4326;POLYGON Z((0 0 1,4 0 1,4 3 1,0 0 1),(2 .5 0,3 .5 0,3 1 0,2 .5 0));MULTIPOINT((1 .2),2 .3)\n"
    "GEOMETRYCOLLECTION(LINESTRING(0 0,1 .5),MULTIPOLYGON EMPTY)";
const char *const kCsv = "\"x [m]\";y;part\n# c\n0;0;a\n4,5;0;a\n4,5;3;a\n\n1;1;b\n2;1;b\n9;9;c\n";
const char *const kLednicer = "FOIL\n 3. 3.\n\n0 0\n.5 .1\n1 0\n\n0 0\n.5 -.1\n1 0\n";
const char *const kFemm =
    "[Format] = 4.0\n[LengthUnits] = inches\n[ProblemType] = planar\n[BdryProps] = 1\n<BeginBdry>\n<BdryName> = \"a\"\n"
    "<EndBdry>\n[BlockProps] = 1\n<BeginBlock>\n<BlockName> = \"b\"\n<EndBlock>\n[NumPoints] = 3\n0 0 0 0\n4 0 0 0\n4 "
    "4 0 0\n"
    "[NumSegments] = 2\n0 1 -1 1 0 0\n1 2 .5 0 0 0\n[NumArcSegments] = 1\n2 0 90 5 1 0 0\n[NumHoles] = "
    "0\n[NumBlockLabels] = 1\n"
    "3 1 1 .5 0 0 0 1 0\n";
const char *const kLines =
    "{\"type\": \"MultiLineString\", \"crs\": {}, \"coordinates\": [[[0,0],[4,0],[4,3]],[[4,3,1],[0,3],[0,0]],"
    "[[0,0],[4,3]]]}";
const char *const kPoly = "4 2 1 1\n0 0 0 7 1\n1 4 0 7 1\n2 4 4 7 1\n3 1 0.5 0 0\n3 1\n0 0 1 3\n1 1 2 0\n2 2 0 2\n"
                          "1\n0 1.5 1.5\n1\n0 0.5 0.5 4.5 0.1\n# boundary 3 \"x\"\n";
const char *const kVtuAscii =
    "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\"><UnstructuredGrid><Piece NumberOfPoints=\"3\" "
    "NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 "
    "0</DataArray></Points><Cells><DataArray type=\"Int64\" Name=\"connectivity\">0 1 2</DataArray><DataArray "
    "type=\"Int64\" Name=\"offsets\">3</DataArray><DataArray type=\"UInt8\" Name=\"types\" format=\"binary\">"
    "AQAAAAU=</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>";
const char *const kXdmf =
    "<Xdmf Version=\"3.0\"><Domain><Information Name=\"region 4\" Value=\"sea\"/><Grid Name=\"mesh\"><Topology "
    "TopologyType=\"Mixed\"><DataItem Dimensions=\"13\">4 0 1 2 5 0 2 3 4 2 2 0 1</DataItem></Topology><Geometry "
    "GeometryType=\"XY\"><DataItem Dimensions=\"5 2\">0 0 2 0 2 1 1 2 0 1</DataItem></Geometry><Attribute "
    "Name=\"region\" Center=\"Cell\"><DataItem Dimensions=\"3\">4 5 0</DataItem></Attribute></Grid><Grid "
    "Name=\"boundary\"><Topology TopologyType=\"Polyline\"><DataItem Dimensions=\"2 2\">1 2 2 3</DataItem></Topology>"
    "<Attribute Name=\"boundary\" Center=\"Cell\"><DataItem Dimensions=\"2\">7 8</DataItem></Attribute></Grid><Grid "
    "Name=\"u\"><Attribute Name=\"u\"><DataItem Dimensions=\"5\">1 2 3 4 5.5</DataItem></Attribute></Grid>"
    "</Domain></Xdmf>";
const char *const kNetgen =
    "mesh3d\ndimension\n2\ngeomtype\n0\n\n# surfnr bcnr domin domout np p1 p2 p3\nsurfaceelements\n2\n 2 1 0 0 3 1 2 "
    "3\n"
    " 2 2 0 0 3 1 3 4\n\nvolumeelements\n0\n\nedgesegmentsgi2\n2\n 1 0 1 2 -1 -1 1 0 1 0 1 0.5\n 2 0 2 3 -1 -1 1 0 2 0 "
    "2 1\n"
    "\npoints\n4\n 0 0 0\n 1 0 0\n 1 1 0\n 0 1 0\n\npointelements\n1\n 4 3\n\nmaterials\n1\n1 sea\n\nbcnames\n2\n"
    "1 in let\n2 wall\n\nendmesh\n";
const char *const kNetgenCells =
    "mesh3d\ndimension\n2\nsurfaceelements\n4\n2 1 0 0 4 1 2 3 4\n2 1 0 0 6 1 2 3 6 8 5\n2 1 0 0 8 1 2 3 4 5 7 8 6\n"
    "2 1 0 0 3 1 2 3\nedgesegmentsgi2\n1\n1 0 1 2 -1 -1 1 0 1 0 1 0.5\npoints\n9\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n1 0 0\n2 "
    "1 "
    "0\n1 2 0\n0 1 0\n1 1 0\nendmesh\n";
const char *const kUnv =
    "    -1\n 2411\n 1 1 1 11\n 0.D+0 0 0\n 2 1 1 11\n 2 0 0\n 5 1 1 11\n 2 2 0\n 7 1 1 11\n 0 2 0\n    -1\n    -1\n "
    "2412\n"
    "1 91 3 1 7 3\n1 2 5\n2 94 4 1 7 4\n1 2 5 7\n3 21 5 1 7 2\n0 1 1\n1 2\n    -1\n    -1\n 2467\n9 0 0 0 0 0 0 2\n"
    "west side\n8 1 0 0 8 3 0 0\n10 0 0 0 0 0 0 1\n\n7 7 0 0\n    -1\n";
const char *const kNastran =
    "CEND\nBEGIN BULK\n$ c\nGRID           1              0.      0.      1.\ngrid*                  2                 "
    " "
    "        4.0+00            0.D0*A\n*A                    1.\nGRID,3,,4.,4.,1.$ here\nGRID,4,0,0.0,.4E1,1.\n"
    "CTRIA3         1       5       1       2       3\nCQUAD4,2,,1,2,3,4\nCBAR,12,9,1,2,0.,0.,1.\nPLOTEL,13,2,3\n"
    "CTRIA6,14,7,1,2,3,,,\n,0.\nPSHELL,3,1,.1\nENDDATA\n";
const char *const kTwoDm =
    "MESH2D\nMESHNAME \"a b\"\nNUM_MATERIALS_PER_ELEM 2\nND 1 0 0 -1.5\nND 2 4 0 -2\nND 3 4 4 -3\nND 9 0 4 0\n"
    "E3T 1 1 2 3 8 9\nE4Q 2 1 2 3 9\nNS 1 2\nNS -3\nNS 3 -9 17\nNS 9 -1 \"far end\"\nBC 1\n";
const char *const kMfem =
    "MFEM mesh v1.2\n\n# c\ndimension\n2\nelements\n2\n0 3 0 1 2 3\n7 2 0 1 2\nboundary\n1\n5 1 0 1\nvertices\n4\n3\n"
    "0 0 1\n1 0 1\n1 1 1\n0 1 1\nmfem_mesh_end\n";
const char *const kMfemCurved =
    "MFEM mesh v1.0\n# quadrilaterals of 8 nodes\ndimension\n2\nelements\n2\n1 3 0 1 2 3\n2 2 1 4 2\nboundary\n1\n"
    "7 1 0 1\nvertices\n5\nnodes\nFiniteElementSpace\nFiniteElementCollection: H1_2D_P2\nVDim: 2\nOrdering: 1\n"
    "0 0\n2 0\n2 2\n0 2\n3 1\n1 -0.25\n2.25 1\n1 2\n0 1\n2.5 0.5\n2.5 1.5\n1.125 0.875\n";
const char *const kTriangle6 =
    "6 2 0 1\n1 0 0 1\n2 2 0 1\n3 0 2 0\n4 1 1 0\n5 0 1 0\n6 1 0 0\n%%\n1 6 0\n1 1 2 3 4 5 6\n%%\n"
    "1 1\n1 1 2 5\n";
const char *const kTriangle =
    "3 2 0 1\n1 0 0 1\n2 1 0 1\n3 0 1 0\n# region 2 \"r\"\n# point 1 4\n%%\n1 3 1\n1 1 2 3 2\n"
    "%%\n2 1\n1 1 2 5\n2 2 3 0\n";

const char *const kScript =
    R"({"command":"new"}
{"command":"add","shapes":[{"kind":"polygon","tag":1,"nodes":[[0,0],[4,0],[4,2]]}]}
{"command":"add","shapes":[{"id":3,"kind":"circle","tag":2,"nodes":[[2,1],[3,1]]}]}
{"command":"parameter","name":"r","expression":"0.5"}
{"command":"constrain","kind":"radius","parts":["shape/3/segment/0"],"value":"2*r"}
{"command":"move","shapes":[3],"by":[1,0]}
{"command":"name","boundary":2,"name":"a"}
{"command":"size","size":"r"}
{"command":"change","remove":[1],"members":{"guides":[{"x":1}]}}
{"command":"undo","steps":2}
{"command":"redo"}
)";

const char *const kLesson = "{\"format\":\"forefront-lesson\",\"version\":1,\"title\":\"T\",\"about\":\"a\",\"pages\":["
                            "{\"title\":\"P\",\"text\":[\"{front} $\\\\sqrt{x_1^{2}}\\\\le\\\\value{front}$ "
                            "[b](#2)\",\"![a](b.png "
                            "width=50%)\"],\"colours\":{\"error\":\"x*y\"},\"document\":\"d.json\",\"method\":\"fast\","
                            "\"grid\":\"none\",\"improve\":\"best\","
                            "\"position\":{\"advance\":3,\"events\":2},"
                            "\"layers\":[\"mesh\"],\"panel\":\"steps\",\"camera\":{\"centre\":[1,2],\"size\":3},"
                            "\"highlight\":[\"a/b\"],\"question\":{\"text\":"
                            "\"q\",\"choices\":[{\"text\":\"a\",\"right\":{\"value\":\"Nc\",\"is\":\"Nb\",\"within\":1}"
                            "},{\"text\":\"b\",\"right\":false}],"
                            "\"hint\":\"h\",\"why\":\"w\",\"show\":\"end\"}},{\"title\":\"Q\",\"text\":\"t\","
                            "\"camera\":\"follow\",\"question\":{\"text\":\"q\","
                            "\"until\":[{\"value\":\"chosen\",\"is\":\"winner\"},{\"value\":\"front\",\"below\":9}],"
                            "\"show\":4}},{\"title\":\"R\",\"text\":\"t\","
                            "\"question\":{\"text\":\"q\",\"number\":\"alpha\",\"within\":0.1}}]}";

constexpr const char *kEsriGrid = "ncols 3\nnrows 2\nxllcorner 0\nyllcenter -1.5\ncellsize 2\nNODATA_value -9999\n"
                                  "1 2 -9999\n0.5 0.25 1e-1\n";

/// Returns kValues as they are in a binary file.
std::string binaryValues() {
    std::string section = "$NodeData\n1\n\"size\"\n1\n0\n3\n0\n1\n4\n";
    for (std::int32_t node = 1; node <= 4; ++node) {
        const double value = 0.1 * node;
        section.append(reinterpret_cast<const char *>(&node), sizeof node);
        section.append(reinterpret_cast<const char *>(&value), sizeof value);
    }
    return section + "\n$EndNodeData\n";
}

/// Returns bytes of every value, the same for the same seed.
std::string anyBytes(std::uint32_t seed) {
    std::mt19937 random(seed);
    std::string bytes;
    for (int k = 0; k < 200; ++k) {
        bytes += static_cast<char>(random() % 256);
    }
    return bytes;
}

/// Returns pictures of different kinds, interlaced and compressed with all three kinds of codes.
std::vector<std::string> pictures() {
    using testing::pngFile;
    const auto decoded = [](const char *base64) { return fromBase64(base64).value_or(""); };
    testing::PngSample indexed{.columns = 4, .rows = 2, .depth = 2, .colour = 3, .bytes = {0, 0x1B, 2, 0x1B}};
    indexed.palette = "abcdefghijkl";
    indexed.transparency = std::string("\xff\0", 2);
    const testing::PngSample colours{
        .columns = 3, .rows = 3, .colour = 2, .interlaced = true, .bytes = {0, 1, 2, 3, 0, 4, 5, 6, 1, 7, 8,
                                                                            9, 1, 2, 3, 0, 4, 5, 6, 3, 7, 8,
                                                                            9, 4, 1, 2, 3, 4, 5, 6, 7, 8, 9}};
    return {
        pngFile(indexed), pngFile(colours),
        pngFile({.columns = 24, .rows = 20},
                decoded("eNp1iVsKwEAIxHzd/8zdrB+ljh0wBuL2M3/5RZ8rWnwBERNc2XZDLDB+LDAkFITAJtxiX4dUEBKbOOFIKgiJTbjlvg6l"
                        "IBQ2ccKRUhAKm3gAOAgDdw==")),
        pngFile({.columns = 3, .rows = 2, .colour = 4}, decoded("eAFjYPgPhgz//wMJACnkBfs="))};
}

/// Returns inputs that the writers never produce, by the id of the format.
std::vector<std::string> handMade(std::string_view id) {
    if (id == "project") {
        return {projectText(smallDocument()), projectText({})};
    }
    if (id == "png") {
        return pictures();
    }
    if (id == "msh2") {
        return {text(writeMsh2) + kValues, text(writeMsh4) + kValues, text(writeMsh4Binary) + binaryValues(),
                text(writeMsh2, smallCells(false)) + kElementValues};
    }
    static const std::map<std::string_view, std::vector<std::string>> kTexts = {
        {"geojson", {kGeoJson, kLines}},
        {"topojson", {kTopoJson}},
        {"dxf", {kDxf, kDxfCurves}},
        {"wkt", {kWkt}},
        {"csv", {kCsv}},
        {"airfoil", {kLednicer}},
        {"femm", {kFemm}},
        {"poly", {kPoly}},
        {"svg", {kSvg, kStyledSvg, kClippedSvg}},
        {"triangle", {kTriangle, kTriangle6}},
        {"netgen", {kNetgen, kNetgenCells}},
        {"unv", {kUnv}},
        {"nastran", {kNastran}},
        {"2dm", {kTwoDm}},
        {"mfem", {kMfem, kMfemCurved}},
        {"vtu", {kVtuAscii}},
        {"xdmf", {kXdmf}},
        {"esri", {kEsriGrid}},
    };
    const auto found = kTexts.find(id);
    return found != kTexts.end() ? found->second : std::vector<std::string>();
}

/// A constraint as long as a unit in the last place of its coordinates, and a node far away that a repair drops.
std::string tinyEdge() {
    return {1, 2, 34, 1, 34, 16, 34, 1, 34, 1, 0, 1, 0, 1, 21, 0, 1};
}

} // namespace

std::vector<std::string> seeds(const Target &target) {
    if (target.format == nullptr) {
        using List = std::vector<std::string>;
        const std::string_view name = target.name;
        return name == "lesson"   ? List{std::string(kLesson)}
               : name == "math"   ? List{"\\frac{a_k^2}{\\sqrt[3]{b}}\\le\\left(\\sum_{k=1}^n\\overline{AB}\\right)",
                                       "\\text{if }-x\\cdot\\value{n}\\,\\to\\infty"}
               : name == "script" ? List{std::string(kScript)}
               : name == "mesh"   ? meshSeeds()
               : name == "run"    ? projectSeeds()
                                  : List{anyBytes(1), tinyEdge()};
    }
    std::vector<std::string> list = handMade(target.name);
    if (target.format->writesText()) {
        const auto asText = [&target](const MeshView &mesh) {
            StringSink sink;
            TextWriter out(sink);
            target.format->write(mesh, {}, out);
            out.flush();
            return std::move(sink.text);
        };
        list.push_back(asText(smallMesh()));
        for (const Mesh &mesh : {smallCells(false), smallCells(true), smallCells(true, true)}) {
            if (checkElements(target.format->about, mesh).empty()) {
                list.push_back(asText(mesh));
            }
        }
    }
    return list;
}

} // namespace forefront::fuzz
