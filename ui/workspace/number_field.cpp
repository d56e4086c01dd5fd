#include "ui/workspace/number_field.hpp"

#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/place_formulas.hpp"
#include "ui/widgets/parse_number.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/coordinate_text.hpp"
#include "ui/workspace/typed_length.hpp"
#include "ui/workspace/workspace.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace forefront::ui {
namespace {

/// Returns the value of a number or expression.
Result<double> valueOf(const Workspace &context, const std::string &typed) {
    const std::optional<double> number = parseNumber(typed);
    return number ? Result<double>(*number) : evaluateFormula(*context.document.current(), typed);
}

/// Returns a typed expression of parameters; empty for a plain number.
std::string formulaOf(const std::string &typed) {
    return usesNames(typed) ? std::string(trimmed(typed)) : std::string();
}

/// Returns the value of a typed number or expression; reports an invalid one beside the field and in the log.
std::optional<double> typedNumber(Workspace &context, std::string_view name, const std::string &typed) {
    const Result<double> value = valueOf(context, typed);
    if (value) {
        return *value;
    }
    const std::string unit = unitFault(*context.document.current(), typed);
    const std::string reason = unit.empty() ? value.faults().front().message : unit;
    refuseEntry(context, name,
                error("bad-number", "expected a number, got '" + typed + "': " + reason,
                      "enter a number such as 0.25, or an expression of parameters such as 2*r"),
                reason);
    return std::nullopt;
}

/// Returns the formula of a number of the document; empty if it has none.
std::string formulaAt(const Workspace &context, const FieldAddress &address) {
    const auto &formulas = context.document.current()->formulas;
    const auto found = address ? formulas.find(*address) : formulas.end();
    return found == formulas.end() ? std::string() : found->second;
}

/// Says beside a field that cannot follow parameters that it has used them, if the text names any.
void remarkOnce(Workspace &context, std::string_view name, const std::string &text) {
    if (usesNames(text)) {
        context.fieldFault = {.field = std::string(name),
                              .text = "parameters are evaluated now; later changes do not apply",
                              .revision = context.document.revision(),
                              .frame = ImGui::GetFrameCount(),
                              .note = true};
        context.animate();
    }
}

/// Stores a typed formula at once if the number already has its value; else leaves it to the command that changes the
/// number. An expression without parameters is stored as its value: a formula would bind the number to a constant.
void keepFormula(Workspace &context, std::string_view name, const FieldAddress &address, const std::string &typed,
                 bool changesNumber) {
    if (!address) {
        remarkOnce(context, name, std::string(trimmed(typed)));
        return;
    }
    const std::string text = formulaOf(typed);
    if (context.entered.frame != ImGui::GetFrameCount()) {
        context.entered = {{}, ImGui::GetFrameCount()};
    }
    context.entered.texts[*address] = text;
    if (!changesNumber) {
        context.applyCommand(setFormula(*context.document.current(), *address, text), "Change formula");
    }
}

/// Returns true once the fault of a field no longer concerns its text: another was typed, or the document or what is
/// selected has changed. A text that the field does not keep is also answered by a click.
bool answered(const Workspace &context, const FieldFault &fault) {
    const FieldFocus &fields = context.widgets.fields;
    const FieldFocus::Refused *const refused = fields.refused(fault.field);
    const bool typing = fields.entry && fields.entry->name == fault.field;
    const bool moved = fault.revision != context.document.revision() || fault.selection != context.selection;
    if (fault.keepsText) {
        return moved || refused == nullptr || (typing && fields.entry->text != refused->entry.text);
    }
    const bool clicked = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    return (!fault.note && moved) || (ImGui::GetFrameCount() > fault.frame + 1 &&
                                      (clicked || (fields.entry && fields.entry->text != fields.entry->initial)));
}

/// Shows the fault of the field that was just drawn, until it is answered.
void drawFault(Workspace &context, std::string_view name) {
    FieldFault &fault = context.fieldFault;
    if (fault.field != name) {
        return;
    }
    if (answered(context, fault)) {
        const bool typing = context.widgets.fields.entry && context.widgets.fields.entry->name == name;
        if (!typing) {
            context.widgets.fields.forgive(name);
        }
        fault = {};
        return;
    }
    faultNote(context, fault.text, !fault.note);
    mark(context, std::string(name) + (fault.note ? "/note" : "/fault"));
}

/// Shows the value of a formula beside the field just drawn, and offers it in the menu of the field.
void offerValue(Workspace &context, std::string_view name, const std::string &formula, const std::string &value) {
    if (formula.empty()) {
        return;
    }
    tooltip(context, formula + " = " + value);
    std::optional<FieldFocus::Clicked> &clicked = context.widgets.fields.clicked;
    if (clicked && clicked->name == name) {
        clicked->value = value;
    }
}

/// Returns a number as a field shows it: rounded, or in full while it is edited, so that nothing is lost.
std::string shownNumber(const Workspace &context, std::string_view name, double value, float width,
                        Digits digits = Digits::Rounded) {
    return showsEdited(context, name, width) ? editedNumber(value)
           : digits == Digits::Listed        ? listedNumber(value)
                                             : coordinateText(value, context.extent.diagonal(context.document));
}

/// Shows the unit in a suffix at the right end of the field just drawn, unless it is edited or its text leaves no room.
void drawUnit(const Workspace &context, std::string_view name, const std::string &text, const std::string &suffix) {
    const bool edited = context.widgets.fields.entry && context.widgets.fields.entry->name == name;
    if (suffix.empty() || edited || text.empty()) {
        return;
    }
    const std::string word(trimmed(suffix));
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    const float pad = ImGui::GetStyle().FramePadding.x;
    const ImFont &font = *context.fonts.small;
    const float width = font.CalcTextSizeA(font.FontSize, 1e9F, 0.0F, word.c_str()).x;
    if (ImGui::CalcTextSize(text.c_str()).x + width + 3.0F * pad <= max.x - min.x) {
        const float top = std::round(0.5F * (min.y + max.y - font.FontSize));
        ImGui::GetWindowDrawList()->AddText(&font, font.FontSize, {max.x - pad - width, top}, context.theme.muted,
                                            word.c_str());
    }
}

/// Returns the unit of the number at an address; none if it is not a length.
LengthUnit unitAt(const Workspace &context, const FieldAddress &address) {
    const Document &document = *context.document.current();
    return address && lengthPower(document, *address) == 1 ? document.unit : LengthUnit::None;
}

/// Draws the field. Returns the new text when one was committed.
std::optional<std::string> drawEntry(Workspace &context, std::string_view name, std::optional<double> value,
                                     const char *hint, float width, const FieldAddress &address, LengthUnit unit,
                                     Digits digits = Digits::Rounded) {
    const std::string formula = formulaAt(context, address);
    const std::string plain = value ? shownNumber(context, name, *value, width, digits) : std::string();
    std::string typed = formula.empty() ? plain : formula;
    const bool committed = entry(context, name, typed, hint, width, true);
    const bool area = address && lengthPower(*context.document.current(), *address) == 2;
    drawUnit(context, name, typed, area ? areaSuffix(context.document.current()->unit) : unitSuffix(unit));
    offerValue(context, name, formula, plain);
    drawFault(context, name);
    return committed ? std::optional(inUnit(typed, unit)) : std::nullopt;
}

/// Replaces `value` by a typed number. Returns true if that changed it.
bool take(Workspace &context, std::string_view name, const std::string &typed, double &value,
          const FieldAddress &address) {
    const std::optional<double> entered = typedNumber(context, name, typed);
    if (!entered) {
        return false;
    }
    const bool changed = *entered != value;
    keepFormula(context, name, address, typed, changed);
    value = *entered;
    return changed;
}

} // namespace

