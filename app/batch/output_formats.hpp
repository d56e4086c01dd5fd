#pragma once

#include "app/batch/outputs.hpp"
#include "core/files/format_list.hpp"

#include <string>
#include <vector>

namespace forefront {

/// Something that a format can do, such as &FileFormat::namesUnit.
using FormatTrait = bool FileFormat::*;

/// Returns the format in which a mesh is written to an output; null if its id or extension is unknown.
const FileFormat *formatOf(const Output &output);

/// Returns true if the format of one of the outputs has a trait.
bool anyHas(const std::vector<Output> &outputs, FormatTrait trait);

/// Returns the ids of the formats that have a trait, separated by commas.
std::string idsOf(FormatTrait trait);

} // namespace forefront
