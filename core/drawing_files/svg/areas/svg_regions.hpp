#pragma once

#include "core/engine/domain/domain.hpp"
#include "core/files/common/tag_allocator.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>

namespace forefront {

/// The regions of a drawing in which every filled shape is one.
class SvgRegions {
  public:
    /// Tells the name of a path, so that no shape without a name gets it.
    void reserve(const std::string &name) { reserved_.insert(name); }
    /// Returns the tag of a shape: shapes with the same name share it, and each without a name has its own.
    std::int32_t tagOf(const std::string &name);
    /// Returns the names of the regions that a domain has, by tag.
    std::map<std::int32_t, std::string> namesIn(const Domain &domain) const;

  private:
    std::set<std::string> reserved_;
    TagAllocator tags_;
    std::size_t unnamed_ = 0; ///< number of shapes without a name
};

} // namespace forefront
