#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/base/api.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "core/files/source/source.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace FOREFRONT_API forefront {

/// Reads Forefront's own project file. Every fault carries its place in the source.
Result<Document> readProjectText(const SourceText &source);
/// Reads the spacing of a project.
Result<SpacingSpec> readProjectSpacing(const SourceText &source);
/// Returns true if the first bytes of a file show that it is a project.
bool looksLikeProject(std::string_view head);

/// Writes a project file, versioned JSON, atomically. The path of the background picture becomes relative to its
/// folder. Faults: cannot-write; not-storable (a size function).
Status writeProject(const std::filesystem::path &path, const Document &document);
/// Returns the text that writeProject() writes to a file.
std::string projectFileText(const std::filesystem::path &path, const Document &document);
/// Returns the JSON text of a project, without a size function, with the absolute path of the background picture; for
/// the recovery journal and tests.
std::string projectText(const Document &document);
/// Reads the JSON text of a project; `fileName` appears in faults.
Result<Document> parseProject(std::string_view text, const std::string &fileName);

} // namespace forefront
