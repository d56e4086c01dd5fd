#include "core/drawing/formulas/source_numbers.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/spacing/spec/source_box.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace forefront {
namespace {

/// Returns a pointer to a number that a source stores, or null.
template <class Source>
auto storedNumber(Source &source, const std::string &name) -> decltype(&source.size) {
    if (name == "endSize") {
        return source.endSize ? &*source.endSize : nullptr;
    }
    const std::array<std::pair<std::string_view, decltype(&source.size)>, 8> numbers{{{"x", &source.a.x},
                                                                                      {"y", &source.a.y},
                                                                                      {"x2", &source.b.x},
                                                                                      {"y2", &source.b.y},
                                                                                      {"angle", &source.angle},
                                                                                      {"radius", &source.radius},
                                                                                      {"size", &source.size},
                                                                                      {"growth", &source.growth}}};
    const auto found =
        std::find_if(numbers.begin(), numbers.end(), [&](const auto &entry) { return entry.first == name; });
    return found != numbers.end() ? found->second : nullptr;
}

bool isExtent(const SizeSource &source, const std::string &name) {
    return source.shape == SourceShape::Box && (name == "width" || name == "height");
}

} // namespace

std::optional<double> sourceNumber(const SizeSource &source, const std::string &name) {
    if (isExtent(source, name)) {
        return name == "width" ? boxExtent(source).x : boxExtent(source).y;
    }
    const double *const place = storedNumber(source, name);
    return place != nullptr ? std::optional(*place) : std::nullopt;
}

Status setSourceNumber(SizeSource &source, const std::string &name, double value) {
    if (name == "angle" && source.shape == SourceShape::Box) {
        turnBox(source, value);
        return {};
    }
    if (!isExtent(source, name)) {
        *storedNumber(source, name) = value;
        return {};
    }
    if (!(value > 0.0)) {
        return error("bad-number",
                     "invalid " + name + ' ' + numberText(value, 6) + " of a size source; expected a number above 0");
    }
    const Vec2 extent = boxExtent(source);
    resizeBox(source, name == "width" ? Vec2{value, extent.y} : Vec2{extent.x, value});
    return {};
}

} // namespace forefront
