#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/references.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace forefront {

/// Returns the value of an expression that is a number as it stands.
std::optional<double> plainNumber(std::string_view text);

/// A place as two expressions, each a formula or a number.
struct PlaceFormula {
    std::string x, y;
};

PlaceFormula placeFormula(Vec2 at);

/// Returns the place of a handle: the formulas of its coordinates, and numbers where it has none.
PlaceFormula placeFormula(const Document &document, NodeRef handle);

/// Returns the sum or the difference of two expressions, short enough to be read: numbers are added, zeros left out.
std::string sumFormula(const std::string &a, const std::string &b);
std::string differenceFormula(const std::string &a, const std::string &b);

/// Returns the angle of a direction in degrees, without the rounding of whole degrees.
std::string degreesText(Vec2 direction);

/// Returns the place at a distance and an angle in degrees from another place. All are expressions.
PlaceFormula polarFormula(const PlaceFormula &from, const std::string &distance, const std::string &degrees);

/// Returns true if an expression uses a name, such as a parameter's.
bool usesNames(const std::string &text);

/// Lets the second end of a straight segment of a path follow an expression for the length of the segment, measured
/// from the first end, which may itself follow formulas. The segment must already have that length. A text without
/// names removes nothing and adds nothing.
Document followLength(Document document, SegmentRef segment, const std::string &length);

} // namespace forefront
