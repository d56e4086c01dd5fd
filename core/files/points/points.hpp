#pragma once

#include "core/engine/base/result.hpp"
#include "core/files/common/domain_file.hpp"
#include "core/files/source/source.hpp"

namespace forefront {

/// Reads a table of points in CSV: paths of points, one a line, in two columns named x and y, or the first two if there
/// is no line of names. Cells are divided by commas, semicolons, tabs or blanks; with semicolons and tabs, decimal
/// commas are read, too. An empty line, or another value in a column named path, part or name, begins the next path,
/// and that value names it. Paths of three points or more are closed loops, loops inside others are holes; two points
/// are a constraint, one is a constraint point. Faults: bad-number, bad-count, bad-syntax, empty-domain.
Result<DomainFile> readCsv(const SourceText &source);

/// Reads the outline of an airfoil in one of the two layouts in use: Selig's, one list of points from the trailing edge
/// around the leading edge and back, or Lednicer's, with the upper and lower side from the leading edge on, after their
/// numbers of points. The first line is a name. Boundary parts are upper, lower and, if the trailing edge is blunt,
/// trailing_edge. Faults: bad-number, bad-count, bad-syntax.
Result<DomainFile> readAirfoil(const SourceText &source);

} // namespace forefront
