#include "core/drawing_files/svg/values/svg_transform.hpp"

#include "core/drawing_files/svg/values/svg_pen.hpp"
#include "core/drawing_files/svg/values/svg_viewport.hpp"
#include "core/drawing_files/svg/xml/svg_elements.hpp"
#include "core/engine/base/letter_case.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

AffineMap AffineMap::operator*(const AffineMap &inner) const {
    return {a * inner.a + c * inner.b, b * inner.a + d * inner.b,     a * inner.c + c * inner.d,
            b * inner.c + d * inner.d, a * inner.e + c * inner.f + e, b * inner.e + d * inner.f + f};
}

std::optional<AffineMap> AffineMap::inverse() const {
    const double determinant = a * d - b * c, factor = 1.0 / determinant;
    if (determinant == 0.0 || !std::isfinite(factor)) {
        return std::nullopt;
    }
    return AffineMap{
        factor * d, -factor * b, -factor * c, factor * a, factor * (c * f - d * e), factor * (b * e - a * f)};
}

double AffineMap::stretch() const {
    // Maximum singular value of the 2x2 part.
    const double sum = 0.5 * (a * a + b * b + c * c + d * d);
    const double determinant = a * d - b * c;
    return std::sqrt(sum + std::sqrt(std::max(0.0, sum * sum - determinant * determinant)));
}

namespace {

/// A number of a transform with its unit.
struct Argument {
    double value = 0.0;
    std::string unit;
};
constexpr std::size_t kMaxArguments = 6;
using Arguments = std::vector<Argument>;

/// Returns the arguments between the brackets of a function; std::nullopt if they are malformed or too many.
std::optional<Arguments> argumentsOf(std::string_view text) {
    Arguments arguments;
    const std::size_t last = text.find_last_not_of(kBlanks);
    if (last != std::string_view::npos && text[last] == ',') {
        return std::nullopt;
    }
    SvgNumbers numbers(text);
    while (!numbers.atEnd()) {
        Argument argument;
        if (arguments.size() == kMaxArguments || !numbers.number(argument.value)) {
            return std::nullopt;
        }
        argument.unit = numbers.unit();
        arguments.push_back(std::move(argument));
    }
    return arguments;
}

/// Returns an angle in radians; plain numbers are degrees.
std::optional<double> radians(const Argument &angle) {
    constexpr double kTurn = 2.0 * std::numbers::pi;
    constexpr std::array<std::pair<std::string_view, double>, 5> kUnits = {
        {{"", kTurn / 360.0}, {"deg", kTurn / 360.0}, {"grad", kTurn / 400.0}, {"rad", 1.0}, {"turn", kTurn}}};
    for (const auto &[name, factor] : kUnits) {
        if (angle.unit == name) {
            return factor * angle.value;
        }
    }
    return std::nullopt;
}

/// Returns a length in user units.
std::optional<double> extent(const Argument &length, double whole) {
    if (length.unit == "%") {
        return length.value / 100.0 * whole;
    }
    const auto factor = pixelsPer(length.unit);
    return factor ? std::optional(*factor * length.value) : std::nullopt;
}

std::optional<double> factorOf(const Argument &factor) {
    return factor.unit.empty()  ? std::optional(factor.value)
           : factor.unit == "%" ? std::optional(factor.value / 100.0)
                                : std::nullopt;
}

AffineMap turned(double angle) {
    const double cosine = std::cos(angle), sine = std::sin(angle);
    return {cosine, sine, -sine, cosine, 0, 0};
}

std::optional<AffineMap> matrix(const Arguments &v) {
    if (v.size() != 6 || std::any_of(v.begin(), v.end(), [](const Argument &a) { return !a.unit.empty(); })) {
        return std::nullopt;
    }
    return AffineMap{v[0].value, v[1].value, v[2].value, v[3].value, v[4].value, v[5].value};
}

std::optional<AffineMap> rotation(const Arguments &v, Vec2 viewport) {
    const auto angle = v.empty() ? std::nullopt : radians(v[0]);
    if (!angle || (v.size() != 1 && v.size() != 3)) {
        return std::nullopt;
    }
    if (v.size() == 1) {
        return turned(*angle);
    }
    const auto x = extent(v[1], viewport.x), y = extent(v[2], viewport.y);
    return x && y
               ? std::optional(AffineMap::translation({*x, *y}) * turned(*angle) * AffineMap::translation({-*x, -*y}))
               : std::nullopt;
}

/// Returns the two numbers of a function; the second one is `otherwise` if there is only one.
template <typename Read>
std::optional<Vec2> pairOf(const Arguments &v, const Read &read, std::optional<double> otherwise) {
    if (v.empty() || v.size() > 2) {
        return std::nullopt;
    }
    const auto x = read(v[0], 0), y = v.size() == 2 ? read(v[1], 1) : otherwise ? otherwise : x;
    return x && y ? std::optional(Vec2{*x, *y}) : std::nullopt;
}

/// Returns one function of the list, by its name in lower case; std::nullopt if it does not exist or has other
/// arguments.
std::optional<AffineMap> function(std::string_view name, const Arguments &v, Vec2 viewport) {
    const auto length = [&](const Argument &a, int axis) { return extent(a, axis == 0 ? viewport.x : viewport.y); };
    const auto factor = [](const Argument &a, int /*axis*/) { return factorOf(a); };
    const auto slope = [](const Argument &a, int /*axis*/) {
        const auto angle = radians(a);
        return angle ? std::optional(std::tan(*angle)) : std::nullopt;
    };
    const bool one = v.size() == 1;
    std::optional<Vec2> p;
    if (name == "matrix") {
        return matrix(v);
    }
    if (name == "rotate") {
        return rotation(v, viewport);
    }
    if (name == "translate" && (p = pairOf(v, length, 0.0))) {
        return AffineMap::translation(*p);
    }
    if (name == "translatex" && one && (p = pairOf(v, length, 0.0))) {
        return AffineMap::translation({p->x, 0.0});
    }
    if (name == "translatey" && one && length(v[0], 1)) {
        return AffineMap::translation({0.0, *length(v[0], 1)});
    }
    if (name == "scale" && (p = pairOf(v, factor, std::nullopt))) {
        return AffineMap{p->x, 0, 0, p->y, 0, 0};
    }
    if ((name == "scalex" || name == "scaley") && one && (p = pairOf(v, factor, 1.0))) {
        return name == "scalex" ? AffineMap{p->x, 0, 0, 1, 0, 0} : AffineMap{1, 0, 0, p->x, 0, 0};
    }
    if (name == "skew" && (p = pairOf(v, slope, 0.0))) {
        return AffineMap{1, p->y, p->x, 1, 0, 0};
    }
    if ((name == "skewx" || name == "skewy") && one && (p = pairOf(v, slope, 0.0))) {
        return name == "skewx" ? AffineMap{1, 0, p->x, 1, 0, 0} : AffineMap{1, p->x, 0, 1, 0, 0};
    }
    return std::nullopt;
}

} // namespace

