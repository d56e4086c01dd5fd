#include "ui/workspace/typed_command.hpp"

#include "core/drawing/commands/carry_joints.hpp"
#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/constraints/held_numbers.hpp"
#include "ui/workspace/workspace.hpp"

#include <imgui.h>

#include <cstdint>
#include <memory>
#include <set>
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

bool applyTypedSizes(Workspace &context, const Result<Document> &next, std::span<const TypedSize> sizes,
                     const std::string &label, bool joins) {
    const std::shared_ptr<const Document> before = context.document.current();
    Result<Document> carried = next && joins ? carryJoints(*before, *next) : next;
    if (carried) {
        carried = withTypedSizes(*before, *carried, sizes);
    }
    if (carried) {
        return context.applyCommand(std::move(carried), label);
    }
    const Diagnostics faults = carried.faults();
    context.applyCommand(faults, label);
    if (!faults.empty() && context.fieldFault.frame == ImGui::GetFrameCount()) {
        const std::set<std::uint32_t> ids(faults.front().ids.begin(), faults.front().ids.end());
        for (const TypedSize &size : sizes) {
            context.fieldFault.change =
                context.fieldFault.change ? context.fieldFault.change : dimensionThatSets(*before, size, ids);
        }
    }
    return false;
}

bool applyTypedSize(Workspace &context, const Result<Document> &next, const TypedSize &size, const std::string &label,
                    bool joins) {
    return applyTypedSizes(context, next, std::span(&size, 1), label, joins);
}

} // namespace forefront