void refuseEntry(Workspace &context, std::string_view name, const Diagnostics &faults, std::string reason) {
    context.log.keep(faults);
    FieldFocus &fields = context.widgets.fields;
    fields.refuse(name);
    const FieldFocus::Refused *const refused = fields.refused(name);
    if (refused != nullptr) {
        const FieldFocus::Entry &entry = refused->entry;
        const std::string &old = entry.initial.empty() ? entry.hint : entry.initial;
        reason += old.empty() ? "" : "; still " + old;
    }
    context.fieldFault = {.field = std::string(name),
                          .text = std::move(reason),
                          .revision = context.document.revision(),
                          .frame = ImGui::GetFrameCount(),
                          .keepsText = refused != nullptr,
                          .selection = context.selection};
    context.animate();
}

void refuseCommand(Workspace &context, const Diagnostics &faults) {
    const std::string &field = context.widgets.fields.committed;
    if (field.empty() || faults.empty()) {
        context.log.add(faults);
    } else {
        refuseEntry(context, field, faults, faults.front().message);
    }
}

std::optional<TypedNumber> numberBeingTyped(const Workspace &context, std::string_view name) {
    const std::optional<FieldFocus::Entry> &typing = context.widgets.fields.entry;
    if (!typing || typing->name != name || typing->text == typing->initial) {
        return std::nullopt;
    }
    const Result<double> value = valueOf(context, typing->text);
    return value ? std::optional(TypedNumber{*value, formulaOf(typing->text)}) : std::nullopt;
}

