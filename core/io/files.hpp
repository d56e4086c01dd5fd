#pragma once

#include "core/base/api.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/domain/domain.hpp"
#include "core/edit/document.hpp"
#include "core/mesh/mesh.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

struct ImportOptions {
    double curveTolerance =
        0.0; ///< greatest distance between a curve and its polyline, in file units; 0: 1/2000 of the drawing's size
    std::size_t maxBytes = std::size_t{2} << 30; ///< larger files are refused
};

/// A file format the program reads or writes.
struct FileFormat {
    const char *id;        ///< "msh2", "msh41", "vtu", ... as used by --format and in menus
    const char *name;      ///< "Gmsh MSH 2.2"
    const char *extension; ///< with the dot, ".msh"
    bool readsDomain, readsMesh, writesMesh;
};
std::span<const FileFormat> fileFormats();
/// The formats that go by the extension of a path, in the order of preference.
std::vector<const FileFormat *> fileFormatsNamed(const std::filesystem::path &path);
/// The format of a file by its first bytes, else by its extension; null where neither tells.
const FileFormat *fileFormatOf(const std::filesystem::path &path);

/// Own project file or any domain format, by extension and content: .json/.forefront project, GeoJSON, .poly/.node,
/// .svg, .msh (its boundary). Faults carry file and line (or byte) and never depend on trusting a count in the file.
Result<Document> readDocument(const std::filesystem::path &path, const ImportOptions &options = {});
/// Domain of any file that readDocument reads.
Result<Domain> readDomain(const std::filesystem::path &path, const ImportOptions &options = {});
/// Faults of the domain that readDomain gave of this file, as its author wants them: with the file's name and, where
/// the format has such places (.poly, GeoJSON, SVG), with line and number of the parts. Reads the file once more.
/// Faults that name a file already stay as they are.
Diagnostics locateFaults(const std::filesystem::path &path, Diagnostics faults, const ImportOptions &options = {});
/// A mesh: MSH 2.2 (ASCII) or 4.1, VTU, VTK legacy, MEDIT, Abaqus, SU2, Triangle .node/.ele, OBJ.
Result<Mesh> readMesh(const std::filesystem::path &path, const ImportOptions &options = {});
/// A mesh with one value per node.
struct MeshField {
    Mesh mesh;
    std::vector<double> values;
};
/// A mesh and the nodal values of that name on it: point data of VTU and VTK legacy files, $NodeData of MSH.
Result<MeshField> readField(const std::filesystem::path &path, std::string_view name,
                            const ImportOptions &options = {});
/// Spacing from a background mesh file with nodal values (MSH $NodeData), or the spacing of a project file.
Result<SpacingSpec> readSpacing(const std::filesystem::path &path, const ImportOptions &options = {});

/// Writes a mesh; the format by id, or by extension when empty (.msh is MSH 2.2). Atomic: a temporary file beside it,
/// then renamed. Triangle: PATH.node, PATH.ele and PATH.edge. SVG draws the mesh. The result holds errors, else notes
/// on names that the format cannot hold as they are.
Status writeMesh(const std::filesystem::path &path, const Mesh &mesh, std::string_view formatId = {},
                 const Progress &progress = {});

/// The files that writeMesh writes under a name: that one, or those of Triangle side by side. `formatId` as there.
std::vector<std::filesystem::path> filesOfMesh(const std::filesystem::path &path, std::string_view formatId = {});
/// The files that reading one may look into: that one, those of Triangle side by side, and the .node file that a .poly
/// file without nodes takes them from.
std::vector<std::filesystem::path> filesRead(const std::filesystem::path &path);
/// Why no file can be written in this place, as far as it shows without trying: it has no name, is a folder, or lies in
/// one that does not exist. The fault does not name the file.
Status checkPlace(const std::filesystem::path &path);

/// Own project file, versioned JSON. Atomic.
Status writeProject(const std::filesystem::path &path, const Document &document);
/// The JSON text of a project and back; for the recovery journal and tests.
std::string projectText(const Document &document);
Result<Document> parseProject(std::string_view text, const std::string &fileName);

/// Writes bytes atomically: temporary file in the same folder, flushed, renamed.
Status writeFileAtomically(const std::filesystem::path &path, std::string_view bytes);

} // namespace forefront
