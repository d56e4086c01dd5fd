#pragma once

#include <string_view>

namespace forefront {

/// Returns true for no name and for those that drawing programs make up, such as "path3948", "Rectangle 5" or
/// "XMLID_4_".
bool isGeneratedName(std::string_view name);

} // namespace forefront
