#pragma once

#include "app/batch/cli_options.hpp"
#include "app/batch/outputs.hpp"
#include "core/drawing_files/script/script.hpp"
#include "core/engine/base/result.hpp"

namespace forefront {

/// Returns the options of the command open of a script: "projection", "layer", "nameProperty", "sizeProperty" and
/// "weld", which mean what the options of the command mesh do. Faults: bad-value and those of JsonCheck, with places.
Result<DrawingArguments> openOptions(const ScriptCommand &command, const SourceText &source);

/// Returns what the command export of a script says on the mesh: its "open" boundary parts and its "elevation". A file
/// of elevations is relative to the folder of the script.
Result<MeshForm> exportForm(const ScriptCommand &command, const SourceText &source);

} // namespace forefront
