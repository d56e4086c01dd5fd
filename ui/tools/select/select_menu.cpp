#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/common/region_menu.hpp"
#include "ui/tools/select/select_tool.hpp"
#include "ui/workspace/joined_command.hpp"
#include "ui/workspace/mark_region.hpp"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Returns a command that selects segments and runs an action on them.
ContextItem onSegments(std::string id, std::string title, std::set<SegmentRef> segments, const char *action) {
    return commandOf(std::move(id), std::move(title), [segments = std::move(segments), action](Shell &c) {
        c.selection.clear();
        c.selection.segments = segments;
        c.actions.run(action, c);
    });
}

/// Returns the commands on the segment under the pointer, which is not the selection: a click selects its shape.
ContextGroup segmentMenu(const Shape &shape, SegmentRef segment, Vec2 at) {
    ContextGroup group{headingOf("Segment")};
    if (isRound(shape)) {
        return {};
    }
    group.push_back(commandOf("segment/insert", "Insert node", [segment, at](Shell &c) {
        applyJoined(c, insertNode(*c.document.current(), segment, at), "Insert node");
    }));
    const Outline outline = outlineOf(shape);
    for (std::size_t k = 0; k < outline.segmentCount() && isPath(shape); ++k) {
        if (outline.part(k) == segment.segment) {
            const bool curved = outline.isCurved(k);
            group.push_back(commandOf("segment/form", curved ? "To line" : "To curve", [segment, curved](Shell &c) {
                c.applyCommand(setCurved(*c.document.current(), {segment}, !curved),
                               curved ? "Segment to line" : "Segment to curve");
            }));
            break;
        }
    }
    if (taggedSegments(shape) > 1) {
        group.push_back(onSegments("segmentTag", "Set tag of this segment\xe2\x80\xa6", {segment}, "edit.setTag"));
    }
    return group;
}

/// Returns commands that set the element size of each boundary part of a shape with several tags; the one of the
/// selection needs a single tag.
ContextGroup partSizes(const Document &document, const Shape &shape) {
    constexpr std::size_t kMaxParts = 6; // more would hide the other commands
    std::map<std::int32_t, std::set<SegmentRef>> parts;
    for (std::uint32_t k = 0; k < taggedSegments(shape); ++k) {
        parts[segmentTag(shape, k)].insert({shape.id, k});
    }
    ContextGroup group;
    for (const auto &[tag, segments] : parts) {
        if (parts.size() > 1 && group.size() < kMaxParts) {
            group.push_back(onSegments("partSize/" + std::to_string(tag),
                                       "Element size of " + boundaryName(document.boundaryNames, tag) + "\xe2\x80\xa6",
                                       segments, "edit.setSize"));
        }
    }
    return group;
}

} // namespace

/// Selects the item under the pointer, unless it already is selected, and requests the menu of the selection.
void SelectTool::openMenu(const CanvasEvent &event, Shell &context) {
    start_ = context.document.current();
    const Hit hit = hitAt(event.place, context, true);
    const bool free = hit.isFree();
    if (const std::optional<NamedThing> label = labelAt(context, event.pixel); label && free) {
        context.selection = selectionOf(*start_, *label);
    } else if (!isSelected(hit, context.selection)) {
        select(hit, false, context.selection);
    }
    std::vector<ContextGroup> groups = selectionMenu();
    const Selection &selection = context.selection;
    const bool whole = selection.size() == 1 && selection.shapes.contains(hit.shape);
    if (const Shape *const shape = whole ? findShape(*start_, hit.shape) : nullptr) {
        ContextGroup sizes = partSizes(*start_, *shape);
        groups.front().insert(groups.front().end(), sizes.begin(), sizes.end());
        if (hit.kind == Hit::Kind::Segment) {
            groups.insert(groups.begin() + 1, segmentMenu(*shape, hit.segment->ref, hit.segment->at));
        }
    }
    if (free && selection.markers.empty()) {
        groups.insert(groups.begin() + (selection.empty() ? 0 : 1),
                      regionMenu(context, event.place, hit.kind == Hit::Kind::Face, tagOfNewRegion(*start_)));
    }
    start_.reset();
    context.menu.open(std::move(groups));
}

} // namespace forefront
