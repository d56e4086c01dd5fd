#pragma once

#include "core/drawing/document/document.hpp"
#include "core/files/json/json_check.hpp"

#include <map>
#include <string>

namespace forefront {

/// Reads the members "parameters", an object from names to numbers or expressions, and "formulas", an object from
/// addresses of numbers (see NumberAddress) to expressions, of a project whose other members have been read. A number
/// with a formula gets the formula's value, even if the file stores a different one. `overrides` replaces the
/// expressions of some parameters. Faults are added to `check`.
void readParameters(const JsonValue &root, const std::map<std::string, std::string> &overrides, Document &document,
                    JsonCheck &check);

} // namespace forefront
