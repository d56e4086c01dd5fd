#pragma once

#include "core/drawing/names/name_commands.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

struct Shell;

/// The rows of the inspector for what the mesher makes of a part of the boundary or of an inner line.
class PartRows {
  public:
    /// Draws the boundary layers of a part of the outer boundary or of a hole, and the part that it is periodic with:
    /// in the workspace Size, and wherever the part has some.
    void drawBoundary(Shell &context, std::int32_t tag, const BoundaryPart &part);
    /// Draws whether an inner line is a crack or a strip.
    static void drawLine(Shell &context, std::int32_t tag, const BoundaryPart &part);

  private:
    void drawPeriodic(Shell &context, std::int32_t tag, const BoundaryPart &part);

    std::vector<std::int32_t> parts_; ///< tags of boundaries, ascending, of the document with revision_
    std::uint64_t revision_ = 0;
};

/// Draws the elements that a region has of its own.
void regionElementsRow(Shell &context, std::int32_t region);

} // namespace forefront
