#pragma once

#include "core/engine/base/result.hpp"
#include "core/files/common/domain_file.hpp"
#include "core/files/source/source.hpp"

#include <string_view>

namespace forefront {

/// Reads the geometry of a problem of FEMM (.fem, .fee, .feh, .fec): nodes, segments and arcs with their boundary
/// conditions as boundary parts, nodes with a point property or without segments as points, and block labels as regions
/// named by their materials, with their maximum areas. Labels without a mesh are holes. Every bounded face without one
/// is inside; it has the material of the default label, if there is one. What lies outside is left out, as FEMM does.
/// Faults: bad-number, bad-index, bad-count, bad-value.
Result<DomainFile> readFemm(const SourceText &source);
/// Returns true if the first bytes of a file show that it is a problem of FEMM.
bool looksLikeFemm(std::string_view head);

} // namespace forefront
