#include "core/files/text/text_scanner.hpp"

#include "core/engine/base/cancelled.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace forefront {

std::optional<double> parseReal(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+') {
        text.remove_prefix(1);
    }
    double value = 0.0;
    const char *const end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, value);
    if (problem == std::errc::invalid_argument) {
        return std::nullopt;
    }
    if (stop == end) {
        if (problem == std::errc{}) {
            return value;
        }
        const std::size_t exponent = text.find_first_of("eE");
        const bool tiny = exponent != std::string_view::npos ? text.substr(exponent + 1).starts_with('-')
                                                             : text.find_first_of("123456789") > text.find('.');
        return tiny ? 0.0 : std::numeric_limits<double>::infinity();
    }
    if (*stop == 'd' || *stop == 'D') {
        std::string copy(text);
        copy[static_cast<std::size_t>(stop - text.data())] = 'e';
        return copy.find_first_of("dD") == std::string::npos ? parseReal(copy) : std::nullopt;
    }
    return std::nullopt;
}

bool TextScanner::fail(std::size_t offset, std::string code, std::string message, std::string advice) {
    if (ok()) {
        message += namesBytes_ ? ", at byte " + std::to_string(offset) : "";
        faults_.push_back(faultAt(*source_, offset, std::move(code), std::move(message), std::move(advice)));
    }
    return false;
}

bool TextScanner::fail(const TextScanner &other) {
    if (ok()) {
        faults_ = other.faults_;
    }
    return false;
}

bool TextScanner::pause(std::size_t offset) {
    pauseAt_ = offset + kPause;
    if (stopped()) {
        return false;
    }
    source_->options.progress("reading " + std::filesystem::path(source_->name).filename().string(),
                              static_cast<double>(offset) / static_cast<double>(source_->text.size()));
    return ok();
}

bool TextScanner::stopped() {
    if (ok() && source_->options.progress.cancelled()) {
        faults_ = cancelled("reading");
        return true;
    }
    return false;
}

void TextScanner::skipBlanks() {
    while (at_ < end_) {
        if (blank(text_[at_])) {
            ++at_;
        } else if (text_[at_] == comment_) {
            skipLine();
        } else {
            return;
        }
    }
}

void TextScanner::skipLine() {
    const std::size_t lineEnd = std::string_view(text_, end_).find('\n', at_);
    at_ = lineEnd == std::string_view::npos ? end_ : lineEnd + 1;
}

std::string_view TextScanner::peek() {
    skipBlanks();
    std::size_t stop = at_;
    while (!delimits(stop)) {
        ++stop;
    }
    return {text_ + at_, stop - at_};
}

std::string_view TextScanner::word() {
    const std::string_view text = peek();
    at_ += text.size();
    return text;
}

bool TextScanner::quotedWord(std::string_view &text, Expect expect) {
    if (!ok()) {
        return false;
    }
    if (peek().empty()) {
        return failExpected("a name", expect);
    }
    if (text_[at_] != '"') {
        text = word();
        return true;
    }
    const std::string_view line = std::string_view(text_, end_).substr(at_ + 1);
    const std::size_t close = line.find_first_of("\"\n");
    if (close == std::string_view::npos || line[close] == '\n') {
        return fail(at_, "bad-name", "the closing double quote of " + expect.words() + " is missing");
    }
    text = line.substr(0, close);
    at_ += close + 2;
    return true;
}

bool TextScanner::literal(std::string_view expected) {
    if (!ok()) {
        return false;
    }
    const std::string_view found = peek();
    if (found != expected) {
        return fail(at_, "bad-syntax",
                    "expected " + std::string(expected) +
                        (found.empty() ? std::string(", found the end of the file") : ", found " + inQuotes(found)));
    }
    at_ += found.size();
    return true;
}

bool TextScanner::failExpected(const char *kind, Expect expect) {
    const std::string_view found = peek();
    const char *const what = end_ == source_->text.size() ? "file" : "line";
    return fail(at_, "bad-number",
                std::string("expected ") + kind + " for " + expect.words() +
                    (found.empty() ? std::string(", the ") + what + " ends here" : ", found " + inQuotes(found)));
}

bool TextScanner::real(double &value, Expect expect) {
    if (!ok() || !proceed(at_)) {
        return false;
    }
    skipBlanks();
    const auto [stop, problem] = std::from_chars(text_ + at_, text_ + end_, value);
    if (problem == std::errc{} && delimits(static_cast<std::size_t>(stop - text_)) && std::isfinite(value)) {
        at_ = static_cast<std::size_t>(stop - text_);
        return true;
    }
    const std::string_view found = peek();
    const auto number = parseReal(found);
    if (!number) {
        return failExpected("a number", expect);
    }
    if (!std::isfinite(*number)) {
        return fail(at_, "non-finite", expect.words() + " must be finite, found " + inQuotes(found));
    }
    value = *number;
    at_ += found.size();
    return true;
}

bool TextScanner::integer(std::int64_t &value, std::int64_t minimum, std::int64_t maximum, Expect expect) {
    if (!ok() || !proceed(at_)) {
        return false;
    }
    skipBlanks();
    const std::size_t sign = at_ + 1 < end_ && text_[at_] == '+' && text_[at_ + 1] != '-' ? 1 : 0;
    const auto [stop, problem] = std::from_chars(text_ + at_ + sign, text_ + end_, value);
    if (problem == std::errc::invalid_argument || !delimits(static_cast<std::size_t>(stop - text_))) {
        return failExpected("an integer", expect);
    }
    if (problem != std::errc{} || value < minimum || value > maximum) {
        return fail(at_, "out-of-range",
                    "expected an integer from " + std::to_string(minimum) + " to " + std::to_string(maximum) + " for " +
                        expect.words() + ", found " + inQuotes(peek()));
    }
    at_ = static_cast<std::size_t>(stop - text_);
    return true;
}

bool TextScanner::count(std::size_t &value, std::size_t bytes, Expect expect) {
    skipBlanks();
    const std::size_t place = at_;
    std::int64_t number = 0;
    if (!integer(number, 0, std::numeric_limits<std::int64_t>::max(), expect)) {
        return false;
    }
    // The last item needs no separator after it.
    if (static_cast<std::uint64_t>(number) > (remaining() + 1) / bytes) {
        return fail(place, "bad-count",
                    expect.words() + " is given as " + std::to_string(number) + ", but only " +
                        std::to_string(remaining()) + " bytes follow",
                    "the file may have been cut short");
    }
    value = static_cast<std::size_t>(number);
    return true;
}

bool TextScanner::nextLine(TextScanner &line) {
    skipBlanks();
    if (at_ == end_ || !proceed(at_)) {
        return false;
    }
    const std::size_t begin = at_;
    const std::size_t lineEnd = std::min(std::string_view(text_, end_).find('\n', begin), end_);
    line = part(begin, lineEnd);
    at_ = std::min(lineEnd + 1, end_);
    return true;
}

std::string_view TextScanner::rest() {
    skipBlanks();
    std::size_t stop = end_;
    while (stop > at_ && blank(text_[stop - 1])) {
        --stop;
    }
    const std::string_view text(text_ + at_, stop - at_);
    at_ = end_;
    return text;
}

} // namespace forefront
