#pragma once

#include "core/drawing/document/background_picture.hpp"
#include "core/files/json/json_check.hpp"
#include "core/files/json/json_text.hpp"

#include <filesystem>

namespace forefront {

/// Writes the member "picture" of a project. The path becomes relative to the folder of the file `project`, unless that
/// is empty.
void writePicture(const BackgroundPicture &picture, const std::filesystem::path &project, JsonText &out);
/// Reads this member. A path relative to the folder of the file `project` becomes absolute, unless that is empty.
/// Faults are added to `check`; that the picture itself is missing is none.
BackgroundPicture readPicture(const JsonValue &object, const std::filesystem::path &project, JsonCheck &check);

} // namespace forefront
