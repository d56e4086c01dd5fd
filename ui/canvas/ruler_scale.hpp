#pragma once

#include <string>

namespace forefront {

/// The marks of a ruler: a labelled one every `major` units, divided into `divisions` equal parts. Both steps are 1, 2
/// or 5 times a power of ten.
struct RulerScale {
    double major = 1.0;
    int divisions = 1;

    double minor() const { return major / divisions; }
};

/// Returns the finest scale whose labels are at least `minLabel` pixels apart and its marks at least `minMark`.
/// `unitsPerPixel` must be positive and finite.
RulerScale rulerScale(double unitsPerPixel, double minLabel, double minMark);

/// Returns the text of a label: the value with the digits that a step of `major` needs.
std::string rulerText(double value, double major);

} // namespace forefront
