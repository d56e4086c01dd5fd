#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace forefront {

/// The address of a number of a document.
///
/// "shape/ID/x/K" and "shape/ID/y/K" for handle K (see handlesOf()), "shape/ID/radius" for a circle or rounded corners,
/// "shape/ID/size/K" and "shape/ID/growth/K" for the size at a node, "shape/ID/arcRadius/K" for segment K of a path, an
/// arc of a circle, "shape/ID/rx" and "ry" for an ellipse, "shape/ID/left", "bottom", "width", "height" for a
/// rectangle, "shape/ID/width" and "length" for a slot (the distance between its centres); "source/K/x", "y", "x2",
/// "y2", "angle", "radius", "size", "endSize", "growth" for a size source, "width" and "height" for a box, along its
/// angle and across it; "region/K/x", "y", "area", "size", "growth" for a region marker; "part/TAG/size", "elements",
/// "growth" for a boundary part; "spacing/size", "minimum", "maximum", "gradation", "segmentsPerTurn",
/// "elementsAcross", "curveTolerance". ID is that of the shape; indices count from 0.
struct NumberAddress {
    enum class Owner : std::uint8_t { Shape, Source, Region, Part, Spacing };
    Owner owner = Owner::Spacing;
    std::uint32_t id = 0;     ///< of the shape; index of the source or marker; tag of the part
    std::string quantity;     ///< "x", "radius", "size", ...
    std::uint32_t handle = 0; ///< of "x", "y", "size", "growth" and "arcRadius" of a shape
};

std::optional<NumberAddress> parseAddress(std::string_view address);
std::string toString(const NumberAddress &address);

/// Returns the number, or none if its owner does not exist or has no such number.
std::optional<double> readNumber(const Document &document, const NumberAddress &address);
/// Returns the number at an address, or none if there is no such number.
std::optional<double> numberAt(const Document &document, std::string_view address);
/// Sets an existing number to a finite value. It does not check whether the result is valid: see checkedOwner(). Error:
/// bad-number for a length that is not above 0.
Status setNumber(Document &document, const NumberAddress &address, double value);
/// Checks the owner of a number after setNumber(): its shape, source, marker, the sizes of the boundary parts, or the
/// limits of the spacing. Returns the document if the owner is valid. Errors: those of the commands that change it.
Result<Document> checkedOwner(const Document &document, const NumberAddress &address);

/// Returns what a number is in words, such as "radius of circle 3" or "x of node 2 of polygon 1"; the address itself if
/// its owner does not exist.
std::string numberName(const Document &document, std::string_view address);

/// Returns true if a number exists and has a value, up to rounding.
bool hasValue(const Document &document, const NumberAddress &address, double value);

/// Returns the address of a number after a command, which may have inserted or removed nodes, sources or markers; none
/// if the number no longer exists.
std::optional<std::string> movedAddress(const Document &before, const Document &next, const std::string &address);

} // namespace forefront
