#include "ui/workspace/mesh/file_fields.hpp"

#include <map>
#include <utility>

namespace forefront {

const std::vector<double> *FileFields::find(MeshPart part, const std::string &name) const {
    const NamedFields &fields = part == MeshPart::Nodes ? nodes : elements;
    const auto found = fields.find(name);
    return found == fields.end() ? nullptr : &found->second;
}

std::shared_ptr<const FileFields> takeFields(MeshFields &read) {
    const Mesh &mesh = read.mesh;
    std::erase_if(read.fields, [&](const auto &field) { return field.second.size() != mesh.nodes.size(); });
    std::erase_if(read.elementFields, [&](const auto &field) { return field.second.size() != mesh.elementCount(); });
    if (read.fields.empty() && read.elementFields.empty()) {
        return nullptr;
    }
    return std::make_shared<const FileFields>(FileFields{std::move(read.fields), std::move(read.elementFields)});
}

} // namespace forefront
