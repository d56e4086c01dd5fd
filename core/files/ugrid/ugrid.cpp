#include "core/files/ugrid/ugrid.hpp"

#include "core/engine/base/key_order.hpp"
#include "core/engine/mesh/edge_table.hpp"
#include "core/files/common/names.hpp"
#include "core/files/ugrid/classic_netcdf.hpp"
#include "core/files/ugrid/ugrid_system.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace forefront {

namespace {

constexpr std::int32_t kNoNode32 = -999; ///< fills the fourth node of triangles

FileNames ugridNames(const TagList &tags) {
    UniqueNames unique;
    return identifiersOf({.edges = tags.edges, .points = {}, .regions = tags.regions}, unique);
}

/// The edges of a mesh: their nodes, and the tag of each, 0 if it has none.
struct UgridEdges {
    std::vector<std::array<std::uint32_t, 2>> nodes;
    std::vector<std::int32_t> tags;

    explicit UgridEdges(const MeshView &mesh) {
        std::map<std::uint64_t, std::int32_t> tagged;
        for (const TaggedEdge &edge : mesh.edges) {
            tagged.try_emplace(pairKey(std::min(edge.a, edge.b), std::max(edge.a, edge.b)), edge.tag);
        }
        EdgeTable(mesh).forEach([&](NodeId low, NodeId high, std::span<const HalfEdge>) {
            const auto found = tagged.find(pairKey(low, high));
            nodes.push_back({static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(high)});
            tags.push_back(found == tagged.end() ? 0 : found->second);
        });
    }
};

/// Returns the attributes of flags with a meaning for each tag.
std::vector<NetcdfAttribute> flags(const char *location, const char *title,
                                   const std::map<std::int32_t, std::string> &names) {
    std::vector<std::int32_t> values;
    std::string meanings;
    for (const auto &[tag, name] : names) {
        values.push_back(tag);
        meanings += (meanings.empty() ? "" : " ") + name;
    }
    std::vector<NetcdfAttribute> attributes = {
        {"mesh", std::string("mesh2d")}, {"location", std::string(location)}, {"long_name", std::string(title)}};
    if (!values.empty()) {
        attributes.push_back({"flag_values", std::move(values)});
        attributes.push_back({"flag_meanings", std::move(meanings)});
    }
    return attributes;
}

/// Refers to the reference system of the coordinates, if it is known.
void addMapping(const MapSystem &system, NetcdfVariable &variable) {
    if (system.known()) {
        variable.attributes.push_back({"grid_mapping", systemVariable(system)});
    }
}

NetcdfVariable topology() {
    return {"mesh2d",
            {},
            {{"cf_role", std::string("mesh_topology")},
             {"long_name", std::string("Topology of the mesh")},
             {"topology_dimension", std::vector<std::int32_t>{2}},
             {"node_coordinates", std::string("mesh2d_node_x mesh2d_node_y")},
             {"node_dimension", std::string("mesh2d_nNodes")},
             {"edge_node_connectivity", std::string("mesh2d_edge_nodes")},
             {"edge_dimension", std::string("mesh2d_nEdges")},
             {"face_node_connectivity", std::string("mesh2d_face_nodes")},
             {"face_dimension", std::string("mesh2d_nFaces")},
             {"max_face_nodes_dimension", std::string("mesh2d_nMax_face_nodes")}},
            false,
            [](BigEndian &values) { values.integer(0); }};
}

/// Returns the x or y of the nodes: projected coordinates, or longitudes and latitudes.
NetcdfVariable coordinates(const MeshView &mesh, bool isX, const ExportOptions &options) {
    const MapSystem &system = options.system;
    const char *const standard = system.geographic ? (isX ? "longitude" : "latitude")
                                                   : (isX ? "projection_x_coordinate" : "projection_y_coordinate");
    const std::string unit = !system.geographic ? projectedUnit(options.unit, system)
                             : isX              ? "degrees_east"
                                                : "degrees_north";
    NetcdfVariable variable{isX ? "mesh2d_node_x" : "mesh2d_node_y",
                            {0},
                            {{"units", unit},
                             {"standard_name", std::string(standard)},
                             {"mesh", std::string("mesh2d")},
                             {"location", std::string("node")}},
                            true,
                            [&mesh, isX](BigEndian &values) {
                                for (const Vec2 node : mesh.nodes) {
                                    values.real(isX ? node.x : node.y);
                                }
                            }};
    addMapping(system, variable);
    return variable;
}

NetcdfVariable elevations(const MeshView &mesh, const MapSystem &system) {
    NetcdfVariable variable{"mesh2d_node_z",
                            {0},
                            {{"units", std::string("m")},
                             {"standard_name", std::string("altitude")},
                             {"long_name", std::string("elevation of the bed")},
                             {"mesh", std::string("mesh2d")},
                             {"location", std::string("node")},
                             {"coordinates", std::string("mesh2d_node_x mesh2d_node_y")}},
                            true,
                            [&mesh](BigEndian &values) {
                                for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
                                    values.real(mesh.elevation(n));
                                }
                            }};
    addMapping(system, variable);
    return variable;
}

