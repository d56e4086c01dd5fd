#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

/// The place of a part of a domain in its file.
struct PartOrigin {
    static constexpr auto kNowhere = static_cast<std::size_t>(-1);
    std::size_t offset = kNowhere;           ///< byte of the text; kNowhere: in another file, or unknown
    std::optional<std::int64_t> number = {}; ///< its number in the file
};

/// The places of the parts of a domain in its file: a list for each kind, in the order of the domain. Readers fill it
/// where SourceText::origin asks for it; those of formats without such places leave it empty.
struct DomainOrigin {
    bool showsColumns = false; ///< several parts may be on one line
    std::array<std::vector<PartOrigin>, 5> parts;
    std::size_t spacingExpression = PartOrigin::kNowhere; ///< byte of the expression of the spacing

    std::vector<PartOrigin> &of(DomainPartKind kind) { return parts[static_cast<std::size_t>(kind)]; }
    const std::vector<PartOrigin> &of(DomainPartKind kind) const { return parts[static_cast<std::size_t>(kind)]; }
};

/// Fills in number, line and column of the parts, and of each fault the first line and column that are known; faults of
/// the spacing expression get its place. Faults that name a file are left alone.
void addPlaces(Diagnostics &faults, const DomainOrigin &origin, std::string_view text);

} // namespace forefront
