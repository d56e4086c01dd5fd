#include "core/drawing_files/svg/values/svg_pen.hpp"
#include "core/engine/base/letter_case.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace forefront {

namespace {

/// Returns the number of digits after the point of a number, less its exponent.
int decimalsOf(std::string_view number) {
    const std::size_t exponent = std::min(number.find_first_of("eE"), number.size());
    const std::size_t point = std::min(number.find('.'), exponent);
    const int digits = static_cast<int>(exponent - std::min(point + 1, exponent));
    constexpr int kMaxPower = 400; // beyond those of doubles
    int power = 0;
    if (exponent < number.size()) {
        const bool negative = number[exponent + 1] == '-';
        const std::size_t sign = negative || number[exponent + 1] == '+' ? 2 : 1;
        const auto [end, problem] =
            std::from_chars(number.data() + exponent + sign, number.data() + number.size(), power);
        power = problem == std::errc() ? std::min(power, kMaxPower) : kMaxPower;
        power = negative ? -power : power;
    }
    return digits - power;
}

} // namespace

void SvgNumbers::skipBlanks() {
    while (at_ < text_.size() && (static_cast<unsigned char>(text_[at_]) <= ' ' || (text_[at_] == ',' && !comma_))) {
        comma_ = comma_ || text_[at_] == ',';
        ++at_;
    }
}

/// Goes on after a number or a flag.
void SvgNumbers::taken(std::size_t end) {
    at_ = end;
    comma_ = false;
}

bool SvgNumbers::atEnd() {
    skipBlanks();
    return at_ == text_.size();
}

char SvgNumbers::peek() {
    skipBlanks();
    return at_ < text_.size() ? text_[at_] : '\0';
}

bool SvgNumbers::more() {
    const char c = peek();
    return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+';
}

bool SvgNumbers::number(double &value) {
    if (!more()) {
        return false;
    }
    const std::size_t plus = text_[at_] == '+' ? 1 : 0;
    const char *const begin = text_.data() + at_ + plus;
    const char *const end = text_.data() + text_.size();
    const char *const digit = begin < end && *begin == '-' && plus == 0 ? begin + 1 : begin;
    if (digit == end || !((*digit >= '0' && *digit <= '9') || *digit == '.')) {
        return false;
    }
    const auto [stop, problem] = std::from_chars(begin, end, value);
    if (problem == std::errc::invalid_argument) {
        return false;
    }
    if (problem == std::errc::result_out_of_range) {
        const std::string_view token(begin, static_cast<std::size_t>(stop - begin));
        if (token.find("e-") == std::string_view::npos && token.find("E-") == std::string_view::npos) {
            return false;
        }
        value = 0.0;
    }
    decimals_ = std::max(decimals_, decimalsOf({digit, static_cast<std::size_t>(stop - digit)}));
    taken(static_cast<std::size_t>(stop - text_.data()));
    return std::isfinite(value);
}

std::string SvgNumbers::unit() {
    const std::size_t begin = at_;
    if (text_.substr(at_).starts_with('%')) {
        ++at_;
    } else {
        const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
        at_ = static_cast<std::size_t>(std::find_if_not(text_.begin() + at_, text_.end(), isLetter) - text_.begin());
    }
    return lowerCase(text_.substr(begin, at_ - begin));
}

bool SvgNumbers::flag(bool &value) {
    const char c = peek();
    if (c != '0' && c != '1') {
        return false;
    }
    value = c == '1';
    taken(at_ + 1);
    return true;
}

namespace {

/// Parses path data; `last*Control_` are the control points that S and T mirror.
class PathDrawer {
  public:
    PathDrawer(std::string_view data, SvgPen &pen) : numbers_(data), pen_(pen) {}

