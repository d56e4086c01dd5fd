#include "core/files/common/mesh_field.hpp"

#include <cmath>

namespace forefront {

namespace {

Diagnostics noField(const NamedFields &fields, std::string_view name, const SourceText &source) {
    std::string names;
    for (const auto &[field, values] : fields) {
        names += (names.empty() ? "" : ", ") + inQuotes(field);
    }
    return {faultAt(source, 0, "no-field", "there are no nodal values named " + inQuotes(name),
                    names.empty() ? "the file holds no nodal values with one component" : "the file holds " + names)};
}

} // namespace

Result<MeshField> meshWithField(MeshFields fields, std::string_view name, const SourceText &source) {
    const auto found = fields.fields.find(std::string(name));
    if (found == fields.fields.end()) {
        return noField(fields.fields, name, source);
    }
    MeshField field{std::move(fields.mesh), std::move(found->second)};
    if (field.values.size() != field.mesh.nodes.size()) {
        return Diagnostics{faultAt(source, 0, "bad-values",
                                   "the field " + inQuotes(name) + " has " + std::to_string(field.values.size()) +
                                       " values for " + std::to_string(field.mesh.nodes.size()) + " nodes")};
    }
    for (const CellBlock &block : field.mesh.blocks) {
        for (const NodeId node : block.connectivity()) {
            if (!std::isfinite(field.values[index(node)])) {
                Diagnostic fault =
                    faultAt(source, 0, "bad-values", "the field " + inQuotes(name) + " has no finite value at a node");
                fault.at = field.mesh.nodes[index(node)];
                return Diagnostics{fault};
            }
        }
    }
    for (double &value : field.values) {
        value = std::isfinite(value) ? value : 0.0; // of nodes without elements
    }
    return field;
}

} // namespace forefront
