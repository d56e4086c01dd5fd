#include "core/io/svg/svg_transform.hpp"

#include "core/io/svg/svg_pen.hpp"

#include <cmath>
#include <numbers>

namespace forefront {

AffineMap AffineMap::operator*(const AffineMap &inner) const {
    return {a * inner.a + c * inner.b, b * inner.a + d * inner.b,     a * inner.c + c * inner.d,
            b * inner.c + d * inner.d, a * inner.e + c * inner.f + e, b * inner.e + d * inner.f + f};
}

double AffineMap::stretch() const {
    // Maximum singular value of the 2x2 part.
    const double sum = 0.5 * (a * a + b * b + c * c + d * d);
    const double determinant = a * d - b * c;
    return std::sqrt(sum + std::sqrt(std::max(0.0, sum * sum - determinant * determinant)));
}

namespace {

/// Returns one function of the list; std::nullopt if it has the wrong number of arguments.
std::optional<AffineMap> function(std::string_view name, const double *v, std::size_t count) {
    const double radians = std::numbers::pi / 180.0;
    if (name == "matrix" && count == 6) {
        return AffineMap{v[0], v[1], v[2], v[3], v[4], v[5]};
    }
    if (name == "translate" && (count == 1 || count == 2)) {
        return AffineMap{1, 0, 0, 1, v[0], count == 2 ? v[1] : 0.0};
    }
    if (name == "scale" && (count == 1 || count == 2)) {
        return AffineMap{v[0], 0, 0, count == 2 ? v[1] : v[0], 0, 0};
    }
    if (name == "rotate" && (count == 1 || count == 3)) {
        const double cosine = std::cos(v[0] * radians), sine = std::sin(v[0] * radians);
        const AffineMap turn{cosine, sine, -sine, cosine, 0, 0};
        if (count == 1) {
            return turn;
        }
        return AffineMap{1, 0, 0, 1, v[1], v[2]} * turn * AffineMap{1, 0, 0, 1, -v[1], -v[2]};
    }
    if (name == "skewX" && count == 1) {
        return AffineMap{1, 0, std::tan(v[0] * radians), 1, 0, 0};
    }
    if (name == "skewY" && count == 1) {
        return AffineMap{1, std::tan(v[0] * radians), 0, 1, 0, 0};
    }
    return std::nullopt;
}

} // namespace

std::optional<AffineMap> parseTransform(std::string_view text) {
    AffineMap map;
    while (true) {
        const std::size_t begin = text.find_first_not_of(" \t\r\n,");
        if (begin == std::string_view::npos || text.substr(begin) == "none") {
            return map;
        }
        const std::size_t open = text.find('(', begin);
        const std::size_t close = text.find(')', begin);
        if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
            return std::nullopt;
        }
        std::string_view name = text.substr(begin, open - begin);
        name = name.substr(0, name.find_last_not_of(" \t\r\n") + 1);
        SvgNumbers numbers(text.substr(open + 1, close - open - 1));
        double values[6] = {};
        std::size_t count = 0;
        while (!numbers.atEnd()) {
            if (count == 6 || !numbers.number(values[count])) {
                return std::nullopt;
            }
            ++count;
        }
        const auto next = function(name, values, count);
        if (!next) {
            return std::nullopt;
        }
        map = map * *next;
        text = text.substr(close + 1);
    }
}

} // namespace forefront
