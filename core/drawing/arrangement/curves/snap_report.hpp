#pragma once

#include "core/drawing/arrangement/change.hpp"
#include "core/drawing/arrangement/curves/joined_lines.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Adds to `changes` how the paths of the lines differ from the given ones: ends that moved, nodes at crossings, nodes
/// on and near lines, lines shorter than the radius. The pieces are indices of joined lines. `aside`: per given line,
/// true if changes to it, and its effects on other lines, are not reported; empty: none.
void noteJoining(const JoinedLines &joined, ChangeList &changes, const std::vector<std::uint8_t> &aside = {});

/// Returns the node that the second end of a line became.
std::uint32_t lastNode(const SnappedLines &snapped, std::uint32_t line);

} // namespace forefront
