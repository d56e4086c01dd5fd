#include "ui/shell/tool_slots.hpp"

#include "ui/parts/shown_panels.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace forefront::shell {

namespace {

/// The tools of a place, by id; each list is a group of places.
using SlotIds = std::vector<std::string_view>;

const std::vector<std::vector<SlotIds>> &groups() {
    static const std::vector<std::vector<SlotIds>> kGroups{
        {{"select"}},
        {{"polygon"}, {"rectangle", "circle", "ellipse", "regular", "slot"}, {"polyline", "arc"}, {"point"}},
        {{"trim"}, {"region"}},
        {{"brush"}, {"eraser"}, {"source"}, {"gradient"}},
        {{"measure"}, {"picture", "outline"}},
        {{"trace"}, {"probe"}, {"guess"}}};
    return kGroups;
}

} // namespace

std::vector<ToolSlot> toolSlots(const Shell &context) {
    const ToolBox &box = context.tools;
    std::vector<ToolSlot> slots;
    std::vector<bool> placed(box.tools.size());
    for (const std::vector<SlotIds> &group : groups()) {
        bool begins = !slots.empty();
        for (const SlotIds &ids : group) {
            ToolSlot slot{{}, begins};
            for (const std::string_view id : ids) {
                const auto found = std::find_if(box.tools.begin(), box.tools.end(),
                                                [id](const auto &tool) { return tool->id() == id; });
                if (found != box.tools.end()) {
                    const auto index = static_cast<std::size_t>(found - box.tools.begin());
                    placed[index] = true;
                    if (isInStrip(context, **found)) {
                        slot.tools.push_back(index);
                    }
                }
            }
            if (!slot.tools.empty()) {
                slots.push_back(std::move(slot));
                begins = false;
            }
        }
    }
    for (std::size_t k = 0; k < placed.size(); ++k) {
        if (!placed[k] && isInStrip(context, *box.tools[k])) {
            slots.push_back({{k}});
        }
    }
    return slots;
}

std::size_t shownTool(const ToolBox &box, const ToolSlot &slot) {
    const auto among = [&](std::size_t tool) {
        return std::find(slot.tools.begin(), slot.tools.end(), tool) != slot.tools.end();
    };
    if (among(box.active)) {
        return box.active;
    }
    const auto last = std::find_if(box.left.rbegin(), box.left.rend(), among);
    return last != box.left.rend() ? *last : slot.tools.front();
}

} // namespace forefront::shell
