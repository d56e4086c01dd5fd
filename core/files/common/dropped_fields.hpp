#pragma once

#include "core/files/common/mesh_field.hpp"

#include <string>

namespace forefront {

inline constexpr const char *kDroppedFields = "dropped-fields"; ///< code of the note

/// Returns a note that names the values of a file where they are left out; empty if the file has none.
std::string droppedFields(const MeshFields &file);

} // namespace forefront