bool showsFault(const Workspace &context, std::string_view prefix) {
    return !context.fieldFault.note && context.fieldFault.field.starts_with(prefix);
}

namespace {

/// Returns true if a comma stands between two digits, as in "1,5": it may be meant as a decimal point.
bool looksLikeDecimalComma(std::string_view text, std::size_t comma) {
    const auto isDigit = [&](std::size_t at) { return at < text.size() && text[at] >= '0' && text[at] <= '9'; };
    return comma > 0 && isDigit(comma - 1) && isDigit(comma + 1);
}

} // namespace

bool inputPoint(Workspace &context, const std::string &name, Vec2 &value, float width, const FieldAddress &addressX,
                const FieldAddress &addressY, Digits digits) {
    const LengthUnit unit = context.document.current()->unit;
    std::optional<std::string> x = drawEntry(context, name + "/x", value.x, "", width, addressX, unit, digits);
    ImGui::SameLine(0, context.px(6));
    std::optional<std::string> y = drawEntry(context, name + "/y", value.y, "", width, addressY, unit, digits);
    const std::string both = x ? *x : y.value_or("");
    if (const std::size_t comma = separatingComma(both); comma != std::string::npos) {
        const std::string field = name + (x ? "/x" : "/y");
        Vec2 pair = value;
        std::string left(trimmed(std::string_view(both).substr(0, comma)));
        std::string right(trimmed(std::string_view(both).substr(comma + 1)));
        if (looksLikeDecimalComma(both, comma)) {
            const std::string reason = "write " + left + "." + right + " for one number, or " + left + ", " + right +
                                       " with a blank for both co-ordinates";
            refuseEntry(context, field, error("bad-number", reason), reason);
            return false;
        }
        left = inUnit(left, unit);
        right = inUnit(right, unit);
        const bool valid = typedNumber(context, field, left) && typedNumber(context, field, right);
        const bool changedX = valid && take(context, field, left, pair.x, addressX);
        const bool changedY = valid && take(context, field, right, pair.y, addressY);
        value = pair;
        return changedX || changedY;
    }
    const bool changedX = x && take(context, name + "/x", *x, value.x, addressX);
    const bool changedY = y && take(context, name + "/y", *y, value.y, addressY);
    return changedX || changedY;
}