std::optional<AffineMap> parseTransform(std::string_view text, Vec2 viewport) {
    AffineMap map;
    while (true) {
        const std::size_t begin = text.find_first_not_of(" \t\r\n\f,");
        if (begin == std::string_view::npos || text.substr(begin) == "none") {
            return map;
        }
        const std::size_t open = text.find('(', begin);
        const std::size_t close = text.find(')', begin);
        if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
            return std::nullopt;
        }
        std::string_view name = text.substr(begin, open - begin);
        name = name.substr(0, name.find_last_not_of(kBlanks) + 1);
        const auto arguments = argumentsOf(text.substr(open + 1, close - open - 1));
        const auto next = arguments ? function(lowerCase(name), *arguments, viewport) : std::nullopt;
        if (!next) {
            return std::nullopt;
        }
        map = map * *next;
        text = text.substr(close + 1);
    }
}

std::optional<Vec2> parseTransformOrigin(std::string_view text, Vec2 viewport) {
    std::array<std::optional<double>, 2> place; // in the directions x and y
    std::size_t words = 0;
    for (std::size_t begin = 0; (begin = text.find_first_not_of(kBlanks, begin)) != std::string_view::npos; ++words) {
        const std::size_t end = std::min(text.find_first_of(kBlanks, begin), text.size());
        const std::string word = lowerCase(text.substr(begin, end - begin));
        begin = end;
        const bool alongX = word == "left" || word == "right", alongY = word == "top" || word == "bottom";
        const std::size_t axis = alongX ? 0 : alongY ? 1 : std::min<std::size_t>(words, 1);
        const double whole = axis == 0 ? viewport.x : viewport.y;
        if (words == 2) {
            break; // the third is the depth
        }
        if (word == "center") {
            continue; // an axis that nothing else fixes
        }
        if (place[axis]) {
            return std::nullopt;
        }
        if (word == "left" || word == "top") {
            place[axis] = 0.0;
        } else if (word == "right" || word == "bottom") {
            place[axis] = whole;
        } else if (const auto given = argumentsOf(word); given && given->size() == 1) {
            place[axis] = extent(given->front(), whole);
        }
        if (!place[axis]) {
            return std::nullopt;
        }
    }
    if (words == 0) {
        return std::nullopt;
    }
    return Vec2{place[0].value_or(0.5 * viewport.x), place[1].value_or(0.5 * viewport.y)};
}

} // namespace forefront
