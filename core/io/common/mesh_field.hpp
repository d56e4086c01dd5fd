#pragma once

#include "core/base/result.hpp"
#include "core/io/source/source.hpp"
#include "core/mesh/mesh.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// A mesh with one value per node.
struct MeshField {
    Mesh mesh;
    std::vector<double> values;
};

/// Nodal values with one component by name, as a file holds them; NaN where it says nothing.
using NamedFields = std::map<std::string, std::vector<double>>;

/// The mesh with the field of that name. Faults: "no-field", which lists the fields there are, and "bad-values" where
/// there is not one finite value for each node of an element.
Result<MeshField> meshWithField(Mesh mesh, NamedFields fields, std::string_view name, const SourceText &source);

} // namespace forefront
