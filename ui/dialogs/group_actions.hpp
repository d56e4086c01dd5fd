#pragma once

namespace forefront {

class ActionRegistry;

/// Adds the commands that group shapes and dissolve groups.
void addGroupActions(ActionRegistry &actions);

} // namespace forefront
