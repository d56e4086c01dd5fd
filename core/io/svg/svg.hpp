#pragma once

#include "core/base/result.hpp"
#include "core/domain/domain.hpp"
#include "core/io/source/source.hpp"
#include "core/io/text/text_writer.hpp"
#include "core/mesh/mesh.hpp"

#include <string_view>

namespace forefront {

/// Reads the shapes of an SVG drawing. Closed outlines bound the domain by the even-odd rule, open ones are
/// constraints.
Result<Domain> readSvg(const SourceText &source);
/// Like readSvg(), but keeps the shapes as they are drawn: each has segments and nodes of its own, even where it meets
/// or overlaps another one, and nothing is dropped outside the domain. Shapes drawn twice are read once. A drawing
/// without closed outlines is read as by readSvg().
Result<Domain> readSvgShapes(const SourceText &source);
/// Returns true if the first bytes of a file show that it is SVG.
bool looksLikeSvg(std::string_view head);
/// Writes a drawing of the mesh: the elements of a region, or the edges of a boundary tag, are one path named by its
/// title, or several if there are many.
void writeSvg(const Mesh &mesh, TextWriter &out);

} // namespace forefront
