#include "ui/workspace/joined_command.hpp"

#include "core/drawing/commands/carry_joints.hpp"
#include "ui/workspace/workspace.hpp"

namespace forefront {

bool applyJoined(Workspace &context, const Result<Document> &next, const std::string &label, const std::string &merge) {
    return context.applyCommand(next ? carryJoints(*context.document.current(), *next) : next, label, merge);
}

} // namespace forefront
