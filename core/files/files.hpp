#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/mesh/numbering.hpp"
#include "core/engine/mesh/tri_mesh.hpp"
#include "core/files/common/usual_extrusion.hpp"
#include "core/files/format_list.hpp"
#include "core/files/source/export_options.hpp"
#include "core/files/text/atomic_file.hpp"
#include "core/files/text/file_set.hpp"

#include <filesystem>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

/// Reads a domain with its element sizes: Triangle .poly, or the outline of a mesh. Parameters and faults as for
/// FormatList.
Result<DomainFile> readDomain(const std::filesystem::path &path, const ImportOptions &options = {},
                              ImportNotes *notes = nullptr);
/// Reads a mesh: MSH 2.2 (ASCII) or 4.1, VTU, VTK legacy, MEDIT, Abaqus, MFEM, SU2, UNV, Nastran, 2DM, Triangle
/// .node/.ele, OBJ, Netgen.
Result<Mesh> readMesh(const std::filesystem::path &path, const ImportOptions &options = {},
                      ImportNotes *notes = nullptr);
/// Reads a mesh and all its values of nodes and elements, see FormatList::readFields().
Result<MeshFields> readFields(const std::filesystem::path &path, const ImportOptions &options = {},
                              ImportNotes *notes = nullptr);
/// Reads a mesh and the nodal values with this name, see FormatList::readField().
Result<MeshField> readField(const std::filesystem::path &path, std::string_view name, const ImportOptions &options = {},
                            ImportNotes *notes = nullptr);
/// Reads a spacing: a background mesh with nodal values, a grid of sizes, or a picture.
Result<SpacingSpec> readSpacing(const std::filesystem::path &path, const ImportOptions &options = {},
                                ImportNotes *notes = nullptr);

/// Read as above from memory, see FormatList.
Result<DomainFile> readDomain(MemoryFile file, const ImportOptions &options = {}, ImportNotes *notes = nullptr);
Result<Mesh> readMesh(MemoryFile file, const ImportOptions &options = {}, ImportNotes *notes = nullptr);
Result<MeshFields> readFields(MemoryFile file, const ImportOptions &options = {}, ImportNotes *notes = nullptr);
Result<SpacingSpec> readSpacing(MemoryFile file, const ImportOptions &options = {}, ImportNotes *notes = nullptr);

/// Writes a mesh in the format with this id or, if the id is empty, by the extension (.msh is MSH 2.2). Atomic: writes
/// a temporary file beside it, then renames that. Triangle: PATH.node, PATH.ele and PATH.edge, all of them or none. SVG
/// draws the mesh. Faults: unknown-format; unsupported-elements, as checkElements() returns it, before anything is
/// written; cannot-write; cancelled.
Status writeMesh(const std::filesystem::path &path, const MeshView &mesh, std::string_view formatId = {},
                 const Progress &progress = {}, const ExportOptions &options = {});
/// Does the same for a file, or several, that get their names with the set. Returns the faults of the set.
Status writeMesh(FileSet &files, const std::filesystem::path &path, const MeshView &mesh,
                 std::string_view formatId = {}, const Progress &progress = {}, const ExportOptions &options = {});
/// Writes a mesh in the format with this id to a sink, such as standard output. Faults: unknown-format, also for
/// formats of several files; unsupported-elements; cannot-write.
Status writeMesh(ByteSink &sink, const MeshView &mesh, std::string_view formatId, const ExportOptions &options = {});

/// Returns the fault "unsupported-elements" if files of a format cannot hold all elements and edges of a mesh; it names
/// the kinds that they lack and the formats that hold all of them.
Status checkElements(const FileFormat &format, const MeshView &mesh);

/// Returns the fault "unsupported-elements" as checkElements() does, or "unsupported-extrusion" if the format holds no
/// prisms and hexahedra, or the elements to be extruded are not of first order.
Status checkExport(const FileFormat &format, const MeshView &mesh, const ExportOptions &options);

/// Returns notes on the tag names of the mesh that the format changes, such as to identifiers, and on parts that it
/// does not hold, such as elevations; empty if there are none. Parameters as for writeMesh().
Diagnostics exportNotes(const std::filesystem::path &path, const MeshView &mesh, std::string_view formatId = {},
                        const ExportOptions &options = {});

/// Returns true unless programs would take tagged edges inside the domain for boundaries in a file that writeMesh
/// writes, so that it should be written withoutInnerEdges(). Parameters as for writeMesh().
bool acceptsInnerEdges(const std::filesystem::path &path, std::string_view formatId = {});

/// Returns true if a file that writeMesh writes tells open boundaries from land. Parameters as for writeMesh().
bool hasOpenBoundaries(const std::filesystem::path &path, std::string_view formatId = {});

/// Returns true if a mesh that writeMesh writes consists of prisms and hexahedra, whether it is extruded or not, as for
/// OpenFOAM. Parameters as for writeMesh().
bool solidsOnly(const std::filesystem::path &path, std::string_view formatId = {});

/// Returns the numbering of nodes and elements that suits the readers of a file: for a small bandwidth, except where
/// they expect the nodes of the input first, as Triangle's do. Parameters as for writeMesh().
Numbering usualNumbering(const std::filesystem::path &path, std::string_view formatId = {});

/// Returns the files that writeMesh writes under a name: one, the three of Triangle, or those in the folder of
/// OpenFOAM.
std::vector<std::filesystem::path> filesOfMesh(const std::filesystem::path &path, std::string_view formatId = {});
/// Returns the files that reading `path` may open: that file, the other files of a Triangle mesh, and the .node file
/// beside a .poly file that contains no nodes.
std::vector<std::filesystem::path> filesRead(const std::filesystem::path &path);
/// Returns the reason why no file can be written at this path, as far as can be determined without trying: the path has
/// no file name, is a folder, lies in a folder that does not exist, or is write-protected. The fault does not name the
/// file.
Status checkPlace(const std::filesystem::path &path);
/// Does the same for a mesh that writeMesh writes; some formats make a folder, which may exist.
Status checkPlace(const std::filesystem::path &path, std::string_view formatId);

} // namespace forefront