bool checkPositive(Workspace &context, std::string_view name, double value, bool zero) {
    const bool good = value > 0.0 || (zero && value == 0.0);
    if (!good) {
        const std::string reason =
            std::string("expected ") + (zero ? "0 or " : "") + "a positive number, got " + number(value, 6);
        refuseEntry(context, name,
                    error("bad-number", reason, zero ? "enter 0 or more" : "enter a number greater than 0"), reason);
    }
    return good;
}

bool checkTag(Workspace &context, std::string_view name, double value) {
    const bool good = value >= 1.0 && value <= kMaxTag && value == std::floor(value);
    if (!good) {
        const std::string reason = "expected a whole number from 1 to 1000000000, got " + number(value, 6);
        refuseEntry(context, name, error("bad-tag", reason, "enter a number such as 3"), reason);
    }
    return good;
}

bool checkRange(Workspace &context, std::string_view name, double value, double minimum, double maximum) {
    const bool good = value >= minimum && value <= maximum;
    if (!good) {
        const std::string range = "a number from " + number(minimum, 10) + " to " + number(maximum, 10);
        const std::string reason = "expected " + range + ", got " + number(value, 6);
        refuseEntry(context, name, error("bad-number", reason, "enter " + range), reason);
    }
    return good;
}

bool checkWhole(Workspace &context, std::string_view name, double value, double minimum, double maximum) {
    const bool good = value >= minimum && value <= maximum && value == std::floor(value);
    if (!good) {
        const std::string range = "a whole number from " + number(minimum, 10) + " to " + number(maximum, 10);
        const std::string reason = "expected " + range + ", got " + number(value, 6);
        refuseEntry(context, name, error("bad-number", reason, "enter " + range), reason);
    }
    return good;
}

bool inputNumber(Workspace &context, std::string_view name, double &value, float width, const FieldAddress &address,
                 LengthUnit unit) {
    const std::optional<std::string> typed =
        drawEntry(context, name, value, "", width, address, address ? unitAt(context, address) : unit);
    return typed && take(context, name, *typed, value, address);
}

bool inputOptional(Workspace &context, std::string_view name, std::optional<double> &value, const char *hint,
                   float width, const FieldAddress &address, LengthUnit unit) {
    const std::optional<std::string> typed =
        drawEntry(context, name, value, hint, width, address, address ? unitAt(context, address) : unit);
    if (!typed) {
        return false;
    }
    std::optional<double> entered;
    if (!trimmed(*typed).empty() && !(entered = typedNumber(context, name, *typed))) {
        return false;
    }
    const bool changed = value != entered;
    keepFormula(context, name, address, *typed, changed);
    value = entered;
    return changed;
}

bool inputExpression(Workspace &context, std::string_view name, double &value, std::string &formula, float width,
                     LengthUnit unit) {
    const std::string plain = shownNumber(context, name, value, width);
    std::string typed = formula.empty() ? plain : formula;
    const bool committed = entry(context, name, typed, "", width, true);
    drawUnit(context, name, typed, unitSuffix(unit));
    offerValue(context, name, formula, plain);
    drawFault(context, name);
    typed = committed ? inUnit(typed, unit) : typed;
    const std::optional<double> entered = committed ? typedNumber(context, name, typed) : std::nullopt;
    if (!entered) {
        return false;
    }
    const std::string text = formulaOf(typed);
    const bool changed = *entered != value || text != formula;
    value = *entered;
    formula = text;
    return changed;
}

bool inputName(Workspace &context, std::string_view name, std::string &value, std::string_view hint, float width,
               bool selectAll) {
    const bool committed = entry(context, name, value, hint, width, selectAll);
    drawFault(context, name);
    return committed;
}

std::optional<std::string> inputChecked(Workspace &context, std::string_view name, const std::string &shown,
                                        std::string_view hint, float width) {
    std::string typed = shown;
    const bool committed = entry(context, name, typed, hint, width, true);
    drawFault(context, name);
    return committed ? std::optional(typed) : std::nullopt;
}

} // namespace forefront::ui
