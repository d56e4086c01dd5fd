#pragma once

namespace forefront {

class ActionRegistry;
struct Shell;

/// Registers copy, cut and paste of drawings through the system clipboard.
void addClipboardActions(ActionRegistry &actions);

/// Returns true if the selection holds shapes, sources, regions or other faces, which can be copied.
bool canCopy(const Shell &context);

} // namespace forefront
