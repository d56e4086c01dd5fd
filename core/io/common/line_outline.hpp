#pragma once

#include "core/domain/domain.hpp"

#include <cstddef>

namespace forefront {

/// Lets lines that chain into closed loops bound a domain that nothing else bounds, and returns the number of segments
/// that do; 0 where the lines enclose nothing or the domain has a boundary. Programs that export outlines as separate
/// lines mean this, and a domain without a boundary could only be refused. Loops bound by the even-odd rule; where
/// three or more lines meet in a node, the outermost of them bound and the others stay constraints.
std::size_t boundByLines(Domain &domain);

} // namespace forefront
