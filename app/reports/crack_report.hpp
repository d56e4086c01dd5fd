#pragma once

#include "core/engine/mesh/cracks.hpp"
#include "core/files/json/json_writer.hpp"

#include <cstdint>
#include <map>
#include <string>

namespace forefront {

/// Adds the member "cracks": names of the faces, edges and length of each, then nodes added and tips of all.
void addCracks(const CrackReport &report, const std::map<std::int32_t, std::string> &names, JsonWriter &json);

/// Returns a line on each crack; empty without any.
std::string crackLines(const CrackReport &report, const std::map<std::int32_t, std::string> &names);

} // namespace forefront
