#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/files/source/source.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

/// A mesh with one value per node.
struct MeshField {
    Mesh mesh;
    std::vector<double> values;
};

/// Scalar values of nodes or elements by name, as stored in a file; NaN where it has no value.
using NamedFields = std::map<std::string, std::vector<double>>;

/// A mesh with all its scalar values of nodes and elements; NaN where one has none.
struct MeshFields {
    Mesh mesh;
    NamedFields fields;        ///< of nodes
    NamedFields elementFields; ///< one value per element
};

/// Returns the mesh with one of its fields. Faults: "no-field", which lists the fields of the file, and
/// "bad-values" where a node of an element has no finite value.
Result<MeshField> meshWithField(MeshFields fields, std::string_view name, const SourceText &source);

} // namespace forefront