NetcdfVariable faceNodes(const MeshView &mesh, std::uint32_t most) {
    return {"mesh2d_face_nodes",
            {2, 3},
            {{"cf_role", std::string("face_node_connectivity")},
             {"start_index", std::vector<std::int32_t>{1}},
             {"_FillValue", std::vector<std::int32_t>{kNoNode32}}},
            false,
            [&mesh, most](BigEndian &values) {
                for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
                    const std::span<const NodeId> nodes = mesh.cornersOf(e);
                    for (std::size_t k = 0; k < most; ++k) {
                        values.integer(k < nodes.size() ? static_cast<std::uint32_t>(index(nodes[k]) + 1)
                                                        : static_cast<std::uint32_t>(kNoNode32));
                    }
                }
            }};
}

} // namespace

void writeUgrid(const MeshView &mesh, const ExportOptions &options, TextWriter &out) {
    const FileNames names = ugridNames(tagsOf(mesh));
    const UgridEdges edges(mesh);
    std::uint32_t most = 3;
    for (const MeshView::Block &block : mesh.blocks()) {
        most = std::max<std::uint32_t>(most, block.traits().corners);
    }
    ClassicNetcdf file;
    file.attributes = {{"Conventions", std::string("CF-1.8 UGRID-1.0 Deltares-0.10")}};
    file.dimensions = {{"mesh2d_nNodes", static_cast<std::uint32_t>(mesh.nodes.size())},
                       {"mesh2d_nEdges", static_cast<std::uint32_t>(edges.nodes.size())},
                       {"mesh2d_nFaces", static_cast<std::uint32_t>(mesh.elementCount())},
                       {"mesh2d_nMax_face_nodes", most},
                       {"Two", 2}};
    file.variables.push_back(topology());
    if (options.system.known()) {
        file.variables.push_back(systemOf(options.system));
    }
    file.variables.push_back(coordinates(mesh, true, options));
    file.variables.push_back(coordinates(mesh, false, options));
    file.variables.push_back(elevations(mesh, options.system));
    file.variables.push_back(
        {"mesh2d_edge_nodes",
         {1, 4},
         {{"cf_role", std::string("edge_node_connectivity")}, {"start_index", std::vector<std::int32_t>{1}}},
         false,
         [&edges](BigEndian &values) {
             for (const auto &[a, b] : edges.nodes) {
                 values.integer(a + 1);
                 values.integer(b + 1);
             }
         }});
    file.variables.push_back(faceNodes(mesh, most));
    file.variables.push_back(
        {"mesh2d_edge_boundary", {1}, flags("edge", "boundary part", names.edges), false, [&edges](BigEndian &values) {
             for (const std::int32_t tag : edges.tags) {
                 values.integer(static_cast<std::uint32_t>(tag));
             }
         }});
    file.variables.push_back(
        {"mesh2d_face_region", {2}, flags("face", "region", names.regions), false, [&mesh](BigEndian &values) {
             for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
                 values.integer(static_cast<std::uint32_t>(mesh.region(e)));
             }
         }});
    file.write(out);
}

Diagnostics noteUgridChanges(const MeshView &mesh) {
    TagList tags = tagsOf(mesh);
    tags.points.clear();
    Diagnostics notes = noteChangedNames(tags, ugridNames(tags));
    if (mesh.elevations.empty()) {
        Diagnostic &note = notes.emplace_back();
        note.severity = Severity::Note;
        note.code = "no-elevation";
        note.message = "all nodes have the elevation 0: the mesh has none";
    }
    return notes;
}

} // namespace forefront
