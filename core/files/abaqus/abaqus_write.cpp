#include "core/engine/base/number_text.hpp"
#include "core/engine/mesh/periodic_pairs.hpp"
#include "core/files/abaqus/abaqus.hpp"
#include "core/files/abaqus/abaqus_coordinate.hpp"
#include "core/files/abaqus/abaqus_sets.hpp"
#include "core/files/common/names.hpp"
#include "core/files/common/tagged_cells.hpp"
#include "core/files/common/tagged_sides.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string_view>

namespace forefront {

namespace {

/// Writes the sides of elements along the edges of one tag. If an edge has two sides, the one in its direction is
/// taken.
void writeSurface(const TaggedSides &table, const std::string &name, const std::vector<std::uint32_t> &edges,
                  TextWriter &out) {
    out << "*SURFACE, NAME=" << name << ", TYPE=ELEMENT\n";
    for (const std::uint32_t k : edges) {
        const std::span<const ElementSide> sides = table.of(k);
        if (sides.empty()) {
            continue; // the edge is a side of no element, as in a partial mesh
        }
        const auto along = std::find_if(sides.begin(), sides.end(), [](const ElementSide &side) { return side.along; });
        const ElementSide &side = along != sides.end() ? *along : sides.front();
        out << side.element + std::uint64_t{1} << ", S" << side.side + 1 << '\n';
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

/// Writes a list of elements for each region and each kind in it.
void writeElements(const MeshView &mesh, const AbaqusNames &names, TextWriter &out) {
    for (const auto &[tag, elements] : elementsByRegion(mesh)) {
        CellKind kind = CellKind::Point;
        for (std::size_t k = 0; k < elements.size() && out.ok(); ++k) {
            const MeshView::Block &block = mesh.blockOf(elements[k]);
            if (block.kind != kind) {
                kind = block.kind;
                out << "** tag " << tag << "\n*ELEMENT, TYPE=" << block.traits().abaqus
                    << ", ELSET=" << names.sets.regions.at(tag) << '\n';
            }
            out << elements[k] + std::uint64_t{1};
            for (const NodeId node : block.nodesOf(elements[k] - block.first)) {
                out << ", " << index(node) + 1;
            }
            out << '\n';
        }
    }
    if (mesh.elementCount() > 0) {
        out << "*ELSET, ELSET=" << names.allElements << ", GENERATE\n1, " << mesh.elementCount() << ", 1\n";
    }
}

void writeBoundaries(const MeshView &mesh, const AbaqusNames &names, TextWriter &out) {
    const TaggedSides table(mesh);
    for (const auto &[tag, edges] : edgesByTag(mesh)) {
        std::set<std::uint32_t> nodes;
        for (const std::uint32_t k : edges) {
            for (const NodeId node : EdgeNodes(mesh.edges[k])) {
                nodes.insert(static_cast<std::uint32_t>(node));
            }
        }
        writeAbaqusUses(names.sets.edges.at(tag), names.surfaces.at(tag), 2, out);
        writeAbaqusNodes(names.sets.edges.at(tag), nodes, out);
        out << "** tag " << tag << '\n';
        writeSurface(table, names.surfaces.at(tag), edges, out);
    }
}

void writePoints(const MeshView &mesh, const AbaqusNames &names, TextWriter &out) {
    std::map<std::int32_t, std::set<std::uint32_t>> points;
    for (const TaggedNode &point : mesh.points) {
        points[point.tag].insert(static_cast<std::uint32_t>(point.node));
    }
    for (const auto &[tag, nodes] : points) {
        out << "** point " << tag << '\n';
        writeAbaqusNodes(names.sets.points.at(tag), nodes, out);
    }
}

/// Writes the pairs of nodes of periodic parts as comments: equations of equal displacements where the parts are moved
/// copies, to be used without "** "; for turned parts, whose displacements turn too, the pairs alone.
void writePeriodic(const MeshView &mesh, const AbaqusNames &names, const PeriodicLink &link, TextWriter &out) {
    const auto from = names.sets.edges.find(link.from), to = names.sets.edges.find(link.to);
    if (from == names.sets.edges.end() || to == names.sets.edges.end()) {
        return;
    }
    const PeriodicPairs found = periodicPairs(mesh, link);
    out << "** periodic: " << to->second << " is the image of " << from->second << ", " << found.pairs.size()
        << " pairs of nodes\n";
    for (const NodePair &pair : found.pairs) {
        if (!link.map.translates()) {
            out << "** pair " << index(pair.to) + 1 << ", " << index(pair.from) + 1 << '\n';
            continue;
        }
        for (const int direction : {1, 2}) {
            out << "** *EQUATION\n** 2\n** " << index(pair.to) + 1 << ", " << direction << ", 1., "
                << index(pair.from) + 1 << ", " << direction << ", -1.\n";
        }
    }
}

} // namespace

/// Writes Abaqus input for CalculiX and Abaqus: elements of plane stress in a set per region, a node set and a surface
/// per boundary tag, a node set per tag of points. The names become identifiers; comments keep the original names and
/// the tags. Coordinates have at most 20 characters.
void writeAbaqus(const MeshView &mesh, TextWriter &out) {
    writeAbaqusWith(mesh, {}, out);
}

void writeAbaqusWith(const MeshView &mesh, const ExportOptions &options, TextWriter &out) {
    const AbaqusNames names(tagsOf(mesh));
    out << "*HEADING\n" << titleOf(mesh) << '\n';
    writeAbaqusUnit(options.unit, out);
    writeNameComments(mesh, "**", out);
    out << "*NODE, NSET=" << names.allNodes << '\n';
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << n + 1 << ", " << AbaqusCoordinate(mesh.nodes[n].x).text() << ", "
            << AbaqusCoordinate(mesh.nodes[n].y).text() << ", 0\n";
    }
    writeElements(mesh, names, out);
    if (mesh.elementCount() > 0) {
        writeBoundaries(mesh, names, out);
    }
    writePoints(mesh, names, out);
    for (const PeriodicLink &link : mesh.periodic) {
        writePeriodic(mesh, names, link, out);
    }
}

Diagnostics noteAbaqusChanges(const MeshView &mesh) {
    const TagList tags = tagsOf(mesh);
    Diagnostics notes = noteChangedNames(tags, AbaqusNames(tags).sets);
    std::size_t rounded = 0;
    for (const Vec2 node : mesh.nodes) {
        rounded += AbaqusCoordinate(node.x).rounded() ? 1 : 0;
        rounded += AbaqusCoordinate(node.y).rounded() ? 1 : 0;
    }
    if (rounded > 0) {
        Diagnostic &note = notes.emplace_back();
        note.severity = Severity::Note;
        note.code = "rounded-coordinates";
        note.message = countText(rounded, "coordinate") + (rounded == 1 ? " is" : " are") +
                       " rounded to 20 characters, the most that Abaqus and CalculiX read of a number";
    }
    return notes;
}

} // namespace forefront
