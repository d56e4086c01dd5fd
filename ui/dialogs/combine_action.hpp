#pragma once

#include "ui/parts/action.hpp"

namespace forefront {

/// Adds the action that offers to combine closed shapes whose outlines cross, with a preview of the result.
void addCombineAction(ActionRegistry &actions);

} // namespace forefront
