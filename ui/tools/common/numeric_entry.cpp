#include "ui/tools/common/numeric_entry.hpp"

#include "core/drawing/formulas/place_formulas.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/spacing/parts/expression/expression.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/widgets/parse_number.hpp"
#include "ui/workspace/typed_length.hpp"
#include "ui/workspace/workspace.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace forefront {
namespace {

bool isDigitKey(int code) {
    return (code >= key::k0 && code <= key::k9) || (code >= key::kKeypad0 && code <= key::kKeypad9);
}

bool isNumberKey(int code) {
    return isDigitKey(code) || code == key::kKeypadDecimal || code == key::kMinus || code == key::kPeriod ||
           code == key::kComma || code == key::kEqual;
}

/// Returns true for a key that begins a number.
bool beginsNumber(int code) {
    return isDigitKey(code) || code == key::kKeypadDecimal || code == key::kMinus || code == key::kPeriod;
}

bool isDigit(char32_t c) {
    return c >= U'0' && c <= U'9';
}

/// Returns true for characters of numbers, pairs and expressions.
bool isPrintable(char32_t c) {
    return c >= U' ' && c <= U'~';
}

/// Returns true for quantities that may have any sign but not be 0: a negative width or height goes to the left or
/// down.
bool isExtent(EntryField field) {
    return field == EntryField::Width || field == EntryField::Height;
}

/// Returns true for quantities that must be positive; coordinates and angles may have any value.
bool isLength(EntryField field) {
    return field != EntryField::X && field != EntryField::Y && field != EntryField::Angle && !isExtent(field);
}

/// Returns the text of an expression without the = that may begin it.
std::string expressionIn(std::string_view text) {
    text = trimmed(text);
    return std::string(trimmed(text.starts_with('=') ? text.substr(1) : text));
}

/// Returns the value of a number or an expression of names.
Result<double> evaluate(std::string_view text, const NamedValues &names) {
    if (const std::optional<double> number = parseNumber(text)) {
        return *number;
    }
    return evaluateExpression(expressionIn(text), names);
}

Result<double> read(EntryField field, std::string_view text, const NamedValues &names) {
    Result<double> number = evaluate(text, names);
    if (number && isLength(field) && !(*number > 0.0)) {
        return error("bad-number", "expected a number above 0");
    }
    if (number && isExtent(field) && *number == 0.0) {
        return error("bad-number", "expected a number other than 0");
    }
    return number;
}

/// Returns the name of a quantity, as the labels and prompts on the canvas have it.
const char *nameOf(EntryField field) {
    static constexpr std::array<const char *, kEntryFields> kNames{"x",      "y",      "distance", "angle", "width",
                                                                   "height", "radius", "diameter", "factor"};
    return kNames[static_cast<std::size_t>(field)];
}

/// Returns a value that was typed as `expression`: a number as it was typed, or the value of a formula with all its
/// digits but the last, rounded ones.
std::string shown(double value, const std::string &expression) {
    if (parseNumber(expression)) {
        return expression;
    }
    return numberText(value, 12);
}

} // namespace

std::optional<TypedPair> parsePair(std::string_view text, const NamedValues &names, LengthUnit unit) {
    text = trimmed(text);
    TypedPair pair;
    if (text.starts_with('@')) {
        pair.relative = true;
        text = trimmed(text.substr(1));
    }
    std::size_t cut = separatingComma(text);
    const bool spaced = cut == std::string_view::npos;
    if (spaced) {
        cut = text.find(' ');
    }
    if (cut == std::string_view::npos) {
        return std::nullopt;
    }
    const std::string left = inUnit(std::string(text.substr(0, cut)), unit),
                      right = inUnit(std::string(text.substr(cut + 1)), unit);
    if (spaced && !(parseNumber(left) && parseNumber(right))) {
        return std::nullopt; // an expression with spaces
    }
    const Result<double> x = evaluate(left, names), y = evaluate(right, names);
    if (!x || !y) {
        return std::nullopt;
    }
    pair.value = {*x, *y};
    pair.xText = expressionIn(left);
    pair.yText = expressionIn(right);
    return pair;
}

std::optional<double> NumericEntry::value(EntryField field) const {
    if (open_ == field && !text_.empty()) {
        if (const Result<double> typed = read(field, typedIn(field), names_)) {
            return *typed;
        }
    }
    if (field == EntryField::Radius && byDiameter()) {
        const std::optional<double> diameter = value(EntryField::Diameter);
        return diameter ? std::optional(0.5 * *diameter) : std::nullopt;
    }
    return values_[static_cast<std::size_t>(field)];
}

