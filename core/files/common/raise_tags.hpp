#pragma once

#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/unused_tag.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/files/source/source.hpp"

#include <cstdint>
#include <map>
#include <string>

namespace forefront {

/// Gives each distinct tag below 1, as other programs write them, a free tag and a name that shows the one in the file,
/// such as "boundary_-2" or "region_0"; one note lists them. Names of tags below 1 move to the new tags. Where the
/// boundary or the regions have no tag but 0, which then means none, all become 1. Call after reading, with the names.
void raiseTags(Mesh &mesh, const SourceText &source);
/// Does the same for the segments, points and region markers of a domain.
void raiseTags(Domain &domain, const SourceText &source);

/// Turns attributes, which may be any numbers, into tags: whole numbers from 0 are their own tags; each distinct other
/// number gets one below 0, named after it, for raiseTags().
class AttributeTags {
  public:
    /// `names`: receives the names of the tags below 0.
    AttributeTags(std::map<std::int32_t, std::string> &names, TagKind kind) : names_(names), kind_(kind) {}
    std::int32_t of(double attribute);

  private:
    std::map<std::int32_t, std::string> &names_;
    TagKind kind_;
    std::map<double, std::int32_t> others_; ///< tags below 0 by attribute
};

} // namespace forefront
