#include "ui/workspace/typed_command.hpp"

#include "core/drawing/commands/carry_joints.hpp"
#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/constraints/held_numbers.hpp"
#include "ui/workspace/workspace.hpp"

#include <memory>
#include <utility>

namespace forefront {

bool applyTyped(Workspace &context, const Result<Document> &next, const std::string &label, bool joins) {
    const std::shared_ptr<const Document> before = context.document.current();
    Result<Document> carried = next && joins ? carryJoints(*before, *next) : next;
    if (carried && !before->constraints.empty()) {
        const Result<Document> settled = completeCommand(*before, *carried);
        const Diagnostics faults = settled ? heldNumbersFault(*before, *next, *settled) : settled.faults();
        carried = faults.empty() ? std::move(carried) : Result<Document>(faults);
    }
    return context.applyCommand(std::move(carried), label);
}

} // namespace forefront
