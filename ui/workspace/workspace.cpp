#include "ui/workspace/workspace.hpp"

#include "core/drawing/formulas/formulas.hpp"
#include "ui/workspace/announce_changes.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <memory>
#include <utility>

namespace forefront {

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
    announceLosses(*this, *before);
    return true;
}

} // namespace forefront
