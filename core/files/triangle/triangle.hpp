#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/common/domain_file.hpp"
#include "core/files/source/export_options.hpp"
#include "core/files/source/source.hpp"
#include "core/files/text/file_set.hpp"

#include <array>
#include <filesystem>
#include <vector>

namespace forefront {

/// Reads a .node or .ele file with the other one beside it, and an .edge file if there is one.
Result<Mesh> readTriangle(const SourceText &source);
/// Reads a mesh from the texts of its files; `edges` may be null.
Result<Mesh> readTriangleParts(const SourceText &nodes, const SourceText &elements, const SourceText *edges);
/// Extensions of the files that writeTriangle writes side by side: nodes, elements, tagged edges.
inline constexpr std::array<const char *, 3> kTriangleExtensions{".node", ".ele", ".edge"};
/// Adds PATH.node, PATH.ele and PATH.edge to a set of files. A comment in each names the mesh, so that files of
/// different meshes are not read as one.
Status writeTriangle(FileSet &files, const std::filesystem::path &path, const MeshView &mesh,
                     const ExportOptions &options, const Progress &progress);

/// Reads a .poly file: nodes, segments, holes and regions, with their markers and attributes, and maximum areas.
Result<DomainFile> readPoly(const SourceText &source);
/// Returns the .node file beside a .poly file if that holds its nodes.
std::vector<std::filesystem::path> filesBesidePoly(const std::filesystem::path &poly);

} // namespace forefront
