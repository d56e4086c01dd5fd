#include "core/files/files.hpp"

#include "core/engine/base/length_unit.hpp"
#include "core/engine/base/letter_case.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/files/common/solid_mesh.hpp"
#include "core/files/common/tagged_cells.hpp"
#include "core/files/format.hpp"
#include "core/files/named_faults.hpp"

#include <new>
#include <string>
#include <utility>

namespace forefront {

namespace {

bool writesMesh(const Format &format) {
    return format.canWriteMesh();
}

/// Returns the format for writing a mesh; null if there is none.
const Format *meshFormat(const std::filesystem::path &path, std::string_view id) {
    const FormatList &list = engineFormats();
    const Format *format = id.empty() ? list.ofExtension(path, writesMesh) : list.ofId(id);
    return format != nullptr && format->canWriteMesh() ? format : nullptr;
}

/// Writes a mesh, extruded if the options say so.
void writeText(const Format &format, const MeshView &mesh, const ExportOptions &options, TextWriter &out) {
    if (options.extrusion) {
        SolidMesh solid(mesh, *options.extrusion);
        solid.unit = options.unit;
        format.writeSolid(solid, out);
    } else {
        format.write(mesh, options, out);
    }
}

Diagnostic exportNote(const char *code, std::string message) {
    Diagnostic note;
    note.severity = Severity::Note;
    note.code = code;
    note.message = std::move(message);
    return note;
}

} // namespace

Result<DomainFile> readDomain(const std::filesystem::path &path, const ImportOptions &options, ImportNotes *notes) {
    return engineFormats().readDomain(path, options, notes);
}

Result<Mesh> readMesh(const std::filesystem::path &path, const ImportOptions &options, ImportNotes *notes) {
    return engineFormats().readMesh(path, options, notes);
}

Result<MeshFields> readFields(const std::filesystem::path &path, const ImportOptions &options, ImportNotes *notes) {
    return engineFormats().readFields(path, options, notes);
}

Result<MeshField> readField(const std::filesystem::path &path, std::string_view name, const ImportOptions &options,
                            ImportNotes *notes) {
    return engineFormats().readField(path, name, options, notes);
}

Result<SpacingSpec> readSpacing(const std::filesystem::path &path, const ImportOptions &options, ImportNotes *notes) {
    return engineFormats().readSpacing(path, options, notes);
}

Status writeMesh(FileSet &files, const std::filesystem::path &path, const MeshView &mesh, std::string_view formatId,
                 const Progress &progress, const ExportOptions &options) {
    const Format *format = meshFormat(path, formatId);
    if (format == nullptr) {
        return named(error("unknown-format",
                           formatId.empty() ? "unknown extension '" + path.extension().string() + "' of a mesh file"
                                            : "unknown mesh format '" + std::string(formatId) + "'",
                           "expected one of " + (formatId.empty() ? engineFormats().extensions(writesMesh)
                                                                  : engineFormats().ids(writesMesh))),
                     path);
    }
    if (Status refused = checkExport(format->about, mesh, options); !refused.empty()) {
        return named(std::move(refused), path);
    }
    try {
        if (format->writeFiles != nullptr) {
            return named(format->writeFiles(files, path, mesh, options, progress), path);
        }
        constexpr std::size_t kBytesPerNode = 45, kBytesPerElement = 32;
        files.write(
            path, [&](TextWriter &out) { writeText(*format, mesh, options, out); }, progress,
            1 + mesh.nodes.size() * kBytesPerNode + nodesOfElements(mesh) / 3 * kBytesPerElement);
        return files.status();
    } catch (const std::bad_alloc &) {
        return named(error("out-of-memory", "not enough memory to write the file"), path);
    }
}

Status writeMesh(const std::filesystem::path &path, const MeshView &mesh, std::string_view formatId,
                 const Progress &progress, const ExportOptions &options) {
    FileSet files;
    Status status = writeMesh(files, path, mesh, formatId, progress, options);
    return status.empty() ? files.commit() : status;
}

Status writeMesh(ByteSink &sink, const MeshView &mesh, std::string_view formatId, const ExportOptions &options) {
    const Format *const format = engineFormats().ofId(formatId);
    if (format == nullptr || !format->writesText()) {
        return error("unknown-format",
                     format == nullptr ? "unknown mesh format '" + std::string(formatId) + "'"
                                       : std::string(format->about.name) + " cannot be written to a stream",
                     "expected one of " + engineFormats().ids([](const Format &f) { return f.writesText(); }));
    }
    if (Status refused = checkExport(format->about, mesh, options); !refused.empty()) {
        return refused;
    }
    TextWriter out(sink);
    writeText(*format, mesh, options, out);
    return out.flush() ? Status{} : error("cannot-write", "cannot write to the stream");
}

Diagnostics exportNotes(const std::filesystem::path &path, const MeshView &mesh, std::string_view formatId,
                        const ExportOptions &options) {
    const Format *const format = meshFormat(path, formatId);
    if (format == nullptr) {
        return {};
    }
    const bool solid = options.extrusion || format->about.solidsOnly;
    const auto note = options.keepTags && format->about.tellsTagsApart ? format->noteKeptChanges : format->noteChanges;
    Diagnostics notes = note != nullptr ? note(mesh) : Diagnostics{};
    if (solid && !mesh.points.empty()) {
        notes.push_back(exportNote("points-left-out", countText(mesh.points.size(), "tagged point") +
                                                          (mesh.points.size() == 1 ? " is" : " are") +
                                                          " left out of the extruded mesh"));
    }
    if (!mesh.elevations.empty() && (solid || !format->about.holdsElevations)) {
        notes.push_back(exportNote("elevation-left-out", solid ? "the elevations of the nodes are left out of the "
                                                                 "extruded mesh"
                                                               : "the format holds no elevations of nodes; they are "
                                                                 "left out"));
    }
    if (format->about.saysMetres && options.unit != LengthUnit::None && options.unit != LengthUnit::Metre) {
        notes.push_back(exportNote("says-metres", "the file says that it is in metres; the coordinates are in " +
                                                      std::string(wordOf(options.unit))));
    }
    return named(std::move(notes), path);
}

bool acceptsInnerEdges(const std::filesystem::path &path, std::string_view formatId) {
    const Format *const format = meshFormat(path, formatId);
    return format == nullptr || format->about.acceptsInnerEdges;
}

bool hasOpenBoundaries(const std::filesystem::path &path, std::string_view formatId) {
    const Format *const format = meshFormat(path, formatId);
    return format != nullptr && format->about.hasOpenBoundaries;
}

bool solidsOnly(const std::filesystem::path &path, std::string_view formatId) {
    const Format *const format = meshFormat(path, formatId);
    return format != nullptr && format->about.solidsOnly;
}

Numbering usualNumbering(const std::filesystem::path &path, std::string_view formatId) {
    const Format *const format = meshFormat(path, formatId);
    return format != nullptr && format->about.keepsCreation ? Numbering::Creation : Numbering::ReverseCuthillMcKee;
}

std::vector<std::filesystem::path> filesOfMesh(const std::filesystem::path &path, std::string_view formatId) {
    const Format *format = meshFormat(path, formatId);
    if (format == nullptr || (format->about.files.empty() && format->about.folder.empty())) {
        return {path};
    }
    std::vector<std::filesystem::path> files;
    for (const char *name : format->about.folder) {
        files.push_back(path / name);
    }
    for (const char *extension : format->about.files) {
        files.push_back(path);
        if (lowerCase(path.extension().string()) != extension) { // A.SLF stays as it is
            files.back().replace_extension(extension);
        }
    }
    return files;
}

std::vector<std::filesystem::path> filesRead(const std::filesystem::path &path) {
    std::vector<std::filesystem::path> files = filesOfMesh(path);
    const Format *const format =
        engineFormats().ofExtension(path, [](const Format &each) { return each.filesBeside != nullptr; });
    if (format != nullptr) {
        const std::vector<std::filesystem::path> beside = format->filesBeside(path);
        files.insert(files.end(), beside.begin(), beside.end());
    }
    return files;
}

Status checkPlace(const std::filesystem::path &path) {
    std::error_code none;
    const std::filesystem::path folder = path.parent_path();
    if (path.empty()) {
        return error("cannot-write", "the path has no file name", "add one");
    }
    if (std::filesystem::is_directory(path, none)) {
        return error("cannot-write", "cannot write the file: it is a folder", "name a file in it");
    }
    if (!folder.empty() && !std::filesystem::is_directory(folder, none)) {
        return error("cannot-write", "cannot write the file: folder " + folder.string() + " not found",
                     "create it, or choose another");
    }
    return checkReplaceable(path);
}

Status checkPlace(const std::filesystem::path &path, std::string_view formatId) {
    const Format *const format = meshFormat(path, formatId);
    std::error_code none;
    if (format != nullptr && !format->about.folder.empty() && std::filesystem::exists(path, none)) {
        return std::filesystem::is_directory(path, none)
                   ? Status{}
                   : error("cannot-write", "cannot write the folder: a file has its name", "choose another name");
    }
    return checkPlace(path);
}

} // namespace forefront
