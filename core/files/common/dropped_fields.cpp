#include "core/files/common/dropped_fields.hpp"

#include "core/files/common/names.hpp"

#include <vector>

namespace forefront {

std::string droppedFields(const MeshFields &file) {
    constexpr std::size_t kListed = 8;
    std::vector<std::string> names;
    for (const NamedFields *fields : {&file.fields, &file.elementFields}) {
        for (const auto &[name, values] : *fields) {
            names.push_back(name);
        }
    }
    return names.empty() ? std::string() : "values of nodes and elements are left out: " + listed(names, kListed);
}

} // namespace forefront
