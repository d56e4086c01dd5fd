#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/files/common/node_table.hpp"
#include "core/files/text/text_scanner.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// The node list of Triangle's .node and .poly files: "count 2 attributes markers", then "number x y ... [marker]".
struct TriangleNodes {
    std::vector<Vec2> places;
    std::vector<std::int32_t> markers; ///< as in the file; 1 where it has none
    NodeTable table;
    std::int64_t attributes = 0;      ///< per node, read but not kept
    std::vector<std::size_t> offsets; ///< of their lines; filled if the source asks for origins

    /// Reads the list; failures are recorded in the scanner. An empty list is allowed where the nodes may be in another
    /// file.
    bool read(TextScanner &scanner, bool mayBeEmpty);
};

} // namespace forefront
