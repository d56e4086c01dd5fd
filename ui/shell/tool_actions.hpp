#pragma once

namespace forefront {

class ActionRegistry;

namespace shell {

/// Adds the tools to the command palette, with the keys that they propose, and what else has a key while a tool is
/// chosen: the sizes and modes of the brush, and snapping.
void addToolActions(ActionRegistry &actions);

} // namespace shell

} // namespace forefront
