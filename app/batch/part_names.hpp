#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/domain.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace forefront {

/// The boundary parts and inner lines of a domain by name.
class PartNames {
  public:
    explicit PartNames(const Domain &domain);

    /// Returns the tag of a part: by its name or, if none has it, by its default name such as boundary_2.
    std::optional<std::int32_t> find(const std::string &name) const;
    /// Returns the error "unknown-boundary", with the list of parts. `option`: that has the name.
    Diagnostics unknown(const char *option, const std::string &name) const;

  private:
    std::map<std::int32_t, std::string> parts_;
};

} // namespace forefront
