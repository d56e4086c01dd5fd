#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/references.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// A handle of a shape and its place; see handlesOf().
struct NodeRow {
    NodeRef node;
    Vec2 at;
};

/// Returns the handles of shapes, in the order of the document.
std::vector<NodeRow> nodeRows(const Document &document, const std::set<std::uint32_t> &shapes);

/// Returns rows as a table for a spreadsheet: a heading, then the id of the shape, the number of the node from 1, x and
/// y with all their digits, separated by tabs.
std::string nodeTableText(std::span<const NodeRow> rows);

/// Why a line of a table cannot be used.
struct TableFault {
    std::size_t line = 0; ///< from 0
    std::string reason;
};

/// The drawing with the nodes of a table, or why there is none.
struct NodeTableResult {
    std::optional<Document> next;     ///< joints not carried: see carryJoints()
    std::vector<TableFault> faults{}; ///< in the order of the lines
    std::string fault{};              ///< of the table as a whole
    std::size_t moved = 0;            ///< nodes that are elsewhere now
};

/// Moves nodes to the places in a table, whose lines are `lines`.
///
/// A heading names the columns: x and y, and maybe shape and node as nodeTableText() writes them; other columns are
/// ignored. Without a heading, there are two columns, x and y, or four in the order of nodeTableText(). Two columns are
/// the nodes of the only shape in `shapes`, one line for each; a path of straight segments without tags and sizes of
/// its own may get more or fewer. Columns are separated by tabs, semicolons, commas or blanks; unless by commas,
/// numbers may have decimal commas. A line without the separator of the others may have its own. Empty lines are left
/// out. Either all lines are used or none.
NodeTableResult placeNodes(const Document &document, const std::set<std::uint32_t> &shapes,
                           std::span<const std::string> lines);

/// Returns the lines of a text, without their ends.
std::vector<std::string> linesOf(std::string_view text);

} // namespace forefront
