#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/domain.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace forefront {

/// The regions of a domain by name. Faces without a marker belong to the region 1.
class RegionNames {
  public:
    explicit RegionNames(const Domain &domain);

    /// Returns the tag of a region: by its name or, if none has it, by its default name such as region_2.
    std::optional<std::int32_t> find(std::string_view name) const;
    /// Returns the error "unknown-region", with the list of regions. `option`: that has the name.
    Diagnostics unknown(const char *option, const std::string &name) const;

  private:
    std::map<std::int32_t, std::string> regions_;
};

} // namespace forefront
