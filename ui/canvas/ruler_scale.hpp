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

/// The multiples of a step from `first` to `first + count - 1`.
struct Multiples {
    double first = 0.0;
    int count = 0;
};

/// Returns the multiples of a positive step in an interval, at most 10,000: far from the origin a step can be lost in
/// rounding.
Multiples multiplesWithin(double low, double high, double step);

/// Returns the text of a label: the value with the digits that a step of `major` needs.
std::string rulerText(double value, double major);

} // namespace forefront
