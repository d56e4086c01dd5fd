#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/periodic.hpp"
#include "core/engine/domain/segment_elements.hpp"
#include "core/engine/layers/layer_spec.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

struct Domain;
struct DomainFaces;

/// An inner line with a width: a strip that is filled by rows of elements along the line, half of the width on either
/// side. The strip is a region of its own; its sides, and its ends inside the domain, have the tag of the line.
struct StripSpec {
    std::int32_t tag = 1;   ///< of the line
    double width = 0.0;     ///< domain units, > 0
    std::uint32_t rows = 1; ///< number of elements across, 1 to kMaxStripRows
    LayerCells cells = LayerCells::Quads;
    std::int32_t region = 0; ///< tag of the strip's region; 0: the lowest unused one, with the name of the line

    friend bool operator==(const StripSpec &, const StripSpec &) = default;
};

/// Maximum number of rows of a strip.
inline constexpr std::uint32_t kMaxStripRows = 1000;

/// Returns the fault of the numbers of a specification; nothing if they are valid. `owner`: the line, in messages.
std::optional<Diagnostic> stripFault(const StripSpec &spec, std::string_view owner);

/// Returns the faults of strips along lines of a valid domain: invalid numbers ("bad-strip"), a tag that no segment has
/// ("unknown-boundary"), two specifications of one line ("repeated-strip"), a line with the domain on one side alone
/// ("strip-outside"), one that is a crack, or is on a periodic part or ends there ("strip-line"). `cracks`: tags.
Diagnostics checkStrips(std::span<const StripSpec> specs, const Domain &domain, const DomainFaces &faces,
                        std::span<const std::int32_t> cracks, std::span<const PeriodicSpec> periodic);

/// Replaces a domain, and its numbers of elements, by the one that a job with strips meshes; without strips, they stay.
/// `cracks`, `periodic`: of the job. Errors: those of validate(), checkStrips() and widenedDomain().
Status widenStrips(std::span<const StripSpec> specs, std::span<const std::int32_t> cracks,
                   std::span<const PeriodicSpec> periodic, Domain &domain, std::vector<std::uint32_t> &elements,
                   std::vector<ElementBias> &biases);

} // namespace forefront
