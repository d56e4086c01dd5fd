#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/domain.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// The tags of a domain by name: of its boundary parts and inner lines, or of its regions.
class NamedTags {
  public:
    static NamedTags ofParts(const Domain &domain);
    /// Faces without a marker have the tag 1.
    static NamedTags ofRegions(const Domain &domain);

    /// Returns the tags with a name or, if there are none, the one with this default name, such as boundary_2.
    std::vector<std::int32_t> all(std::string_view name) const;
    /// Returns the first of all().
    std::optional<std::int32_t> find(std::string_view name) const;
    /// Returns the error "unknown-boundary" or "unknown-region", with the names that there are. `option`: has the name.
    Diagnostics unknown(const char *option, std::string_view name) const;

  private:
    std::map<std::int32_t, std::string> names_, defaults_;
    const char *kind_ = "boundary part";
    const char *code_ = "unknown-boundary";
};

} // namespace forefront