std::string NumericEntry::expression(EntryField field) const {
    if (field == EntryField::Radius && byDiameter()) {
        const std::string diameter = expression(EntryField::Diameter);
        if (const std::optional<double> number = parseNumber(diameter)) {
            return exactText(0.5 * *number);
        }
        return diameter.empty() ? diameter : "(" + diameter + ")/2";
    }
    return open_ == field && !text_.empty() ? expressionIn(typedIn(field))
                                            : expressions_[static_cast<std::size_t>(field)];
}

bool NumericEntry::usesParameters() const {
    return (open_ && usesNames(typedIn(*open_))) || std::any_of(expressions_.begin(), expressions_.end(), usesNames);
}

void NumericEntry::forget(EntryField field) {
    slot(field).reset();
    expressions_[static_cast<std::size_t>(field)].clear();
}

/// Returns what was typed into a field, with lengths in the unit of the document.
std::string NumericEntry::typedIn(EntryField field) const {
    const bool plain = field == EntryField::Angle || field == EntryField::Factor;
    return plain ? text_ : inUnit(text_, unit_);
}

/// Returns true if the key of a letter continues the text as the beginning of a unit.
bool NumericEntry::continuesUnit(int letter) const {
    const bool plain = !open_ || open_ == EntryField::Angle || open_ == EntryField::Factor;
    if (plain || unit_ == LengthUnit::None || text_.empty()) {
        return false;
    }
    const std::size_t last = text_.find_last_of(", "); // of a pair, the second number
    const std::string_view number = trimmed(std::string_view(text_).substr(text_.back() == ' ' ? 0 : last + 1));
    const auto begins = [letter](std::string_view word) {
        return word != wordOf(LengthUnit::None) && word[0] == letter - 'A' + 'a';
    };
    return parseNumber(number) && std::ranges::any_of(wordsOf<LengthUnit>(), begins);
}

/// Returns true if a letter continues the text: it is no number yet, as after an operator, or no number any longer.
bool NumericEntry::continuesExpression() const {
    return open_ && !text_.empty() && !parseNumber(text_);
}

/// Returns true for the key of a letter with which a parameter's name begins, if it has no other meaning now.
bool NumericEntry::beginsName(const CanvasEvent &event) const {
    const int letter = event.modifiers.shift() ? event.key : event.key - 'A' + 'a';
    return !open_ && anchored() && !fields_.empty() &&
           ownLetters_.find(static_cast<char>(event.key)) == std::string::npos &&
           std::any_of(names_.begin(), names_.end(), [letter](const auto &name) { return name.first[0] == letter; });
}

SnapLocks NumericEntry::locks() const {
    const std::optional<double> radius = value(EntryField::Radius);
    return {.x = value(EntryField::X),
            .y = value(EntryField::Y),
            .distance = radius ? radius : value(EntryField::Distance),
            .angle = value(EntryField::Angle),
            .isRadius = radius.has_value()};
}

std::optional<TypedPair> NumericEntry::pair() const {
    return open_ && byDigit_ && !isScalar() ? parsePair(text_, names_, unit_) : std::nullopt;
}

bool NumericEntry::shows(EntryField field) const {
    return std::find(fields_.begin(), fields_.end(), field) != fields_.end();
}

/// Returns true if the tool asks for one number that is not a place, so that neither a point nor another field makes
/// sense.
bool NumericEntry::isScalar() const {
    return fields_.size() == 1 && (fields_.front() == EntryField::Factor || fields_.front() == EntryField::Angle);
}

/// Returns true if the radius is given by a diameter.
bool NumericEntry::byDiameter() const {
    return open_ == EntryField::Diameter || (open_ != EntryField::Radius && value(EntryField::Diameter));
}

/// Returns the fields of the tool, then others that have a value or are open. A diameter takes the place of the radius.
std::vector<EntryField> NumericEntry::visible() const {
    // Once one coordinate is typed, the other completes the point.
    const bool coordinates = (open_ == EntryField::X || open_ == EntryField::Y) && !shows(EntryField::X);
    std::vector<EntryField> result = coordinates ? std::vector{EntryField::X, EntryField::Y} : fields_;
    if (byDiameter()) {
        std::replace(result.begin(), result.end(), EntryField::Radius, EntryField::Diameter);
    }
    for (std::size_t i = 0; i < kEntryFields; ++i) {
        const auto field = static_cast<EntryField>(i);
        const bool listed = std::find(result.begin(), result.end(), field) != result.end();
        if (!listed && (coordinates || !shows(field)) && (values_[i] || open_ == field)) {
            result.push_back(field);
        }
    }
    return result;
}

