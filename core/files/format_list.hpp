#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/mesh/cell_set.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "core/files/common/domain_file.hpp"
#include "core/files/common/mesh_field.hpp"
#include "core/files/source/import_notes.hpp"
#include "core/files/source/import_options.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

struct Format;

/// The content of the files of a format.
enum class FileKind : std::uint8_t {
    Mesh,
    Domain,     ///< nodes and segments that form a valid domain
    Project,    ///< a document of the editor, with parameters
    Drawing,    ///< shapes on a page, with strokes
    CadDrawing, ///< lines and curves on layers, in a unit of length
    Map,        ///< features with properties, perhaps in degrees
    Grid,       ///< sizes at the points of a grid
    Picture     ///< grey values that stand for sizes
};

/// A file format the program reads or writes. Anything that differs between formats belongs here: no other code
/// compares ids.
struct FileFormat {
    const char *id;        ///< "msh2", "msh41", "vtu", ... as used by --format and in menus
    const char *name;      ///< "Gmsh MSH 2.2"
    const char *extension; ///< with the dot, ".msh"
    /// Further extensions, separated by blanks, such as ".node .ele".
    const char *otherExtensions = "";
    FileKind kind = FileKind::Mesh;
    bool readsDomain = false, readsMesh = false, writesMesh = false;
    bool readsSpacing = false;
    bool readsFields = false; ///< its meshes have values of nodes and elements
    bool readsCurves = false; ///< curves of its drawings become polylines within ImportOptions::curveTolerance
    bool hasLayers = false;   ///< a file has named layers, of which ImportOptions::layer chooses
    /// Programs that read it take the corners of all elements for counter-clockwise without looking.
    bool counterClockwise = false;
    /// The kinds of cells that its files hold. Meshes with others are not written.
    CellSet holds = {};
    /// Its lines may cross, touch and overlap: reading arranges them (see ImportOptions::weldTolerance).
    bool arranges = false;
    /// Programs that read it accept tagged edges inside the domain, such as constraints and interfaces, rather than
    /// take each for a boundary.
    bool acceptsInnerEdges = true;
    /// Its files are the same without the tagged edges inside the domain.
    bool dropsInnerEdges = false;
    /// Its files have no names of boundary parts, or of regions, not even as comments.
    bool dropsBoundaryNames = false, dropsRegionNames = false;
    /// Its files tell open boundaries from land, as ExportOptions::openBoundaries has them.
    bool hasOpenBoundaries = false;
    /// Its files have different numbers and names for boundary parts, regions and points, unless
    /// ExportOptions::keepTags is set.
    bool tellsTagsApart = false;
    /// Its readers expect the nodes of the input first, so that files keep the order of creation.
    bool keepsCreation = false;
    /// It holds prisms and hexahedra, which ExportOptions::extrusion makes of elements of first order.
    bool holdsSolids = false;
    /// It holds nothing else: without an extrusion, there is one layer of cells.
    bool solidsOnly = false;
    /// It holds elevations of nodes; see MeshView::elevations.
    bool holdsElevations = false;
    /// Its files name the unit of the coordinates; see ExportOptions::unit.
    bool namesUnit = false;
    /// Its files say that they are in metres, whatever the unit of the coordinates.
    bool saysMetres = false;
    /// All elements of a file are of one kind.
    bool oneElementKind = false;
    /// Extensions of the files that a mesh is written to, for formats of several files; empty: one file.
    std::span<const char *const> files = {};
    /// The component that reading and writing it needs, such as "gdal"; empty: none.
    const char *component = "";
    /// Paths of the files below the folder that a mesh is written to; empty: no folder.
    std::span<const char *const> folder = {};
    /// Programs that usually read it, as "Abaqus, CalculiX"; empty: it is not the preferred format of any.
    const char *program = "";
    const char *keeps = ""; ///< the parts of a mesh that a file stores, as a sentence; empty: unless meshes are written
};

/// A file in memory.
struct MemoryFile {
    std::string bytes;
    /// The id of a format, such as "msh2", or the name of a file, such as "plate.msh", whose extension counts where the
    /// content does not show the format. Messages name the file by it.
    std::string name = {};
};

/// File formats, and reading through them. Faults carry file and line (or byte) and never depend on trusting a count in
/// the file. Where `notes` is not null, it collects reports of anything in the file that is not used; if the file is
/// refused, they also follow its faults.
class FormatList {
  public:
    /// Formats in the order of menus and, where they share an extension, of preference; must outlive the list.
    constexpr explicit FormatList(std::span<const Format> formats) : formats_(formats) {}

