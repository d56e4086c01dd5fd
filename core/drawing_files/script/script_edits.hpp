#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing_files/script/script.hpp"
#include "core/engine/base/result.hpp"
#include "core/files/json/json_check.hpp"

namespace forefront {

/// Returns the document after a command that changes it: new, add, move, constrain, name, size, parameter, change.
/// Faults as for ScriptPlayer::play(), but those of core/drawing have no place yet.
Result<Document> editedDocument(const Document &document, const ScriptCommand &command, const SourceText &source);

} // namespace forefront
