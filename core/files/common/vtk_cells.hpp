#pragma once

#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/common/mesh_field.hpp"
#include "core/files/text/text_scanner.hpp"
#include "core/files/text/text_writer.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace forefront {

/// Cell types of VTK. A mesh becomes an unstructured grid of triangles, then tagged edges as lines, then tagged points
/// as vertices. The cell array `region` holds the region of triangles, `boundary` the tag of lines and vertices; both
/// are 0 elsewhere. A field array "boundary:NAME" or "region:NAME" holds the tags of that name.
inline constexpr std::uint8_t kVtkVertex = 1, kVtkLine = 3, kVtkTriangle = 5;

/// Returns the names of the field arrays of a VTU file with their tags, for all tags in use.
std::map<std::string, std::vector<std::int32_t>> vtkNameFields(const MeshView &mesh);

/// An unstructured grid as read, before its indices are checked.
struct VtkGrid {
    std::vector<Vec2> nodes;
    std::vector<std::int64_t> connectivity, ends; ///< the nodes of cell c end at ends[c]
    std::vector<std::int64_t> types;
    std::map<std::string, std::vector<double>> cellArrays; ///< of all cells; those with a usual name hold tags
    std::map<std::string, std::vector<std::int64_t>> fields;
    std::map<std::string, std::vector<double>> pointArrays; ///< with one component; only where asked for
    std::map<std::string, std::vector<double>> cellReals;   ///< of all cells; likewise
    std::size_t offset = 0;                                 ///< of the cells, for faults
    std::vector<std::int64_t> elementCells;                 ///< the cell of each element of the mesh
};

/// Converts a grid to a mesh, with the names of its tags, and fills in its `elementCells`. Failures are recorded in the
/// scanner.
bool meshOfVtk(VtkGrid &grid, TextScanner &scanner, Mesh &mesh);

/// Returns the mesh of a grid with its values of nodes and elements; tags are not values. Notes arrays whose length
/// does not match the mesh.
MeshFields fieldsOfVtk(VtkGrid grid, Mesh mesh, const SourceText &source);

/// Notes an array that is not read because it has several components.
void noteComponents(const SourceText &source, const std::string &name, std::size_t components, std::size_t offset);

} // namespace forefront
