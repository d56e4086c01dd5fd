#pragma once

#include "core/engine/mesh/measures.hpp"
#include "core/files/common/mesh_field.hpp"

#include <memory>
#include <string>
#include <vector>

namespace forefront {

/// The scalar values that the file of a mesh holds, by name.
struct FileFields {
    NamedFields nodes, elements;

    /// Returns the values with this name, one for each node or element; null if there are none.
    const std::vector<double> *find(MeshPart part, const std::string &name) const;
};

/// Takes the mesh out of `read` as triangles, and makes its values of elements those of the triangles.
TriMesh takeTriangles(MeshFields &read);

/// Takes the values out of `read`, except arrays that do not have one value for each node or element of its triangles,
/// `mesh`; null if there are none.
std::shared_ptr<const FileFields> takeFields(MeshFields &read, const TriMesh &mesh);

} // namespace forefront