    std::optional<SvgFault> run() {
        while (!numbers_.atEnd()) {
            const char letter = numbers_.peek();
            if (std::string_view("MmLlHhVvCcSsQqTtAaZz").find(letter) == std::string_view::npos) {
                return fault("expected a path command");
            }
            if (!pen_.down() && letter != 'M' && letter != 'm') {
                return fault("path data must begin with M or m");
            }
            numbers_.skip();
            relative_ = letter >= 'a';
            command_ = relative_ ? static_cast<char>(letter - 'a' + 'A') : letter;
            if (command_ == 'Z') {
                pen_.close();
                steps_ = 0;
                previous_ = 'Z';
                continue;
            }
            do {
                if (!segment()) {
                    return fault(std::string("expected a number for path command ") + letter);
                }
                noteRounding();
                previous_ = command_;
                command_ = command_ == 'M' ? 'L' : command_;
            } while (numbers_.more());
        }
        return std::nullopt;
    }

  private:
    SvgFault fault(std::string message) const { return {numbers_.offset(), std::move(message)}; }

    bool point(Vec2 &p) {
        if (!numbers_.point(p)) {
            return false;
        }
        p = relative_ ? pen_.at() + p : p;
        return true;
    }

    bool segment() {
        Vec2 a, b, p;
        double along = 0.0;
        switch (command_) {
        case 'M':
            if (!point(p)) {
                return false;
            }
            pen_.moveTo(p);
            return true;
        case 'L':
            if (!point(p)) {
                return false;
            }
            pen_.lineTo(p);
            return true;
        case 'H':
        case 'V':
            if (!numbers_.number(along)) {
                return false;
            }
            p = pen_.at();
            (command_ == 'H' ? p.x : p.y) = along + (!relative_ ? 0.0 : command_ == 'H' ? p.x : p.y);
            pen_.lineTo(p);
            return true;
        case 'C':
            return point(a) && point(b) && point(p) && cubic(a, b, p);
        case 'S':
            a = previous_ == 'C' || previous_ == 'S' ? mirrored() : pen_.at();
            return point(b) && point(p) && cubic(a, b, p);
        case 'Q':
            return point(a) && point(p) && quadratic(a, p);
        case 'T':
            a = previous_ == 'Q' || previous_ == 'T' ? mirrored() : pen_.at();
            return point(p) && quadratic(a, p);
        default:
            return arc();
        }
    }

    /// Relative steps are rounded each, so that errors add up as in a random walk. An absolute command ends that, but H
    /// and V for one coordinate alone.
    void noteRounding() {
        constexpr double kUnits = 1.5; // in units of the last digit; three standard deviations are 1.2
        const bool half = command_ == 'H' || command_ == 'V';
        steps_ = command_ == 'M' ? 0 : relative_ ? steps_ + 1 : half ? steps_ : 0;
        pen_.setRounding(kUnits * std::pow(10.0, -numbers_.decimals()) * std::sqrt(steps_));
    }

    Vec2 mirrored() const { return pen_.at() + (pen_.at() - control_); }
    bool cubic(Vec2 a, Vec2 b, Vec2 p) {
        control_ = b;
        pen_.cubicTo(a, b, p);
        return true;
    }
    bool quadratic(Vec2 a, Vec2 p) {
        control_ = a;
        pen_.quadraticTo(a, p);
        return true;
    }
    bool arc() {
        EllipticalArc arc;
        Vec2 p;
        if (!numbers_.number(arc.radiusX) || !numbers_.number(arc.radiusY) || !numbers_.number(arc.rotationDegrees) ||
            !numbers_.flag(arc.largeArc) || !numbers_.flag(arc.sweep) || !point(p)) {
            return false;
        }
        pen_.arcTo(arc, p);
        return true;
    }

    SvgNumbers numbers_;
    SvgPen &pen_;
    char command_ = 'M', previous_ = 'M';
    bool relative_ = false;
    int steps_ = 0; ///< relative commands since the pen was at a place that is given
    Vec2 control_;
};

} // namespace

std::optional<SvgFault> drawPath(std::string_view data, SvgPen &pen) {
    return PathDrawer(data, pen).run();
}

std::optional<SvgFault> readPoints(std::string_view data, std::vector<Vec2> &points) {
    SvgNumbers numbers(data);
    while (!numbers.atEnd()) {
        Vec2 p;
        if (!numbers.point(p)) {
            return SvgFault{numbers.offset(), "expected pairs of numbers"};
        }
        points.push_back(p);
    }
    return std::nullopt;
}

} // namespace forefront