    std::span<const Format> formats() const { return formats_; }
    /// Returns the descriptions of all formats, in the order of menus.
    std::vector<FileFormat> list() const;
    /// Returns the format of that id; null if there is none.
    const FileFormat *withId(std::string_view id) const;
    /// Returns the formats with the extension of a path, in the order of preference.
    std::vector<const FileFormat *> withExtensionOf(const std::filesystem::path &path) const;
    /// Returns the format of a file by its first bytes, else by its extension; null if neither identifies it. Reads all
    /// of a JSON file if its first bytes do not identify it, and nothing of a pipe or device.
    const FileFormat *detect(const std::filesystem::path &path) const;
    /// Returns the format of a file with this content, or else by its extension; null if neither identifies it.
    const FileFormat *detect(const std::filesystem::path &path, std::string_view content) const;

    /// Reads the domain of a file with its element sizes, or the outline of the mesh in it.
    Result<DomainFile> readDomain(const std::filesystem::path &path, const ImportOptions &options = {},
                                  ImportNotes *notes = nullptr) const;
    /// Adds the file's name to the faults of a domain that readDomain read from it and, where the format has such
    /// places
    /// (.poly, GeoJSON, SVG, DXF, project), line and number of the parts. Reads the file once more. Leaves faults that
    /// already name a file unchanged. Faults of the spacing expression get the place of that of the project.
    Diagnostics locateFaults(const std::filesystem::path &path, Diagnostics faults,
                             const ImportOptions &options = {}) const;
    /// Reads a mesh.
    Result<Mesh> readMesh(const std::filesystem::path &path, const ImportOptions &options = {},
                          ImportNotes *notes = nullptr) const;
    /// Reads a mesh and all its scalar values of nodes and elements: point and cell data of VTU and VTK legacy files,
    /// $NodeData and $ElementData of MSH, "elevation" of 2DM; none for other formats. Values are NaN where the file has
    /// none.
    Result<MeshFields> readFields(const std::filesystem::path &path, const ImportOptions &options = {},
                                  ImportNotes *notes = nullptr) const;
    /// Reads a mesh and the nodal values with this name: point data of VTU and VTK legacy files, $NodeData of MSH,
    /// "elevation" of 2DM.
    Result<MeshField> readField(const std::filesystem::path &path, std::string_view name,
                                const ImportOptions &options = {}, ImportNotes *notes = nullptr) const;
    /// Reads a spacing: the rules of a project file (its placed sizes come with its domain), a background mesh with
    /// nodal values (MSH $NodeData), a grid of sizes (ESRI ASCII grid), or the grey values of a picture (PNG, with
    /// ImportOptions::picture).
    Result<SpacingSpec> readSpacing(const std::filesystem::path &path, const ImportOptions &options = {},
                                    ImportNotes *notes = nullptr) const;

    /// Read as above from memory. Parts that a format keeps in a second file, such as the .ele file of Triangle, are
    /// missing.
    Result<DomainFile> readDomain(MemoryFile file, const ImportOptions &options = {},
                                  ImportNotes *notes = nullptr) const;
    Result<Mesh> readMesh(MemoryFile file, const ImportOptions &options = {}, ImportNotes *notes = nullptr) const;
    Result<MeshFields> readFields(MemoryFile file, const ImportOptions &options = {},
                                  ImportNotes *notes = nullptr) const;
    Result<SpacingSpec> readSpacing(MemoryFile file, const ImportOptions &options = {},
                                    ImportNotes *notes = nullptr) const;

    /// Returns the format that the first bytes of a file show, preferably one with the extension of the path; null if
    /// they show none.
    const Format *recognised(const std::filesystem::path &path, std::string_view head) const;
    /// Returns the format of a file by its content, else by its extension; null if neither identifies it.
    const Format *ofContent(const std::filesystem::path &path, std::string_view content) const;
    /// Returns the first format with the extension of a path for which `accepts` returns true; null if there is none.
    const Format *ofExtension(const std::filesystem::path &path, bool (*accepts)(const Format &)) const;
    /// Returns the format of that id; null if there is none.
    const Format *ofId(std::string_view id) const;
    /// Returns the extensions of the accepted formats, for messages.
    std::string extensions(bool (*accepts)(const Format &)) const;
    /// Returns all extensions of the accepted formats, each once, in the order of menus.
    std::vector<std::string> allExtensions(bool (*accepts)(const FileFormat &)) const;
    /// Returns the ids of the accepted formats, for messages.
    std::string ids(bool (*accepts)(const Format &)) const;

  private:
    std::span<const Format> formats_;
};

/// Returns the formats of meshes, of their outlines, and of valid domains. The formats of drawings, maps and projects
/// come with the drawing library.
const FormatList &engineFormats();

} // namespace forefront
