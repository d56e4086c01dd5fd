#include "core/files/abaqus/abaqus.hpp"
#include "core/files/abaqus/abaqus_coordinate.hpp"
#include "core/files/abaqus/abaqus_sets.hpp"
#include "core/files/common/solid_mesh.hpp"

#include <map>
#include <set>
#include <vector>

namespace forefront {

namespace {

/// Writes a list of cells for each region and each number of corners in it.
void writeAbaqusCells(const SolidMesh &mesh, const std::map<std::int32_t, std::string> &sets, TextWriter &out) {
    std::map<std::int32_t, std::vector<std::size_t>> byRegion;
    for (std::size_t k = 0; k < mesh.cells.size(); ++k) {
        byRegion[mesh.cells[k].region].push_back(k);
    }
    for (const auto &[region, cells] : byRegion) {
        std::uint8_t corners = 0;
        for (const std::size_t k : cells) {
            const SolidCell &cell = mesh.cells[k];
            if (cell.count != corners) {
                corners = cell.count;
                out << "** tag " << region << "\n*ELEMENT, TYPE=" << (corners == 6 ? "C3D6" : "C3D8")
                    << ", ELSET=" << sets.at(region) << '\n';
            }
            out << k + 1;
            for (const std::uint32_t node : cell.nodes()) {
                out << ", " << node + std::uint64_t{1};
            }
            out << '\n';
        }
    }
}

/// Writes a node set and a surface for each part of the boundary, in the numbering of sides of Abaqus: S1 is the back,
/// S2 the front, the others follow around them.
void writeAbaqusFaces(const SolidMesh &mesh, const std::map<std::int32_t, std::string> &sets, UniqueNames &unique,
                      TextWriter &out) {
    std::map<std::int32_t, std::vector<std::size_t>> byTag;
    for (std::size_t k = 0; k < mesh.faces.size(); ++k) {
        byTag[mesh.faces[k].tag].push_back(k);
    }
    for (const auto &[tag, faces] : byTag) {
        std::set<std::uint32_t> nodes;
        for (const std::size_t k : faces) {
            nodes.insert(mesh.faces[k].nodes().begin(), mesh.faces[k].nodes().end());
        }
        const std::string surface = unique.claim("S_" + sets.at(tag));
        writeAbaqusUses(sets.at(tag), surface, 3, out);
        writeAbaqusNodes(sets.at(tag), nodes, out);
        out << "** tag " << tag << "\n*SURFACE, NAME=" << surface << ", TYPE=ELEMENT\n";
        for (const std::size_t k : faces) {
            out << mesh.faces[k].cell + std::uint64_t{1} << ", S" << mesh.faces[k].side + 1 << '\n';
        }
    }
}

} // namespace

/// Writes prisms and hexahedra as elements C3D6 and C3D8 in a set per region, a node set and a surface per boundary
/// part, the back and the front.
void writeAbaqusSolid(const SolidMesh &mesh, TextWriter &out) {
    UniqueNames unique;
    const std::string allNodes = unique.claim("NALL"), allElements = unique.claim("EALL");
    const FileNames sets = identifiersOf(mesh.tags, unique);
    out << "*HEADING\nExtruded mesh\n";
    writeAbaqusUnit(mesh.unit, out);
    writeNameComments(mesh.tags, "**", out);
    out << "*NODE, NSET=" << allNodes << '\n';
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << n + 1;
        for (const double place : mesh.nodes[n]) {
            out << ", " << AbaqusCoordinate(place).text();
        }
        out << '\n';
    }
    writeAbaqusCells(mesh, sets.regions, out);
    out << "*ELSET, ELSET=" << allElements << ", GENERATE\n1, " << mesh.cells.size() << ", 1\n";
    writeAbaqusFaces(mesh, sets.edges, unique, out);
}

} // namespace forefront