NumericEntry::Answer NumericEntry::handle(const CanvasEvent &event, std::span<const EntryField> fields,
                                          const NamedValues &names, std::string_view ownLetters, LengthUnit unit) {
    unit_ = unit;
    fields_.assign(fields.begin(), fields.end());
    names_ = names;
    ownLetters_ = ownLetters;
    switch (event.kind) {
    case CanvasEvent::Kind::Key:
        return key(event);
    case CanvasEvent::Kind::Text:
        return text(event.character);
    default:
        return Answer::Unused;
    }
}

NumericEntry::Answer NumericEntry::text(char32_t character) {
    const bool isLetter = character >= U'A' && character != U'e';
    if (std::exchange(skipLetter_, false) && isLetter) {
        return Answer::Used;
    }
    if (!open_) {
        const bool begins = isDigit(character) || std::exchange(nameBegins_, false) || character == U'.' ||
                            character == U'-' || (anchored() && character == U'=') ||
                            (anchored() && !isScalar() && character == U'@');
        if (!begins || fields_.empty()) {
            return Answer::Unused;
        }
        const auto empty = std::find_if(fields_.begin(), fields_.end(), [this](EntryField f) { return !slot(f); });
        open_ = empty != fields_.end() ? *empty : fields_.front();
        byDigit_ = true;
        text_.clear();
    }
    if (text_.empty() && !byDigit_ && (open_ == EntryField::Diameter || open_ == EntryField::Distance) &&
        names_.contains("d") && std::u32string_view(U"/*^+").find(character) != std::u32string_view::npos) {
        open_ = open_ == EntryField::Diameter ? EntryField::Radius : EntryField::Distance;
        text_ = "d"; // the parameter, not the field
    }
    if (character == U',' && open_ == EntryField::X && !byDigit_ &&
        separatingComma(text_ + ',') == text_.size()) { // "x3,4"
        moveOn(false);
        return Answer::Used;
    }
    if (std::exchange(allSelected_, false)) {
        text_.clear();
    }
    if (isPrintable(character) && text_.size() < kMaxExpressionLength) {
        text_ += static_cast<char>(character);
        fault_.clear();
    }
    return Answer::Used;
}

NumericEntry::Answer NumericEntry::letter(EntryField field) {
    if (open_ && open_ != field && !store()) {
        return Answer::Used;
    }
    // The letter of a field that has a value clears it.
    if (slot(field) || open_ == field) {
        forget(field);
        open_.reset();
    } else {
        open_ = field;
        byDigit_ = false;
    }
    text_.clear();
    skipLetter_ = true;
    return Answer::Used;
}

NumericEntry::Answer NumericEntry::key(const CanvasEvent &event) {
    skipLetter_ = nameBegins_ = false;
    if (open_ && event.key == 'A' && event.modifiers.control() && !event.modifiers.alt()) {
        allSelected_ = !text_.empty() || slot(*open_).has_value();
        return Answer::Used; // even an empty field: the key is not meant for the shapes
    }
    if (event.modifiers.control() || event.modifiers.alt()) {
        return Answer::Unused;
    }
    const bool selected = std::exchange(allSelected_, false);
    if (selected && (event.key == key::kBackspace || event.key == key::kDelete)) {
        fault_.clear();
        text_.clear();
        forget(*open_);
        return Answer::Used;
    }
    const bool isLetterKey = event.key >= 'A' && event.key <= 'Z';
    const bool leaves = event.key == key::kEnter || event.key == key::kKeypadEnter || event.key == key::kTab ||
                        event.key == key::kEscape || event.key == key::kLeft || event.key == key::kRight;
    allSelected_ = selected && !isLetterKey && !leaves; // the character arrives as text and replaces it
    const bool isLetter = event.key >= 'A' && event.key <= 'Z';
    if (isLetter && (continuesExpression() || continuesUnit(event.key) || (isScalar() && open_))) {
        return Answer::Used; // arrives as text
    }
    if (isLetter && isScalar()) {
        nameBegins_ = beginsName(event);
        return nameBegins_ ? Answer::Used : Answer::Unused;
    }
    switch (event.key) {
    case 'X':
        return letter(EntryField::X);
    case 'Y':
        return letter(EntryField::Y);
    case 'D':
        if (anchored()) {
            return letter(shows(EntryField::Radius) ? EntryField::Diameter : EntryField::Distance);
        }
        break;
    case 'Q':
        if (anchored()) {
            return letter(EntryField::Angle);
        }
        break;
    default:
        break;
    }
    nameBegins_ = isLetter && beginsName(event);
    if (nameBegins_) {
        return Answer::Used; // arrives as text
    }
    if (!open_) {
        // The digits arrive as text; their keys must not run shortcuts meanwhile.
        return beginsNumber(event.key) || (anchored() && isNumberKey(event.key)) ? Answer::Used : Answer::Unused;
    }
    return edit(event);
}

