#pragma once

namespace forefront {

class ActionRegistry;

/// Registers the actions that add a constraint or a dimension of the sketch to the selected parts, "constraint." and
/// the word of the kind, with submenus of those that fit the selection.
void addConstraintActions(ActionRegistry &actions);

} // namespace forefront
