#include "ui/dialogs/repair_dialog.hpp"

#include "core/drawing/commands/repair_drawing.hpp"
#include "ui/parts/shell.hpp"

#include <algorithm>

namespace forefront {

void repairDrawing(Shell &context) {
    Result<RepairedDrawing> repaired = repairDrawing(*context.document.current());
    if (!repaired) {
        context.log.add(repaired.faults());
        return;
    }
    if (repaired->changes.empty()) {
        context.log.announce("Found nothing to repair");
        return;
    }
    if (!context.applyCommand(std::move(repaired->document), "Repair drawing")) {
        return;
    }
    context.log.add(notesOf(repaired->changes));
    context.log.add(repaired->lostSizes);
    std::size_t count = 0;
    for (const ArrangementChange &change : repaired->changes) {
        count += change.count;
    }
    // The last entry of a truncated list says that there are more.
    const auto left = std::count_if(repaired->left.begin(), repaired->left.end(),
                                    [](const Diagnostic &fault) { return fault.code != "more-faults"; });
    const bool more = static_cast<std::size_t>(left) < repaired->left.size();
    const auto counted = [](std::size_t number, const char *what) {
        return std::to_string(number) + what + (number == 1 ? "" : "s");
    };
    context.log.announce(counted(count, " change") + ", " + (more ? "more than " : "") +
                         counted(static_cast<std::size_t>(left), " fault") + " left");
}

} // namespace forefront
