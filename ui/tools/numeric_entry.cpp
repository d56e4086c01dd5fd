#include "ui/tools/numeric_entry.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <utility>

namespace forefront {
namespace {

bool isDigitKey(int code) {
    return (code >= key::k0 && code <= key::k9) || (code >= key::kKeypad0 && code <= key::kKeypadDecimal) ||
           code == key::kMinus || code == key::kPeriod || code == key::kComma;
}

bool belongsToNumber(char32_t c) {
    return (c >= U'0' && c <= U'9') || c == U'.' || c == U'-' || c == U'+' || c == U',' || c == U'@' || c == U'e' ||
           c == U' ';
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::string shown(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.6g", value);
    return buffer;
}

} // namespace

std::optional<double> parseNumber(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('+')) {
        text.remove_prefix(1);
    }
    double value = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = fault == std::errc() && end == text.data() + text.size();
    return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

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

std::optional<double> &NumericEntry::lock(Field field) {
    switch (field) {
    case Field::X:
        return locks_.x;
    case Field::Y:
        return locks_.y;
    case Field::Angle:
        return locks_.angle;
    case Field::Plain:
    case Field::Distance:
        break;
    }
    return locks_.distance;
}

void NumericEntry::openField(Field field) {
    // The letter of a coordinate that is locked already frees it.
    if (lock(field)) {
        lock(field).reset();
        open_ = false;
    } else {
        field_ = field;
        open_ = true;
    }
    text_.clear();
    wrong_ = false;
    skipText_ = true;
}

NumericEntry::Answer NumericEntry::handle(const CanvasEvent &event, bool anchored) {
    if (event.kind == CanvasEvent::Kind::Key) {
        return key(event, anchored);
    }
    if (event.kind != CanvasEvent::Kind::Text) {
        return Answer::Unused;
    }
    const bool letter = event.character >= U'A' && event.character != U'e';
    if (std::exchange(skipText_, false) && letter) {
        return Answer::Used;
    }
    if (!belongsToNumber(event.character) || (!open_ && !anchored)) {
        return open_ ? Answer::Used : Answer::Unused;
    }
    if (!open_) {
        if (event.character == U' ' || event.character == U'e' || event.character == U'+') {
            return Answer::Unused;
        }
        open_ = true;
        field_ = Field::Plain;
        text_.clear();
    }
    text_ += static_cast<char>(event.character);
    wrong_ = false;
    return Answer::Used;
}

NumericEntry::Answer NumericEntry::key(const CanvasEvent &event, bool anchored) {
    skipText_ = false;
    if (event.modifiers.control() || event.modifiers.alt()) {
        return Answer::Unused;
    }
    if (open_) {
        switch (event.key) {
        case key::kEnter:
        case key::kKeypadEnter:
            return accept();
        case key::kTab: {
            const Field next = field_ == Field::X ? Field::Y : field_ == Field::Distance ? Field::Angle : field_;
            const Answer answer = accept();
            if (answer == Answer::Used && !wrong_ && next != field_ && !lock(next)) {
                openField(next);
                skipText_ = false;
            }
            return answer;
        }
        case key::kEscape:
            open_ = wrong_ = false;
            text_.clear();
            return Answer::Used;
        case key::kBackspace:
            if (text_.empty()) {
                open_ = false;
            } else {
                text_.pop_back();
            }
            wrong_ = false;
            return Answer::Used;
        default:
            break;
        }
    }
    switch (event.key) {
    case 'X':
        openField(Field::X);
        return Answer::Used;
    case 'Y':
        openField(Field::Y);
        return Answer::Used;
    case 'D':
    case 'Q':
        if (!anchored) {
            return open_ ? Answer::Used : Answer::Unused;
        }
        openField(event.key == 'D' ? Field::Distance : Field::Angle);
        return Answer::Used;
    default:
        // The characters of a number arrive as text; their keys must not run shortcuts meanwhile.
        return open_ || (anchored && isDigitKey(event.key)) ? Answer::Used : Answer::Unused;
    }
}

NumericEntry::Answer NumericEntry::accept() {
    if (field_ == Field::Plain) {
        if (const auto typed = parsePair(text_)) {
            pair_ = typed;
            open_ = false;
            return Answer::Place;
        }
    }
    const auto value = parseNumber(text_);
    const bool isLength = field_ == Field::Plain || field_ == Field::Distance;
    if (!value || (isLength && !(*value > 0.0))) {
        wrong_ = true;
        return Answer::Used;
    }
    lock(field_) = *value;
    open_ = false;
    text_.clear();
    const bool determined = field_ == Field::Plain || (locks_.x && locks_.y) || (locks_.distance && locks_.angle);
    return determined ? Answer::Place : Answer::Used;
}

std::string NumericEntry::label() const {
    std::string result;
    const auto add = [&](const char *name, const std::string &value) {
        result += (result.empty() ? "" : "   ") + std::string(name) + value;
    };
    const auto field = [&](const char *name, Field which, const std::optional<double> &value) {
        if (open_ && field_ == which) {
            add(name, text_ + "_");
        } else if (value) {
            add(name, shown(*value));
        }
    };
    field("x ", Field::X, locks_.x);
    field("y ", Field::Y, locks_.y);
    field("d ", Field::Distance, locks_.distance);
    field("\xe2\x88\xa0 ", Field::Angle, locks_.angle);
    field("", Field::Plain, std::nullopt);
    return result;
}

} // namespace forefront
