#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

#include <optional>
#include <string>

namespace forefront {

/// Returns the number, or none if its owner does not exist or has no such number.
std::optional<double> readNumber(const Document &document, const NumberAddress &address);
/// Sets an existing number to a finite value. It does not check whether the result is valid: see checkedOwner(). Error:
/// bad-number for a length that is not above 0.
Status setNumber(Document &document, const NumberAddress &address, double value);
/// Checks the owner of a number after setNumber(): its shape, source, marker, the sizes of the boundary parts, or the
/// limits of the spacing. Returns the document if the owner is valid. Errors: as for the commands that change the
/// owner.
Result<Document> checkedOwner(const Document &document, const NumberAddress &address);

/// Returns the power of the unit of length that a number has: 1 for a length or a coordinate, 2 for an area, 0 for
/// others, such as an angle or a number of elements.
int lengthPower(const Document &document, const NumberAddress &address);

/// Describes a number in words, such as "radius of circle 3" or "x of node 2 of polygon 1"; the text of the address if
/// there is no such number.
std::string numberName(const Document &document, const NumberAddress &address);

/// Returns true if a number exists and has a value, up to rounding.
bool hasValue(const Document &document, const NumberAddress &address, double value);

/// Returns the address of a number after a command, which may have inserted or removed nodes, sources or markers; none
/// if the number no longer exists.
std::optional<NumberAddress> movedAddress(const Document &before, const Document &next, const NumberAddress &address);

} // namespace forefront
