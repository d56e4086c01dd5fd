#pragma once

namespace forefront {

class ActionRegistry;
struct Shell;

/// Registers the actions of the Shape menu, which work on the selection.
void addShapeActions(ActionRegistry &actions);

/// Returns true if anything is selected.
bool hasSelection(const Shell &context);

} // namespace forefront
