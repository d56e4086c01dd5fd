#pragma once

#include "core/drawing/document/document.hpp"

#include <optional>

namespace forefront {

class ActionRegistry;
struct Shell;

/// Returns the drawing of the selected faces as closed shapes; nothing unless faces alone are selected.
std::optional<Document> drawingOfFaces(const Shell &context);

/// Removes the markers of the selected regions, if faces alone are selected, and says what is left of them. Returns
/// false if the selection has other items.
bool deleteRegions(Shell &context, const char *verb);

/// Puts copies of the selected faces beside them as closed shapes. Returns false unless faces alone are selected.
bool duplicateFaces(Shell &context);

/// Adds the command that selects the lines around the selected faces.
void addRegionActions(ActionRegistry &actions);

} // namespace forefront
