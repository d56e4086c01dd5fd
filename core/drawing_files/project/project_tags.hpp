#pragma once

#include "core/files/json/json_check.hpp"
#include "core/files/json/json_text.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace forefront {

/// Writes a list of tags as a member of a project; nothing if it is empty.
void writeTags(std::string_view member, const std::vector<std::int32_t> &tags, JsonText &out);

/// Reads such a member into a list; an absent one adds nothing. Faults: bad-tag, also for a tag that occurs twice:
/// "tag 3 `twice`", such as "is open twice".
void readTags(const JsonValue &root, std::string_view member, std::string_view twice, std::vector<std::int32_t> &tags,
              JsonCheck &check);

} // namespace forefront
