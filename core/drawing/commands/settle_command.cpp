#include "core/drawing/commands/settle_command.hpp"

#include "core/drawing/constraints/carry_constraints.hpp"
#include "core/drawing/constraints/settle.hpp"
#include "core/drawing/formulas/formulas.hpp"

namespace forefront {

Result<Document> settleCommand(const Document &before, Document next) {
    carryConstraints(before, next);
    carryFormulas(before, next);
    if (next.constraints.empty()) {
        return next; // without a copy
    }
    Result<Document> settled = settle(before, next);
    if (settled && settled->shapes != next.shapes) {
        carryFormulas(next, *settled);
    }
    return settled;
}

} // namespace forefront
