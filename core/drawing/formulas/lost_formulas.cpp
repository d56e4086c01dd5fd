#include "core/drawing/formulas/lost_formulas.hpp"

#include "core/drawing/formulas/number_address.hpp"
#include "core/drawing/shapes/references.hpp"

#include <optional>

namespace forefront {

std::vector<std::string> lostFormulas(const Document &before, const Document &after) {
    std::vector<std::string> lost;
    if (after.formulas == before.formulas) { // nearly always
        return lost;
    }
    for (const auto &[address, text] : before.formulas) {
        const std::optional<std::string> now = movedAddress(before, after, address);
        const std::optional<NumberAddress> number = now ? parseAddress(*now) : std::nullopt;
        if (!number || after.formulas.contains(*now)) {
            continue;
        }
        const bool shape = number->owner == NumberAddress::Owner::Shape; // its numbers change with its kind
        if (shape ? findShape(after, number->id) != nullptr : readNumber(after, *number).has_value()) {
            lost.push_back(address);
        }
    }
    return lost;
}

} // namespace forefront
