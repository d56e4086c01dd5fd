#include "core/drawing/formulas/lost_formulas.hpp"

#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/shapes/references.hpp"

#include <optional>

namespace forefront {

std::vector<NumberAddress> lostFormulas(const Document &before, const Document &after) {
    std::vector<NumberAddress> lost;
    if (after.formulas == before.formulas) { // nearly always
        return lost;
    }
    for (const auto &[address, text] : before.formulas) {
        const std::optional<NumberAddress> now = movedAddress(before, after, address);
        if (!now || after.formulas.contains(*now)) {
            continue;
        }
        const bool shape = now->owner.kind == NumberOwner::Kind::Shape; // its numbers change with its kind
        if (shape ? findShape(after, now->owner.id) != nullptr : readNumber(after, *now).has_value()) {
            lost.push_back(address);
        }
    }
    return lost;
}

} // namespace forefront
