#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/mesher/options.hpp"

#include <filesystem>
#include <string>

namespace FOREFRONT_API forefront {

/// Reads a project file, or the domain of any other format as a drawing: GeoJSON, TopoJSON, SVG, .poly, or the outline
/// of a mesh. Parameters and faults as for FormatList.
Result<Document> readDocument(const std::filesystem::path &path, const ImportOptions &options = {},
                              ImportNotes *notes = nullptr);

/// Returns jobOf() a document from a file. Its findings go to `notes`, which may be null. Faults: the errors among
/// them.
Result<MeshingJob> readJobOf(const Document &document, const std::string &file, ImportNotes *notes);

} // namespace forefront
