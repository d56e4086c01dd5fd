#pragma once

#include "core/base/api.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/domain/domain.hpp"
#include "core/edit/document.hpp"
#include "core/io/common/mesh_field.hpp"
#include "core/io/project/project.hpp"
#include "core/io/source/import_notes.hpp"
#include "core/io/source/import_options.hpp"
#include "core/io/text/atomic_file.hpp"
#include "core/mesh/mesh.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

/// A file format the program reads or writes.
struct FileFormat {
    const char *id;        ///< "msh2", "msh41", "vtu", ... as used by --format and in menus
    const char *name;      ///< "Gmsh MSH 2.2"
    const char *extension; ///< with the dot, ".msh"
    bool readsDomain, readsMesh, writesMesh;
    /// Its lines may cross, touch and overlap: reading arranges them (see ImportOptions::weldTolerance).
    bool arranges = false;
    /// Programs that read it accept tagged edges inside the domain, such as constraints and interfaces, rather than
    /// take each for a boundary.
    bool acceptsInnerEdges = true;
};
/// Returns all formats, in the order of menus.
std::span<const FileFormat> fileFormats();
/// Returns the formats with the extension of a path, in the order of preference.
std::vector<const FileFormat *> fileFormatsNamed(const std::filesystem::path &path);
/// Returns the format of a file by its first bytes, else by its extension; null if neither identifies it. Reads all of
/// a JSON file if its first bytes do not show what it is.
const FileFormat *fileFormatOf(const std::filesystem::path &path);
/// Returns the format of a file with this content, or else by its extension; null if neither identifies it.
const FileFormat *fileFormatOf(const std::filesystem::path &path, std::string_view content);

/// Reads a project file or any domain format, by extension and content: .json/.forefront project, GeoJSON, .poly, .svg,
/// or the outline of a mesh. Faults carry file and line (or byte) and never depend on trusting a count in the file.
/// `notes`: collects reports of anything in the file that is not used; may be null. If the file is refused, they also
/// follow its faults.
Result<Document> readDocument(const std::filesystem::path &path, const ImportOptions &options = {},
                              ImportNotes *notes = nullptr);
/// Reads the domain of any file that readDocument reads.
Result<Domain> readDomain(const std::filesystem::path &path, const ImportOptions &options = {},
                          ImportNotes *notes = nullptr);
/// Adds the file's name to the faults of a domain that readDomain read from it and, where the format has such places
/// (.poly, GeoJSON, SVG, project), line and number of the parts. Reads the file once more. Leaves faults that already
/// name a file unchanged.
Diagnostics locateFaults(const std::filesystem::path &path, Diagnostics faults, const ImportOptions &options = {});
/// Reads a mesh: MSH 2.2 (ASCII) or 4.1, VTU, VTK legacy, MEDIT, Abaqus, SU2, Triangle .node/.ele, OBJ, Netgen.
Result<Mesh> readMesh(const std::filesystem::path &path, const ImportOptions &options = {},
                      ImportNotes *notes = nullptr);
/// Reads a mesh and all its scalar values of nodes and elements: point and cell data of VTU and VTK legacy files,
/// $NodeData and $ElementData of MSH; none for other formats. Values are NaN where the file has none.
Result<MeshFields> readFields(const std::filesystem::path &path, const ImportOptions &options = {},
                              ImportNotes *notes = nullptr);
/// Reads a mesh and the nodal values with this name: point data of VTU and VTK legacy files, $NodeData of MSH.
Result<MeshField> readField(const std::filesystem::path &path, std::string_view name, const ImportOptions &options = {},
                            ImportNotes *notes = nullptr);
/// Reads a spacing: that of a project file, a background mesh with nodal values (MSH $NodeData), a grid of sizes (ESRI
/// ASCII grid), or the grey values of a picture (PNG, with ImportOptions::picture).
Result<SpacingSpec> readSpacing(const std::filesystem::path &path, const ImportOptions &options = {},
                                ImportNotes *notes = nullptr);

/// Writes a mesh in the format with this id or, if the id is empty, by the extension (.msh is MSH 2.2). Atomic: writes
/// a temporary file beside it, then renames that. Triangle: PATH.node, PATH.ele and PATH.edge. SVG draws the mesh.
Status writeMesh(const std::filesystem::path &path, const Mesh &mesh, std::string_view formatId = {},
                 const Progress &progress = {});
/// Writes a mesh in the format with this id to a sink, such as standard output. Faults: unknown-format, also for
/// formats of several files; cannot-write.
Status writeMesh(ByteSink &sink, const Mesh &mesh, std::string_view formatId);

/// Returns notes on the tag names of the mesh that the format changes, such as to identifiers; empty if there are none.
/// Parameters as for writeMesh().
Diagnostics exportNotes(const std::filesystem::path &path, const Mesh &mesh, std::string_view formatId = {});

/// Returns true unless programs would take tagged edges inside the domain for boundaries in a file that writeMesh
/// writes, so that it should be written withoutInnerEdges(). Parameters as for writeMesh().
bool acceptsInnerEdges(const std::filesystem::path &path, std::string_view formatId = {});

/// Returns the files that writeMesh writes under a name: one, or the three of Triangle.
std::vector<std::filesystem::path> filesOfMesh(const std::filesystem::path &path, std::string_view formatId = {});
/// Returns the files that reading `path` may open: that file, the other files of a Triangle mesh, and the .node file
/// beside a .poly file that contains no nodes.
std::vector<std::filesystem::path> filesRead(const std::filesystem::path &path);
/// Returns the reason why no file can be written at this path, as far as can be determined without trying: the path has
/// no file name, is a folder, or lies in a folder that does not exist. The fault does not name the file.
Status checkPlace(const std::filesystem::path &path);

} // namespace forefront
