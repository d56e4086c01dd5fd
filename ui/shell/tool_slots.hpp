#pragma once

#include "ui/parts/shell.hpp"

#include <cstddef>
#include <vector>

namespace forefront::shell {

/// A place in the tool strip: a tool, or several of one kind, of which the one used last is shown.
struct ToolSlot {
    std::vector<std::size_t> tools; ///< indices into ToolBox::tools
    bool begins = false;            ///< a group, with a hairline above it

    bool hasFlyout() const { return tools.size() > 1; }
};

/// Returns the places of the strip from the top, with the tools of the workspace that is shown. A tool that is in no
/// group has its own place at the end.
std::vector<ToolSlot> toolSlots(const Shell &context);
/// Returns the tool that a place shows: the active one, or the one that was active last, or the first.
std::size_t shownTool(const ToolBox &box, const ToolSlot &slot);

} // namespace forefront::shell
