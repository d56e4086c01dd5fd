#pragma once

#include "core/domain/domain.hpp"

#include <cstddef>

namespace forefront {

/// Makes lines that form closed loops the boundary of a domain that has none. Returns the number of segments that
/// became boundary: 0 if the lines enclose nothing or the domain already has a boundary. Some programs export outlines
/// as separate lines, and without this such a domain would be refused. Inside and outside follow the even-odd rule;
/// where three or more lines meet at a node, the outermost ones become boundary and the others stay constraints.
std::size_t takeLinesAsOutline(Domain &domain);

} // namespace forefront
