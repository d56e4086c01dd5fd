#include "core/engine/mesh/edge_table.hpp"
#include "core/files/abaqus/abaqus.hpp"
#include "core/files/common/names.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace forefront {

namespace {

constexpr std::size_t kPerLine = 10;

/// Writes a node set; the indices ascend.
void writeNodeSet(const std::string &name, const std::set<std::uint32_t> &nodes, TextWriter &out) {
    out << "*NSET, NSET=" << name << '\n';
    std::size_t column = 0;
    for (const std::uint32_t node : nodes) {
        out << node + std::uint64_t{1} << (++column % kPerLine == 0 || column == nodes.size() ? "\n" : ", ");
    }
}

/// Writes the sides of elements along the edges of one tag. If an edge has two sides, the one in its direction is
/// taken.
void writeSurface(const TriMesh &mesh, const EdgeTable &table, const std::string &name,
                  const std::vector<std::uint32_t> &edges, TextWriter &out) {
    out << "*SURFACE, NAME=" << name << ", TYPE=ELEMENT\n";
    const HalfEdges &halfEdges = table.halfEdges();
    for (const std::uint32_t k : edges) {
        const auto sides = table.find(mesh.edges[k].a, mesh.edges[k].b);
        if (sides.empty()) {
            continue; // the edge is a side of no element, as in a partial mesh
        }
        const auto along = std::find_if(sides.begin(), sides.end(),
                                        [&](HalfEdge side) { return halfEdges.startOf(side) == mesh.edges[k].a; });
        const HalfEdge side = along != sides.end() ? *along : sides.front();
        out << halfEdges.elementOf(side) + 1 << ", S" << halfEdges.sideOf(side) + 1 << '\n';
    }
}

/// The names of sets and surfaces in a file: at most 80 characters, as Abaqus and CalculiX allow.
struct AbaqusNames {
    std::string allNodes, allElements;
    FileNames sets;
    std::map<std::int32_t, std::string> surfaces; ///< by boundary tag

    explicit AbaqusNames(const TagList &tags) {
        UniqueNames unique;
        allNodes = unique.claim("NALL");
        allElements = unique.claim("EALL");
        sets = identifiersOf(tags, unique);
        for (const auto &[tag, name] : sets.edges) {
            surfaces.emplace(tag, unique.claim("S_" + name));
        }
    }
};

void writeElements(const TriMesh &mesh, const AbaqusNames &names, TextWriter &out) {
    std::map<std::int32_t, std::vector<std::uint32_t>> regions;
    for (std::uint32_t e = 0; e < mesh.elements.size(); ++e) {
        regions[mesh.region(e)].push_back(e);
    }
    for (const auto &[tag, elements] : regions) {
        out << "** tag " << tag << "\n*ELEMENT, TYPE=CPS3, ELSET=" << names.sets.regions.at(tag) << '\n';
        for (std::size_t k = 0; k < elements.size() && out.ok(); ++k) {
            const Element &nodes = mesh.elements[elements[k]];
            out << elements[k] + std::uint64_t{1} << ", " << index(nodes[0]) + 1 << ", " << index(nodes[1]) + 1 << ", "
                << index(nodes[2]) + 1 << '\n';
        }
    }
    if (!mesh.elements.empty()) {
        out << "*ELSET, ELSET=" << names.allElements << ", GENERATE\n1, " << mesh.elements.size() << ", 1\n";
    }
}

void writeBoundaries(const TriMesh &mesh, const AbaqusNames &names, TextWriter &out) {
    std::map<std::int32_t, std::vector<std::uint32_t>> boundaries;
    for (std::uint32_t k = 0; k < mesh.edges.size(); ++k) {
        boundaries[mesh.edges[k].tag].push_back(k);
    }
    const EdgeTable table(mesh);
    for (const auto &[tag, edges] : boundaries) {
        std::set<std::uint32_t> nodes;
        for (const std::uint32_t k : edges) {
            nodes.insert({static_cast<std::uint32_t>(mesh.edges[k].a), static_cast<std::uint32_t>(mesh.edges[k].b)});
        }
        writeNodeSet(names.sets.edges.at(tag), nodes, out);
        out << "** tag " << tag << '\n';
        writeSurface(mesh, table, names.surfaces.at(tag), edges, out);
    }
}

void writePoints(const TriMesh &mesh, const AbaqusNames &names, TextWriter &out) {
    std::map<std::int32_t, std::set<std::uint32_t>> points;
    for (const TaggedNode &point : mesh.points) {
        points[point.tag].insert(static_cast<std::uint32_t>(point.node));
    }
    for (const auto &[tag, nodes] : points) {
        out << "** point " << tag << '\n';
        writeNodeSet(names.sets.points.at(tag), nodes, out);
    }
}

} // namespace

/// Writes Abaqus input for CalculiX and Abaqus: CPS3 elements in a set per region, a node set and a surface per
/// boundary tag, a node set per tag of points. The names become identifiers; comments keep the original names and the
/// tags.
void writeAbaqus(const TriMesh &mesh, TextWriter &out) {
    const AbaqusNames names(tagsOf(mesh));
    out << "*HEADING\nPlane triangle mesh\n";
    writeNameComments(mesh, "**", out);
    out << "*NODE, NSET=" << names.allNodes << '\n';
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << n + 1 << ", " << mesh.nodes[n].x << ", " << mesh.nodes[n].y << ", 0\n";
    }
    writeElements(mesh, names, out);
    if (!mesh.elements.empty()) {
        writeBoundaries(mesh, names, out);
    }
    writePoints(mesh, names, out);
}

Diagnostics noteAbaqusChanges(const TriMesh &mesh) {
    const TagList tags = tagsOf(mesh);
    return noteChangedNames(tags, AbaqusNames(tags).sets);
}

} // namespace forefront
