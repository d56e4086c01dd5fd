#pragma once

#include "core/arrangement/change.hpp"
#include "core/arrangement/snap.hpp"

#include <span>

namespace forefront {

/// Adds to `changes` how the paths of the lines differ from the lines: ends that moved, nodes at crossings, nodes on
/// and near lines, lines shorter than the radius. The pieces are the indices of the lines.
void noteSnapping(std::span<const SnapLine> lines, const SnappedLines &snapped, ChangeList &changes);

/// Returns the node that the second end of a line became.
std::uint32_t lastNode(const SnappedLines &snapped, std::uint32_t line);

} // namespace forefront
