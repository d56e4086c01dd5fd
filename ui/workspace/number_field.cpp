#include "ui/workspace/number_field.hpp"

#include "ui/widgets/number_text.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/workspace.hpp"

namespace forefront::ui {

std::optional<double> typedNumber(Workspace &context, const std::string &typed) {
    const std::optional<double> number = parseNumber(typed);
    if (!number) {
        context.log.add(error("bad-number", "expected a number, got '" + typed + "'", "enter a number such as 0.25"));
    }
    return number;
}

bool inputNumber(Workspace &context, std::string_view name, double &value, float width) {
    std::string typed = number(value, 6);
    if (!entry(context, name, typed, {}, width, true)) {
        return false;
    }
    const std::optional<double> entered = typedNumber(context, typed);
    const bool changed = entered && *entered != value;
    value = entered.value_or(value);
    return changed;
}

} // namespace forefront::ui
