#include "ui/workspace/workspace.hpp"

#include "core/drawing/constraints/carry_constraints.hpp"
#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/lost_formulas.hpp"
#include "core/engine/base/number_text.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr std::size_t kNamed = 6; ///< lost items that are named; of more, the first ones

/// Names the constraints that a change removed with their parts.
void announceLostConstraints(Workspace &context, const Document &before) {
    const std::vector<std::string> lost = lostConstraints(before, *context.document.current());
    if (lost.empty()) {
        return;
    }
    std::string names;
    for (std::size_t k = 0; k < std::min(lost.size(), kNamed); ++k) {
        names += (k == 0 ? "" : ", ") + lost[k];
    }
    const std::string more = lost.size() > kNamed ? " and " + std::to_string(lost.size() - kNamed) + " more" : "";
    context.log.announce("Removed " + countText(lost.size(), "sketch constraint") + ": " + names + more);
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
    std::string names;
    for (std::size_t k = 0; k < std::min(lost.size(), kNamed); ++k) {
        names += (k == 0 ? "" : ", ") + numberName(before, lost[k]);
    }
    const std::string more = lost.size() > kNamed ? " and " + std::to_string(lost.size() - kNamed) + " more" : "";
    context.log.announce("Removed " + std::to_string(lost.size()) +
                         (lost.size() == 1 ? " expression that no longer matches its value: "
                                           : " expressions that no longer match their values: ") +
                         names + more);
}

} // namespace

bool Workspace::applyCommand(Result<Document> next, const std::string &label, const std::string &merge) {
    if (!next) {
        ui::refuseCommand(*this, next.faults());
        return false;
    }
    if (entered.frame == ImGui::GetFrameCount()) {
        for (const auto &[address, text] : entered.texts) {
            next = setFormula(*std::move(next), address, text);
        }
    }
    const std::shared_ptr<const Document> before = document.current();
    if (const Status faults = document.tryApply(*std::move(next), label, merge); !faults.empty()) {
        ui::refuseCommand(*this, faults);
        return false;
    }
    announceLost(*this, *before);
    announceLostConstraints(*this, *before);
    return true;
}

} // namespace forefront
