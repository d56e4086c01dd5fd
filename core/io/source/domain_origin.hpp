#pragma once

#include "core/base/api.hpp"
#include "core/base/diagnostic.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

/// Where a part of a domain stands in its file.
struct PartOrigin {
    static constexpr auto kNowhere = static_cast<std::size_t>(-1);
    std::size_t offset = kNowhere;           ///< byte of the text; kNowhere: in another file, or unknown
    std::optional<std::int64_t> number = {}; ///< as the file numbers it
};

/// Where the parts of a domain stand in its file: for each kind a list in the order of the domain's. Readers fill it
/// where SourceText::origin asks for it; those of formats without such places leave it empty.
struct DomainOrigin {
    bool showsColumns = false; ///< many parts may stand on one line
    std::array<std::vector<PartOrigin>, 5> parts;

    std::vector<PartOrigin> &of(DomainPartKind kind) { return parts[static_cast<std::size_t>(kind)]; }
    const std::vector<PartOrigin> &of(DomainPartKind kind) const { return parts[static_cast<std::size_t>(kind)]; }
};

/// Fills in number, line and column of the parts, and of each fault the first line and column that are known. Faults
/// that name a file are left alone.
void addPlaces(Diagnostics &faults, const DomainOrigin &origin, std::string_view text);

} // namespace forefront
