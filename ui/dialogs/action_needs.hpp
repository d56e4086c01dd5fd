#pragma once

namespace forefront {

class ActionRegistry;

/// Says of the actions on a selection what must be selected: see ActionRegistry::explain(). Call when all are added.
void addActionNeeds(ActionRegistry &actions);

} // namespace forefront
