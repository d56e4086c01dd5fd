#include "core/drawing/formulas/source_numbers.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/spacing/spec/source_box.hpp"

#include <string>

namespace forefront {
namespace {

/// Returns a pointer to a number that a source stores, or null.
template <class Source>
auto storedNumber(Source &source, Quantity what) -> decltype(&source.size) {
    switch (what) {
    case Quantity::X:
        return &source.a.x;
    case Quantity::Y:
        return &source.a.y;
    case Quantity::X2:
        return &source.b.x;
    case Quantity::Y2:
        return &source.b.y;
    case Quantity::Angle:
        return &source.angle;
    case Quantity::Radius:
        return &source.radius;
    case Quantity::Size:
        return &source.size;
    case Quantity::EndSize:
        return source.endSize ? &*source.endSize : nullptr;
    case Quantity::Growth:
        return &source.growth;
    default:
        return nullptr;
    }
}

bool isExtent(const SizeSource &source, Quantity what) {
    return source.shape == SourceShape::Box && (what == Quantity::Width || what == Quantity::Height);
}

} // namespace

std::optional<double> sourceNumber(const SizeSource &source, Quantity what) {
    if (isExtent(source, what)) {
        return what == Quantity::Width ? boxExtent(source).x : boxExtent(source).y;
    }
    const double *const place = storedNumber(source, what);
    return place != nullptr ? std::optional(*place) : std::nullopt;
}

Status setSourceNumber(SizeSource &source, Quantity what, double value) {
    if (what == Quantity::Angle && source.shape == SourceShape::Box) {
        turnBox(source, value);
        return {};
    }
    if (!isExtent(source, what)) {
        *storedNumber(source, what) = value;
        return {};
    }
    if (!(value > 0.0)) {
        return error("bad-number", "invalid " + std::string(wordOf(what)) + ' ' + numberText(value, 6) +
                                       " of a size source; expected a number above 0");
    }
    const Vec2 extent = boxExtent(source);
    resizeBox(source, what == Quantity::Width ? Vec2{value, extent.y} : Vec2{extent.x, value});
    return {};
}

} // namespace forefront
