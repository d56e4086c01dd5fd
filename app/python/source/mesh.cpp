#include "app/python/source/mesh.hpp"

#include "app/python/source/arrays.hpp"
#include "app/python/source/derived.hpp"
#include "app/python/source/faults.hpp"
#include "app/python/source/writing.hpp"
#include "core/engine/mesh/measures.hpp"
#include "core/engine/mesh/mesh_access.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/mesh/triangulated.hpp"
#include "core/files/common/planar_mesh.hpp"

#include <map>
#include <optional>
#include <pybind11/stl.h>
#include <string>
#include <utility>

namespace forefront::python {

namespace {

using Names = std::map<std::int32_t, std::string>;

/// Returns an object that keeps the mesh for the arrays over its memory.
py::capsule keeperOf(const PythonMesh &self) {
    return {new std::shared_ptr<const Mesh>(self.mesh),
            [](void *held) { delete static_cast<std::shared_ptr<const Mesh> *>(held); }};
}

py::array nodeArray(const PythonMesh &self) {
    return viewOf<double>(keeperOf(self), coordinates(*self.mesh).data(), self.mesh->nodes.size(), 2, sizeof(Vec2));
}

py::array blockArray(const PythonMesh &self, const CellBlock &block) {
    const std::size_t nodes = block.traits().nodes;
    return viewOf<std::uint32_t>(keeperOf(self), connectivity(block).data(), block.size(), nodes,
                                 nodes * sizeof(std::uint32_t));
}

/// Returns the number of blocks with elements, and the last of them.
std::pair<std::size_t, const CellBlock *> filledBlocks(const Mesh &mesh) {
    std::pair<std::size_t, const CellBlock *> found{0, nullptr};
    for (const CellBlock &block : mesh.blocks) {
        if (block.size() > 0) {
            found = {found.first + 1, &block};
        }
    }
    return found;
}

py::array elementArray(const PythonMesh &self) {
    const auto [count, block] = filledBlocks(*self.mesh);
    if (count > 1) {
        throw py::value_error("elements: the mesh has elements of several kinds; use blocks, or triangles()");
    }
    return count == 1 ? blockArray(self, *block) : viewOf<std::uint32_t>(keeperOf(self), nullptr, 0, 3, 12);
}

py::dict blockArrays(const PythonMesh &self) {
    py::dict blocks;
    for (const CellBlock &block : self.mesh->blocks) {
        if (block.size() > 0) {
            const std::string word(wordOf(block.kind()));
            blocks[word.c_str()] = blockArray(self, block);
        }
    }
    return blocks;
}

py::array regionArray(const PythonMesh &self) {
    if (const auto [count, block] = filledBlocks(*self.mesh); count == 1) {
        return viewOf<std::int32_t>(keeperOf(self), block->regions.data(), block->size(), 0, sizeof(std::int32_t));
    }
    std::vector<std::int32_t> all;
    for (const CellBlock &block : self.mesh->blocks) {
        all.insert(all.end(), block.regions.begin(), block.regions.end());
    }
    return copyOfValues<std::int32_t>(all);
}

py::array edgeArray(const PythonMesh &self) {
    static_assert(sizeof(NodeId) == sizeof(std::uint32_t));
    const auto &edges = self.mesh->edges;
    const NodeId *const first = edges.empty() ? nullptr : &edges.front().a;
    return viewOf<std::uint32_t>(keeperOf(self), reinterpret_cast<const std::uint32_t *>(first), edges.size(), 2,
                                 sizeof(TaggedEdge));
}

py::array edgeTagArray(const PythonMesh &self) {
    const auto &edges = self.mesh->edges;
    return viewOf<std::int32_t>(keeperOf(self), edges.empty() ? nullptr : &edges.front().tag, edges.size(), 0,
                                sizeof(TaggedEdge));
}

py::tuple pointArrays(const PythonMesh &self) {
    std::vector<std::uint32_t> nodes;
    std::vector<std::int32_t> tags;
    for (const TaggedNode &point : self.mesh->points) {
        nodes.push_back(static_cast<std::uint32_t>(index(point.node)));
        tags.push_back(point.tag);
    }
    return py::make_tuple(copyOfValues<std::uint32_t>(nodes), copyOfValues<std::int32_t>(tags));
}

/// Returns, for each edge k of each element, the element beyond it, or -1.
py::array neighbourArray(const PythonMesh &self) {
    const auto [count, block] = filledBlocks(*self.mesh);
    if (count != 1) {
        throw py::value_error("neighbours: expected a mesh with elements of one kind");
    }
    const std::size_t sides = block->traits().corners;
    py::array_t<std::int32_t> array({static_cast<py::ssize_t>(block->size()), static_cast<py::ssize_t>(sides)});
    const MeshEdges edges = edgesOf(*self.mesh);
    std::int32_t *to = array.mutable_data();
    for (std::size_t e = 0; e < block->size(); ++e) {
        for (std::size_t k = 0; k < sides; ++k) {
            const auto &both = edges.edges[edges.of(e, k)].elements;
            const ElementId other = index(both[0]) == e ? both[1] : both[0];
            *to++ = other == kNoElement ? -1 : static_cast<std::int32_t>(index(other));
        }
    }
    return array;
}

py::tuple triangleArrays(const PythonMesh &self) {
    const Triangulated split = triangulated(*self.mesh);
    const auto count = static_cast<py::ssize_t>(split.mesh.elements.size());
    py::array_t<std::uint32_t> triangles({count, py::ssize_t{3}});
    py::array_t<std::uint32_t> elements(count);
    std::uint32_t *to = triangles.mutable_data();
    for (std::size_t t = 0; t < split.mesh.elements.size(); ++t) {
        for (const NodeId node : split.mesh.elements[t]) {
            *to++ = static_cast<std::uint32_t>(index(node));
        }
        elements.mutable_data()[t] = static_cast<std::uint32_t>(split.element(t));
    }
    return py::make_tuple(triangles, elements);
}

CellKind kindOfColumns(py::ssize_t columns) {
    const std::optional<CellKind> kind = elementOfNodes(columns);
    if (!kind) {
        throw py::value_error("elements: expected 3, 4, 6, 8 or 9 nodes for each element, got " +
                              std::to_string(columns));
    }
    return *kind;
}

NodeId checkedNode(std::int64_t node, std::size_t count, const char *what) {
    if (node < 0 || static_cast<std::size_t>(node) >= count) {
        throw py::value_error(std::string(what) + ": node " + std::to_string(node) + " does not exist; expected 0 to " +
                              std::to_string(static_cast<std::int64_t>(count) - 1));
    }
    return NodeId{static_cast<std::uint32_t>(node)};
}

void addBlock(Mesh &mesh, const ArrayOf<std::int64_t> &elements) {
    if (elements.size() == 0) {
        return;
    }
    if (elements.ndim() != 2) {
        throw py::value_error("elements: expected an array of shape (m, 3)");
    }
    const CellKind kind = kindOfColumns(elements.shape(1));
    CellBlock &block = mesh.block(kind);
    std::vector<NodeId> row(traitsOf(kind).nodes);
    for (py::ssize_t e = 0; e < elements.shape(0); ++e) {
        for (std::size_t k = 0; k < row.size(); ++k) {
            row[k] = checkedNode(elements.data()[e * elements.shape(1) + static_cast<py::ssize_t>(k)],
                                 mesh.nodes.size(), "elements");
        }
        block.add(row);
    }
}

void setRegions(Mesh &mesh, const std::optional<ArrayOf<std::int32_t>> &regions) {
    if (regions && static_cast<std::size_t>(regions->size()) != mesh.elementCount()) {
        throw py::value_error("regions: expected one for each of the " + std::to_string(mesh.elementCount()) +
                              " elements, got " + std::to_string(regions->size()));
    }
    const std::int32_t *from = regions ? regions->data() : nullptr;
    for (CellBlock &block : mesh.blocks) {
        block.regions.assign(block.size(), 1);
        for (std::int32_t &region : block.regions) {
            region = from != nullptr ? *from++ : region;
        }
    }
}

void setEdges(Mesh &mesh, const std::optional<ArrayOf<std::int64_t>> &edges,
              const std::optional<ArrayOf<std::int32_t>> &tags) {
    const py::ssize_t count = edges ? edges->size() / 2 : 0;
    if (edges && edges->size() > 0 && (edges->ndim() != 2 || edges->shape(1) != 2)) {
        throw py::value_error("edges: expected an array of shape (k, 2)");
    }
    if (tags && tags->size() != count) {
        throw py::value_error("edge_tags: expected one for each of the " + std::to_string(count) + " edges, got " +
                              std::to_string(tags->size()));
    }
    for (py::ssize_t k = 0; k < count; ++k) {
        mesh.edges.push_back({checkedNode(edges->data()[2 * k], mesh.nodes.size(), "edges"),
                              checkedNode(edges->data()[2 * k + 1], mesh.nodes.size(), "edges"),
                              tags ? tags->data()[k] : 1});
    }
}

void setPoints(Mesh &mesh, const std::optional<ArrayOf<std::int64_t>> &points,
               const std::optional<ArrayOf<std::int32_t>> &tags) {
    const py::ssize_t count = points ? points->size() : 0;
    if (tags && tags->size() != count) {
        throw py::value_error("point_tags: expected one for each of the " + std::to_string(count) + " points, got " +
                              std::to_string(tags->size()));
    }
    for (py::ssize_t k = 0; k < count; ++k) {
        mesh.points.push_back(
            {checkedNode(points->data()[k], mesh.nodes.size(), "points"), tags ? tags->data()[k] : 1});
    }
}

PythonMesh meshFromArrays(const ArrayOf<double> &nodes, const std::vector<ArrayOf<std::int64_t>> &elements,
                          const std::optional<ArrayOf<std::int32_t>> &regions,
                          const std::optional<ArrayOf<std::int64_t>> &edges,
                          const std::optional<ArrayOf<std::int32_t>> &edgeTags, Names boundaryNames, Names regionNames,
                          const std::optional<ArrayOf<std::int64_t>> &points,
                          const std::optional<ArrayOf<std::int32_t>> &pointTags) {
    Mesh mesh;
    mesh.nodes = pointsOf(nodes, "nodes");
    for (const auto &block : elements) {
        addBlock(mesh, block);
    }
    setRegions(mesh, regions);
    setEdges(mesh, edges, edgeTags);
    setPoints(mesh, points, pointTags);
    mesh.boundaryNames = std::move(boundaryNames);
    mesh.regionNames = std::move(regionNames);
    return pythonMesh(std::move(mesh));
}

} // namespace

PythonMesh pythonMesh(Mesh mesh) {
    for (CellBlock &block : mesh.blocks) {
        if (block.regions.empty()) {
            block.regions.assign(block.size(), 1);
        }
    }
    return {std::make_shared<const Mesh>(std::move(mesh)), nullptr, {}};
}

void bindMesh(py::module_ &module) {
    py::class_<PythonMesh> mesh(module, "MeshBase");
    mesh.def(py::init<const PythonMesh &>())
        .def_property_readonly("nodes", &nodeArray, "The coordinates of the nodes: shape (n, 2), float64.")
        .def_property_readonly(
            "elements", &elementArray,
            "The nodes of each element, counter-clockwise: shape (m, 3), or (m, 4, 6, 8 or 9) for other "
            "kinds; a mesh of several kinds has ``blocks``.")
        .def_property_readonly("blocks", &blockArrays,
                               "A dict from the kind of elements, such as 'triangle3', to their nodes.")
        .def_property_readonly("regions", &regionArray,
                               "The tag of the region of each element: shape (m,); through all blocks in turn.")
        .def_property_readonly("edges", &edgeArray,
                               "The edges of the boundary and of lines: shape (k, 2), their end nodes.")
        .def_property_readonly("edge_tags", &edgeTagArray,
                               "The tag of the boundary part or line of each of the ``edges``: shape (k,).")
        .def_property_readonly("_points", &pointArrays)
        .def_property_readonly(
            "boundary_names", [](const PythonMesh &self) { return self.mesh->boundaryNames; },
            "The names of boundary parts and lines by tag, a copy.")
        .def_property_readonly(
            "region_names", [](const PythonMesh &self) { return self.mesh->regionNames; },
            "The names of regions by tag, a copy.")
        .def_property_readonly(
            "neighbours", &neighbourArray,
            "The element beyond each edge of an element, -1 at the boundary: shape (m, 3 or 4); edge k "
            "joins corner k to the next.")
        .def_property_readonly(
            "hash", [](const PythonMesh &self) { return meshHash(*self.mesh); },
            "The hash of the mesh, as ``forefront mesh`` prints it; it does not depend on the numbering.")
        .def_property_readonly(
            "notes", [](const PythonMesh &self) { return faultList(self.notes); },
            "What is no fault: what the reader left out, what repairs changed, sizes and limits that could not be "
            "kept.")
        .def_property_readonly(
            "element_count", [](const PythonMesh &self) { return self.mesh->elementCount(); },
            "The number of elements.")
        .def("_triangles", &triangleArrays)
        .def("_triangulated", [](const PythonMesh &self) { return pythonMesh(triangulated(*self.mesh).mesh); });
    bindMeshReports(mesh);
    bindWriting(mesh);
    bindDerived(mesh);
    module.def("mesh_from_arrays", &meshFromArrays);
}

} // namespace forefront::python