NumericEntry::Answer NumericEntry::edit(const CanvasEvent &event) {
    switch (event.key) {
    case key::kEnter:
    case key::kKeypadEnter:
        return accept();
    case key::kTab:
        moveOn(event.modifiers.shift());
        break;
    case key::kEscape:
        open_.reset();
        fault_.clear();
        text_.clear();
        break;
    case key::kBackspace:
        fault_.clear();
        if (!text_.empty()) {
            text_.pop_back();
        } else if (slot(*open_)) {
            forget(*open_);
        } else {
            open_.reset();
        }
        break;
    default:
        break;
    }
    return Answer::Used;
}

/// Commits the text of the open field; empty text keeps the old value. Returns false and marks invalid text.
bool NumericEntry::store() {
    if (!text_.empty()) {
        const std::string typed = typedIn(*open_);
        const Result<double> number = read(*open_, typed, names_);
        if (!number) {
            fault_ = number.faults().front().message;
            return false;
        }
        // The one typed last replaces the other.
        if (*open_ == EntryField::Radius) {
            forget(EntryField::Diameter);
        } else if (*open_ == EntryField::Diameter) {
            forget(EntryField::Radius);
        }
        slot(*open_) = *number;
        expressions_[static_cast<std::size_t>(*open_)] = expressionIn(typed);
        text_.clear();
    }
    return true;
}

void NumericEntry::moveOn(bool back) {
    if (!store()) {
        return;
    }
    const std::vector<EntryField> shown = visible();
    const auto at = static_cast<std::size_t>(std::find(shown.begin(), shown.end(), *open_) - shown.begin());
    open_ = shown[(at + (back ? shown.size() - 1 : 1)) % shown.size()];
}

bool NumericEntry::determined() const {
    const auto has = [this](EntryField field) { return value(field).has_value(); };
    if (fields_.size() == 1 && value(fields_.front())) {
        return true;
    }
    const bool across = has(EntryField::X) || has(EntryField::Width);
    const bool upward = has(EntryField::Y) || has(EntryField::Height);
    return (across && upward) || has(EntryField::Radius) || has(EntryField::Diameter) ||
           (has(EntryField::Distance) && (has(EntryField::Angle) || byDigit_));
}

NumericEntry::Answer NumericEntry::accept() {
    if (pair()) {
        return Answer::Place;
    }
    if (!store()) {
        return Answer::Used;
    }
    open_.reset();
    return determined() ? Answer::Place : Answer::Used;
}

/// Returns the text of the open field with its caret, or in brackets if all of it is selected.
std::string NumericEntry::typedText(const std::string &stored) const {
    const std::string &text = text_.empty() ? stored : text_;
    return allSelected_ ? '[' + text + ']' : text + '_';
}

std::string NumericEntry::label() const {
    const bool isPair = open_ && byDigit_ && !isScalar() &&
                        (separatingComma(text_) != std::string::npos || text_.starts_with('@') || pair().has_value());
    if (isPair) {
        return typedText({});
    }
    std::string result;
    for (const EntryField field : visible()) {
        const std::optional<double> &known = values_[static_cast<std::size_t>(field)];
        if (!open_ && !known) {
            continue;
        }
        result += (result.empty() ? "" : "   ") + std::string(nameOf(field));
        const std::string stored = known ? shown(*known, expressions_[static_cast<std::size_t>(field)]) : std::string();
        if (open_ == field) {
            result += ' ' + typedText(stored);
        } else if (known) {
            result += ' ' + stored;
        }
    }
    return result;
}

std::string NumericEntry::prompt(std::string_view goal) const {
    if (!open_ || isWrong()) {
        return {};
    }
    const bool places = determined() || pair().has_value();
    std::string text = "Enter: " + (places ? std::string(goal) : "keep " + std::string(nameOf(*open_)));
    const std::vector<EntryField> shown = visible();
    if (shown.size() > 1 && !pair()) {
        const auto at = static_cast<std::size_t>(std::find(shown.begin(), shown.end(), *open_) - shown.begin());
        text = "Tab: " + std::string(nameOf(shown[(at + 1) % shown.size()])) + "   " + text;
    }
    return text;
}

void drawUsedOnce(CanvasPainter &painter, const Workspace &context, const NumericEntry &entry, Vec2 at, double y) {
    if (entry.usesParameters() && !entry.isWrong()) {
        painter.label(at, {16.0, y}, "parameters are evaluated now; later changes do not apply", context.theme.muted,
                      context.theme.popup, context.fonts.small);
    }
}

} // namespace forefront
