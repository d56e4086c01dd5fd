#include "ui/dialogs/action_needs.hpp"

#include "ui/parts/action.hpp"

namespace forefront {

void addActionNeeds(ActionRegistry &actions) {
    constexpr const char *kPathNodes = "select nodes of a path; Edit > Convert to path makes one of any other shape";
    constexpr const char *kPathSegments =
        "select segments of a path by a second click; Edit > Convert to path makes one of any other shape";
    constexpr const char *kParts =
        "select nodes, circles, points, or segments by a second click; with Shift also shapes, each clicked at the "
        "segment that is meant";
    constexpr const char *kShapes = "select whole shapes, not their nodes or segments";
    constexpr const char *kPlaced = "select something; of a region, its border: Edit > Select border of region";
    constexpr struct {
        const char *action, *needs;
    } kNeeds[] = {
        {"edit.duplicate", kShapes},
        {"edit.selectBorder", "click inside a region"},
        {"edit.toPath", kShapes},
        {"path.corner", kPathNodes},
        {"path.smooth", kPathNodes},
        {"path.symmetric", kPathNodes},
        {"path.line", kPathSegments},
        {"path.curve", kPathSegments},
        {"path.split", "select one node of a path"},
        {"path.join", "select two ends of paths"},
        {"shape.transform", kPlaced},
        {"shape.mirrorX", kPlaced},
        {"shape.mirrorY", kPlaced},
        {"shape.turnLeft", kPlaced},
        {"shape.turnRight", kPlaced},
        {"shape.linearArray", kShapes},
        {"shape.polarArray", kShapes},
        {"shape.offset", kShapes},
        {"shape.group", "select two or more shapes"},
        {"shape.ungroup", "select shapes of a group"},
        {"shape.constrain", kParts},
        {"shape.dimension", kParts},
    };
    for (const auto &need : kNeeds) {
        actions.explain(need.action, need.needs);
    }
}

} // namespace forefront
