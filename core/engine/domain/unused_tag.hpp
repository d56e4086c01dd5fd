#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

namespace forefront {

/// The kinds of parts that a tag can belong to.
enum class TagKind : std::uint8_t { Boundary, Region };

/// Returns the lowest tag that is not in `taken`, has no entry in `names`, and whose default name is not the name of
/// another tag.
std::int32_t unusedTag(const std::set<std::int32_t> &taken, const std::map<std::int32_t, std::string> &names,
                       TagKind kind);

} // namespace forefront
