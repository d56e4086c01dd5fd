#pragma once

namespace forefront {

class ActionRegistry;

/// Registers copy, cut and paste of drawings through the system clipboard.
void addClipboardActions(ActionRegistry &actions);

} // namespace forefront
