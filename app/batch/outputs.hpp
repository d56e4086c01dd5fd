#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/mesh/numbering.hpp"
#include "core/files/inner_edges.hpp"
#include "core/files/source/export_options.hpp"
#include "core/files/text/file_set.hpp"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// Returns the ids of the mesh formats that can be written, as --format accepts them, separated by commas.
std::string formatIds();

/// Returns the error in the format of an output; empty if it is valid. `id` is the value of --format; if it is empty,
/// the extension decides. The extension of one format is refused for the content of another, since it would mislead
/// readers; unknown extensions are fine for any format.
std::string checkFormat(const std::filesystem::path &output, const std::string &id);

/// A file to be written.
struct Output {
    std::filesystem::path path; ///< "-": standard output
    std::string format;         ///< id of a mesh format; empty: by the extension
};

/// Returns the first fault of the outputs and their formats, in order; empty if all are valid.
std::string checkFormats(const std::vector<std::filesystem::path> &outputs, const std::vector<std::string> &formats);
/// Pairs the outputs with their formats, in order.
std::vector<Output> pairFormats(const std::vector<std::filesystem::path> &outputs,
                                const std::vector<std::string> &formats);

/// Returns the faults of output paths that can be found before hours of work are spent: folders that do not exist,
/// paths that are folders, files that are given twice or are inputs.
Diagnostics checkOutputs(const std::vector<Output> &outputs, const std::vector<std::filesystem::path> &inputs = {});

/// Returns true if one of the outputs is standard output, which then receives nothing else.
bool usesStandardOutput(const std::vector<std::filesystem::path> &outputs);

/// How a mesh is written.
struct MeshForm {
    std::optional<InnerEdges> innerEdges; ///< absent: left out of the formats that do not accept them, with a note
    std::optional<Numbering> numbering;   ///< absent: the usual one of the format
    std::vector<std::string> open = {};   ///< names of the open boundary parts
    std::vector<std::int32_t> openOfProject = {}; ///< tags that are open without `open`
    std::optional<Extrusion> extrusion = {};
    bool keepTags = false;                     ///< see ExportOptions
    std::optional<std::string> elevation = {}; ///< a file or an expression
    std::optional<LengthUnit> unit = {}; ///< of the coordinates; absent: for mesh that of the input, for convert none
    MapSystem system = {};               ///< of the map that the mesh was made from
};

/// Writes a mesh to standard output and to files, which get their names when the set is committed. Stops at the first
/// error. Returns the errors or, if there are none, the notes of exportNotes() and of MeshForm.
Diagnostics writeOutputs(FileSet &files, const std::vector<Output> &outputs, const MeshView &mesh, const MeshForm &form,
                         const Progress &progress);

/// Does the same and commits the set: all files are written or none.
Diagnostics writeAndCommit(const std::vector<Output> &outputs, const MeshView &mesh, const MeshForm &form,
                           const Progress &progress);

/// Prints "wrote PATH" for each output that is a file.
void printWritten(const std::vector<std::filesystem::path> &outputs, std::FILE *stream);

/// Writes text to standard output. Fault: cannot-write, with the reason.
Status printText(std::string_view text);

} // namespace forefront
