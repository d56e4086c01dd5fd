#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/mesh/tri_mesh.hpp"
#include "core/files/common/mesh_field.hpp"
#include "core/files/format.hpp"
#include "core/files/source/source.hpp"
#include "core/files/text/text_writer.hpp"
#include "tests/support/temporary_folder.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace forefront::testing {

/// Returns a document that uses every field of the project file.
Document fullDocument();

/// Returns a mesh with two regions (tags 2 and 5) and an interface, four named boundary parts, a constraint edge that
/// ends inside, a tagged point, numbers with many digits and names with blanks, quotes and umlauts. Every edge of the
/// boundary is tagged.
TriMesh twoRegionMesh(std::size_t columns = 8, std::size_t rows = 5);

/// Returns the differences between two meshes in nodes, elements, regions, edges, points or names; empty if they are
/// equal.
std::string difference(const TriMesh &a, const TriMesh &b);

/// Moves the nodes of a mesh that was read back to those of the mesh that was written where they differ by rounding
/// only, if the notes of the export tell of rounded coordinates.
void undoRounding(TriMesh &back, const TriMesh &mesh, const Diagnostics &notes);

/// Returns the text that a format writes for a mesh.
std::string written(void (*write)(const MeshView &, TextWriter &), const MeshView &mesh);
std::string written(const Format &format, const MeshView &mesh);

/// Returns source text for a reader, without a file.
inline SourceText sourceOf(std::string_view text, std::string name = "memory") {
    return {text, std::move(name), {}, {}};
}

/// Returns all messages of a list, one per line.
std::string messages(const Diagnostics &faults);

/// Returns true if every error names its file and line.
bool allLocated(const Diagnostics &faults);

/// Returns a mesh as read with its elements, which must all be triangles of 3 nodes.
inline Result<TriMesh> triangles(Result<Mesh> read) {
    return read ? Result<TriMesh>(takeTriMesh(std::move(*read))) : read.faults();
}

/// Reads the nodal values of that name.
inline Result<MeshField> fieldIn(Result<MeshFields> (*read)(const SourceText &), const SourceText &source,
                                 std::string_view name) {
    Result<MeshFields> fields = read(source);
    return fields ? meshWithField(std::move(*fields), name, source) : fields.faults();
}

} // namespace forefront::testing
