#pragma once

namespace forefront {

struct Workspace;

namespace ui {
class Flow;
}

/// Draws the options of the relations to other lines and nodes that a tool finds while one draws or drags: whether they
/// are found, and whether they become sketch constraints. For tools that find them only.
void drawRelationOptions(Workspace &context, ui::Flow &flow);

} // namespace forefront
