#pragma once

namespace forefront {

class ActionRegistry;

/// Registers the actions of the Shape menu, which work on the selection.
void addShapeActions(ActionRegistry &actions);

} // namespace forefront
