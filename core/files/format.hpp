#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/spacing/spec/raster.hpp"
#include "core/files/format_list.hpp"
#include "core/files/source/export_options.hpp"
#include "core/files/source/source.hpp"
#include "core/files/text/file_set.hpp"
#include "core/files/text/text_writer.hpp"

#include <filesystem>
#include <string_view>
#include <vector>

namespace forefront {

struct SolidMesh;

/// The functions of a file format. Readers work from memory and never throw; a null function means that the format does
/// not support it.
struct Format {
    FileFormat about;
    /// Returns true if the first bytes of a file (at most kHeadBytes) show that it is of this format.
    bool (*recognise)(std::string_view head) = nullptr;
    bool mayShowLate = false; ///< recognise() takes all of a JSON text where its first bytes show no format
    Result<DomainFile> (*readDomain)(const SourceText &) = nullptr; ///< null: the domain of its mesh, if it has one
    Result<Mesh> (*readMesh)(const SourceText &) = nullptr;
    Result<SpacingSpec> (*readSpacing)(const SourceText &) = nullptr;
    Result<Raster> (*readRaster)(const SourceText &) = nullptr;     ///< values of any sign
    Result<MeshFields> (*readFields)(const SourceText &) = nullptr; ///< null: holds no values
    void (*writeMesh)(const MeshView &, TextWriter &) = nullptr;
    /// Writes a mesh, in place of writeMesh, for formats in which the options change something; else
    /// null.
    void (*writeWith)(const MeshView &, const ExportOptions &, TextWriter &) = nullptr;
    /// Returns notes on changes that the format makes to the mesh, such as to names; null: it makes none.
    Diagnostics (*noteChanges)(const MeshView &) = nullptr;
    /// Returns the notes where ExportOptions::keepTags is set, for formats that tell tags apart.
    Diagnostics (*noteKeptChanges)(const MeshView &) = nullptr;
    /// Writes a mesh for formats of several files, which become complete with the set; else null.
    Status (*writeFiles)(FileSet &, const std::filesystem::path &, const MeshView &, const ExportOptions &,
                         const Progress &) = nullptr;
    /// Writes prisms and hexahedra; null: the format holds none, or writeFiles writes them.
    void (*writeSolid)(const SolidMesh &, TextWriter &) = nullptr;
    /// Returns further files that reading this one may open; null: none, or those of `about.files`.
    std::vector<std::filesystem::path> (*filesBeside)(const std::filesystem::path &) = nullptr;

    bool canReadDomain() const { return readDomain != nullptr || readMesh != nullptr; }
    bool canWriteMesh() const { return writesText() || writeFiles != nullptr; }
    /// Returns true if a mesh is one text, which can be written to any sink.
    bool writesText() const { return writeMesh != nullptr || writeWith != nullptr; }
    /// Writes a mesh as text.
    void write(const MeshView &mesh, const ExportOptions &options, TextWriter &out) const {
        writeWith != nullptr ? writeWith(mesh, options, out) : writeMesh(mesh, out);
    }
};

inline constexpr std::size_t kHeadBytes = 4096;

/// Returns the domain in a file of this format: the domain itself, or else the outline of its mesh.
Result<DomainFile> domainFrom(const Format &format, const SourceText &source);

} // namespace forefront
