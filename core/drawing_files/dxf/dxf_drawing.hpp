#pragma once

#include "core/drawing_files/dxf/dxf_file.hpp"
#include "core/engine/geometry/curve.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace forefront {

/// A path of consecutive curves in DxfPaths::curves.
struct DxfPath {
    std::size_t first = 0, count = 0;
    bool closed = false;
    std::uint32_t layer = 0; ///< in DxfPaths::layers
    std::size_t offset = 0;  ///< of its entity in the text
};

struct DxfPaths {
    std::vector<Curve> curves; ///< in the coordinates of the model, blocks inserted
    std::vector<DxfPath> paths;
    std::vector<std::string> layers; ///< names of those with entities, in the order of the file
};

/// Returns the curves of the entities in the model. Notes name everything left out. Faults with their lines:
/// bad-number, bad-value, nested-block, too-large.
Result<DxfPaths> drawDxf(const DxfFile &file, const SourceText &source);

} // namespace forefront
