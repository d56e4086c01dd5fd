#include "ui/parts/dimension_entry.hpp"

#include "core/drawing/constraints/constraint_commands.hpp"
#include "ui/widgets/widgets.hpp"

namespace forefront {

void DimensionEntry::open(const Document &document, std::uint64_t documentRevision, std::uint32_t id, Pixel place) {
    *this = {};
    constraint = id;
    at = place;
    revision = documentRevision;
    const auto formula = document.formulas.find({NumberOwner::ofConstraint(id), Quantity::Value});
    initial = text =
        formula != document.formulas.end() ? formula->second : ui::editedNumber(findConstraint(document, id)->value);
}

} // namespace forefront
