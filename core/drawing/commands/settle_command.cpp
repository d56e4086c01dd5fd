#include "core/drawing/commands/settle_command.hpp"

#include "core/drawing/constraints/carry_constraints.hpp"
#include "core/drawing/constraints/fit_roundings.hpp"
#include "core/drawing/constraints/settle.hpp"
#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"

#include <utility>

namespace forefront {

Result<Document> settleCommand(const Document &before, Document next) {
    carryConstraints(before, next);
    carryFormulas(before, next);
    if (next.constraints.empty()) {
        return fitRoundings(before, std::move(next)); // without a copy
    }
    Result<Document> settled = settle(before, next);
    if (!settled) {
        return settled;
    }
    if (settled->shapes != next.shapes) {
        carryFormulas(next, *settled);
    }
    return fitRoundings(before, *std::move(settled));
}

Result<Document> completeCommand(const Document &before, Document next) {
    carrySegmentSizes(before, next);
    carryElementCounts(before, next);
    return settleCommand(before, std::move(next));
}

} // namespace forefront
