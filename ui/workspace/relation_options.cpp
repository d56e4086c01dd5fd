#include "ui/workspace/relation_options.hpp"

#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/workspace.hpp"

namespace forefront {

void drawRelationOptions(Workspace &context, ui::Flow &flow) {
    flow.item("relations");
    ui::checkbox(context, "options/snap/relations", "Find relations", context.snapping.infers);
    ui::tooltip(context, "Snap to directions and lengths of other lines, and level with or above other nodes: "
                         "horizontal, vertical, parallel, perpendicular, tangent, equal. Hold Ctrl to turn it off.");
    flow.item("constraints");
    ui::checkbox(context, "options/snap/constraints", "Add constraints", context.snapping.addsConstraints);
    ui::tooltip(context, "Add the relations shown at the pointer as sketch constraints. Off by default: a drawing that "
                         "is only meshed is easier to change without them.");
}

} // namespace forefront
