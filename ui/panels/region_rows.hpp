#pragma once

#include <cstdint>
#include <set>

namespace forefront {

struct Shell;

/// Draws the tag, the maximum area and the size of several regions, by their markers. A field whose number differs
/// between them is empty and says so.
void manyRegionsRows(Shell &context, const std::set<std::uint32_t> &markers);

} // namespace forefront
