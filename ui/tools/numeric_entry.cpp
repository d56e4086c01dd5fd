#include "ui/tools/numeric_entry.hpp"

#include "ui/widgets/number_text.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace forefront {
namespace {

bool isDigitKey(int code) {
    return (code >= key::k0 && code <= key::k9) || (code >= key::kKeypad0 && code <= key::kKeypad9);
}

bool isNumberKey(int code) {
    return isDigitKey(code) || code == key::kKeypadDecimal || code == key::kMinus || code == key::kPeriod ||
           code == key::kComma;
}

bool isDigit(char32_t c) {
    return c >= U'0' && c <= U'9';
}

bool belongsToNumber(char32_t c) {
    return isDigit(c) || c == U'.' || c == U'-' || c == U'+' || c == U',' || c == U'@' || c == U'e' || c == U' ';
}

/// Returns true for quantities that must be positive; coordinates and angles may have any sign.
bool isLength(EntryField field) {
    return field != EntryField::X && field != EntryField::Y && field != EntryField::Angle;
}

std::optional<double> read(EntryField field, std::string_view text) {
    const std::optional<double> number = parseNumber(text);
    return number && (*number > 0.0 || !isLength(field)) ? number : std::nullopt;
}

const char *symbol(EntryField field) {
    static constexpr std::array<const char *, kEntryFields> kSymbols{"x", "y", "d", "\xe2\x88\xa0", "w", "h", "r"};
    return kSymbols[static_cast<std::size_t>(field)];
}

std::string shown(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.6g", value);
    return buffer;
}

} // namespace

std::optional<TypedPair> parsePair(std::string_view text) {
    text = trimmed(text);
    TypedPair pair;
    if (text.starts_with('@')) {
        pair.relative = true;
        text = trimmed(text.substr(1));
    }
    std::size_t cut = text.find(',');
    if (cut == std::string_view::npos) {
        cut = text.find(' ');
    }
    if (cut == std::string_view::npos) {
        return std::nullopt;
    }
    const auto x = parseNumber(text.substr(0, cut)), y = parseNumber(text.substr(cut + 1));
    if (!x || !y) {
        return std::nullopt;
    }
    pair.value = {*x, *y};
    return pair;
}

std::optional<double> NumericEntry::value(EntryField field) const {
    const std::optional<double> typed = open_ == field ? read(field, text_) : std::nullopt;
    return typed ? typed : values_[static_cast<std::size_t>(field)];
}

SnapLocks NumericEntry::locks() const {
    const std::optional<double> radius = value(EntryField::Radius);
    return {.x = value(EntryField::X),
            .y = value(EntryField::Y),
            .distance = radius ? radius : value(EntryField::Distance),
            .angle = value(EntryField::Angle)};
}

std::optional<TypedPair> NumericEntry::pair() const {
    return open_ && byDigit_ ? parsePair(text_) : std::nullopt;
}

bool NumericEntry::shows(EntryField field) const {
    return std::find(fields_.begin(), fields_.end(), field) != fields_.end();
}

/// Returns the fields of the tool, then others that have a value or are open.
std::vector<EntryField> NumericEntry::visible() const {
    std::vector<EntryField> result = fields_;
    for (std::size_t i = 0; i < kEntryFields; ++i) {
        const auto field = static_cast<EntryField>(i);
        if (!shows(field) && (values_[i] || open_ == field)) {
            result.push_back(field);
        }
    }
    return result;
}

NumericEntry::Answer NumericEntry::handle(const CanvasEvent &event, std::span<const EntryField> fields) {
    fields_.assign(fields.begin(), fields.end());
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
        const bool begins =
            isDigit(character) || (anchored() && (character == U'.' || character == U'-' || character == U'@'));
        if (!begins || fields_.empty()) {
            return Answer::Unused;
        }
        const auto empty = std::find_if(fields_.begin(), fields_.end(), [this](EntryField f) { return !slot(f); });
        open_ = empty != fields_.end() ? *empty : fields_.front();
        byDigit_ = true;
        text_.clear();
    }
    if (belongsToNumber(character)) {
        text_ += static_cast<char>(character);
        wrong_ = false;
    }
    return Answer::Used;
}

NumericEntry::Answer NumericEntry::letter(EntryField field) {
    if (open_ && open_ != field && !store()) {
        return Answer::Used;
    }
    // The letter of a field that has a value clears it.
    if (slot(field) || open_ == field) {
        slot(field).reset();
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
    skipLetter_ = false;
    if (event.modifiers.control() || event.modifiers.alt()) {
        return Answer::Unused;
    }
    switch (event.key) {
    case 'X':
        return letter(EntryField::X);
    case 'Y':
        return letter(EntryField::Y);
    case 'D':
        if (anchored()) {
            return letter(shows(EntryField::Radius) ? EntryField::Radius : EntryField::Distance);
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
    if (!open_) {
        // The digits arrive as text; their keys must not run shortcuts meanwhile.
        return isDigitKey(event.key) || (anchored() && isNumberKey(event.key)) ? Answer::Used : Answer::Unused;
    }
    switch (event.key) {
    case key::kEnter:
    case key::kKeypadEnter:
        return accept();
    case key::kTab:
        moveOn(event.modifiers.shift());
        break;
    case key::kEscape:
        open_.reset();
        wrong_ = false;
        text_.clear();
        break;
    case key::kBackspace:
        wrong_ = false;
        if (!text_.empty()) {
            text_.pop_back();
        } else if (slot(*open_)) {
            slot(*open_).reset();
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
        const std::optional<double> number = read(*open_, text_);
        wrong_ = !number;
        if (wrong_) {
            return false;
        }
        slot(*open_) = number;
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
    const auto has = [this](EntryField field) { return values_[static_cast<std::size_t>(field)].has_value(); };
    return (has(EntryField::X) && has(EntryField::Y)) || (has(EntryField::Width) && has(EntryField::Height)) ||
           has(EntryField::Radius) || (has(EntryField::Distance) && (has(EntryField::Angle) || byDigit_));
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

std::string NumericEntry::label() const {
    const bool isPair = open_ && byDigit_ && text_.find_first_of(",@ ") != std::string::npos;
    if (isPair) {
        return text_ + "_";
    }
    std::string result;
    for (const EntryField field : visible()) {
        const std::optional<double> &known = values_[static_cast<std::size_t>(field)];
        if (!open_ && !known) {
            continue;
        }
        result += (result.empty() ? "" : "   ") + std::string(symbol(field));
        if (open_ == field) {
            result += ' ' + (text_.empty() && known ? shown(*known) : text_) + '_';
        } else if (known) {
            result += ' ' + shown(*known);
        }
    }
    return result;
}

} // namespace forefront
