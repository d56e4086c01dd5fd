#pragma once

namespace forefront {

class ActionRegistry;

/// Registers the commands that name the selection, enter its element size, and zoom to it.
void addNamingActions(ActionRegistry &actions);

} // namespace forefront
