#pragma once

#include "core/engine/base/length_unit.hpp"
#include "core/files/text/text_writer.hpp"

#include <cstdint>
#include <set>
#include <string>

namespace forefront {

/// Writes the unit of the coordinates as a comment.
inline void writeAbaqusUnit(LengthUnit unit, TextWriter &out) {
    if (unit != LengthUnit::None) {
        out << "** Unit of the coordinates: " << wordOf(unit) << '\n';
    }
}

/// Writes a comment that shows how a job uses a boundary part: holds its nodes in `directions` directions, or presses
/// on its surface.
inline void writeAbaqusUses(const std::string &nodes, const std::string &surface, int directions, TextWriter &out) {
    out << "** support: *BOUNDARY / " << nodes << ", 1, " << directions << "; load: *DSLOAD / " << surface
        << ", P, 1.\n";
}

/// Writes a node set; the indices ascend.
inline void writeAbaqusNodes(const std::string &name, const std::set<std::uint32_t> &nodes, TextWriter &out) {
    out << "*NSET, NSET=" << name << '\n';
    constexpr std::size_t kPerLine = 10;
    std::size_t column = 0;
    for (const std::uint32_t node : nodes) {
        out << node + std::uint64_t{1} << (++column % kPerLine == 0 || column == nodes.size() ? "\n" : ", ");
    }
}

} // namespace forefront
