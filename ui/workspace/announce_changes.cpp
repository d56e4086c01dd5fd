#include "ui/workspace/announce_changes.hpp"

#include "core/drawing/constraints/carry_constraints.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/lost_formulas.hpp"
#include "core/engine/base/number_text.hpp"
#include "ui/workspace/workspace.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace forefront {
namespace {

constexpr std::size_t kNamed = 6; ///< lost items that are named; of more, the first ones

std::string listed(const std::vector<std::string> &items) {
    std::string names;
    for (std::size_t k = 0; k < std::min(items.size(), kNamed); ++k) {
        names += (k == 0 ? "" : ", ") + items[k];
    }
    return names + (items.size() > kNamed ? " and " + std::to_string(items.size() - kNamed) + " more" : "");
}

/// Names the constraints that a change removed with their parts.
void announceLostConstraints(Workspace &context, const Document &before) {
    const std::vector<std::string> lost = lostConstraints(before, *context.document.current());
    if (!lost.empty()) {
        context.log.announce("Removed " + countText(lost.size(), "sketch constraint") + ": " + listed(lost));
    }
}

/// Names the numbers that a change took the expressions from; only the first ones if there are many. Those that were
/// just typed over are left out.
void announceLost(Workspace &context, const Document &before) {
    std::vector<NumberAddress> lost = lostFormulas(before, *context.document.current());
    if (context.entered.frame == ImGui::GetFrameCount()) {
        std::erase_if(lost, [&](const NumberAddress &address) { return context.entered.texts.contains(address); });
    }
    if (lost.empty()) {
        return;
    }
    const Document &now = *context.document.current();
    std::vector<std::string> names;
    std::transform(lost.begin(), lost.end(), std::back_inserter(names),
                   [&](const NumberAddress &address) { return numberName(before, address); });
    const bool same = std::all_of(lost.begin(), lost.end(), [&](const NumberAddress &address) {
        const std::optional<NumberAddress> moved = movedAddress(before, now, address);
        const std::optional<double> value = readNumber(before, address);
        return moved && value && hasValue(now, *moved, *value);
    });
    const std::string why = same               ? ": "
                            : lost.size() == 1 ? " that no longer matches its value: "
                                               : " that no longer match their values: ";
    context.log.announce("Removed " + countText(lost.size(), "expression") + why + listed(names));
}

} // namespace

void announceLosses(Workspace &context, const Document &before) {
    announceLost(context, before);
    announceLostConstraints(context, before);
}

void announceChangedDimensions(Workspace &context, const Document &before) {
    const std::shared_ptr<const Document> now = context.document.current();
    std::vector<std::string> changed;
    for (const auto &constraint : before.constraints) {
        const SketchConstraint *const after = findConstraint(*now, constraint->id);
        constexpr double kRounding = 1e-9;
        if (after != nullptr && std::fabs(after->value - constraint->value) > kRounding * constraint->value) {
            changed.push_back(after->name + " = " + numberText(after->value, 6));
        }
    }
    if (!changed.empty()) {
        context.log.announce("Changed " + countText(changed.size(), "dimension") + ": " + listed(changed));
    }
}

} // namespace forefront
