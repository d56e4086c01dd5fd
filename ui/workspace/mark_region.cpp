#include "ui/workspace/mark_region.hpp"

#include "core/drawing/commands/region_fill.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "ui/workspace/workspace.hpp"

#include <algorithm>
#include <memory>

namespace forefront {

std::int32_t tagOfNewRegion(const Document &document) {
    return std::max(2, freeRegionTag(document));
}

bool markRegion(Workspace &context, Vec2 place, std::int32_t tag) {
    const std::shared_ptr<const Document> before = context.document.current();
    if (!context.applyCommand(fillRegion(*before, place, tag), "Fill " + regionName(before->regionNames, tag))) {
        return false;
    }
    context.selection.clear();
    context.selection.markers.insert(static_cast<std::uint32_t>(context.document.current()->regionMarkers.size() - 1));
    return true;
}

} // namespace forefront
