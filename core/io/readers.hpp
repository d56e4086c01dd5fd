#pragma once

#include "core/io/source.hpp"
#include "core/io/text/text_writer.hpp"

#include <array>

namespace forefront {

// The readers and writers proper, from and to memory; each format lives in a file of its own. Every fault carries its
// place in the source.

Result<Document> readProjectText(const SourceText &source);
bool looksLikeProject(std::string_view head);
Result<SpacingSpec> readProjectSpacing(const SourceText &source);

Result<Mesh> readMsh(const SourceText &source);
Result<SpacingSpec> readMshSpacing(const SourceText &source);
Result<MeshField> readMshField(const SourceText &source, std::string_view name);
bool looksLikeMsh(std::string_view head);
void writeMsh2(const Mesh &mesh, TextWriter &out);
void writeMsh4(const Mesh &mesh, TextWriter &out);
void writeMsh4Binary(const Mesh &mesh, TextWriter &out);
Diagnostics noteMshChanges(const Mesh &mesh);

Result<Mesh> readVtu(const SourceText &source);
Result<MeshField> readVtuField(const SourceText &source, std::string_view name);
bool looksLikeVtu(std::string_view head);
void writeVtu(const Mesh &mesh, TextWriter &out);

Result<Mesh> readVtk(const SourceText &source);
Result<MeshField> readVtkField(const SourceText &source, std::string_view name);
bool looksLikeVtk(std::string_view head);
void writeVtk(const Mesh &mesh, TextWriter &out);

Result<Mesh> readMedit(const SourceText &source);
bool looksLikeMedit(std::string_view head);
void writeMedit(const Mesh &mesh, TextWriter &out);

Result<Mesh> readAbaqus(const SourceText &source);
bool looksLikeAbaqus(std::string_view head);
void writeAbaqus(const Mesh &mesh, TextWriter &out);
Diagnostics noteAbaqusChanges(const Mesh &mesh);

Result<Mesh> readSu2(const SourceText &source);
bool looksLikeSu2(std::string_view head);
void writeSu2(const Mesh &mesh, TextWriter &out);
Diagnostics noteSu2Changes(const Mesh &mesh);

Result<Mesh> readObj(const SourceText &source);
void writeObj(const Mesh &mesh, TextWriter &out);
Diagnostics noteObjChanges(const Mesh &mesh);

/// A .node or .ele file; the other one, and an .edge file if there is one, stand beside it.
Result<Mesh> readTriangle(const SourceText &source);
/// `edges` may be null.
Result<Mesh> readTriangleParts(const SourceText &nodes, const SourceText &elements, const SourceText *edges);
/// Extensions of the files that writeTriangle writes side by side: nodes, elements, tagged edges.
inline constexpr std::array<const char *, 3> kTriangleExtensions{".node", ".ele", ".edge"};
Status writeTriangle(const std::filesystem::path &path, const Mesh &mesh, const Progress &progress);

void writeSvg(const Mesh &mesh, TextWriter &out);

Result<Domain> readPoly(const SourceText &source);
/// True if the .node file beside it has the nodes.
bool takesNodesFromBeside(const SourceText &poly);
Result<Domain> readGeoJson(const SourceText &source);
bool looksLikeGeoJson(std::string_view head);
Result<Domain> readSvg(const SourceText &source);
bool looksLikeSvg(std::string_view head);

} // namespace forefront
