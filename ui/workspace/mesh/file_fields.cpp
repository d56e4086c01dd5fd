#include "ui/workspace/mesh/file_fields.hpp"

#include "core/engine/mesh/triangulated.hpp"

#include <map>
#include <utility>

namespace forefront {

const std::vector<double> *FileFields::find(MeshPart part, const std::string &name) const {
    const NamedFields &fields = part == MeshPart::Nodes ? nodes : elements;
    const auto found = fields.find(name);
    return found == fields.end() ? nullptr : &found->second;
}

TriMesh takeTriangles(MeshFields &read) {
    const std::size_t elements = read.mesh.elementCount();
    std::erase_if(read.elementFields, [&](const auto &field) { return field.second.size() != elements; });
    Triangulated parts = takeTriangulated(std::move(read.mesh));
    for (auto &[name, values] : read.elementFields) {
        values = parts.ofTriangles(std::move(values));
    }
    return std::move(parts.mesh);
}

std::shared_ptr<const FileFields> takeFields(MeshFields &read, const TriMesh &mesh) {
    std::erase_if(read.fields, [&](const auto &field) { return field.second.size() != mesh.nodes.size(); });
    std::erase_if(read.elementFields, [&](const auto &field) { return field.second.size() != mesh.elements.size(); });
    if (read.fields.empty() && read.elementFields.empty()) {
        return nullptr;
    }
    return std::make_shared<const FileFields>(FileFields{std::move(read.fields), std::move(read.elementFields)});
}

} // namespace forefront
