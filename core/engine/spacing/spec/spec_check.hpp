#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>

namespace forefront {

// Each check appends the faults of the given numbers to a list.

/// Checks that a size is absent or a finite number above 0. Fault: bad-size.
void checkSize(const std::optional<double> &value, const std::string &name, Diagnostics &faults,
               const char *advice = "enter a length in domain units");

/// Returns the fault of a size or its growth, if there is one. `owner`: the part that has the size, such as "node 3 of
/// quay".
std::optional<Diagnostic> partSizeFault(const PartSize &part, const std::string &owner, const char *code);

/// Checks a size source. Faults: bad-source, with the index in `ids` and the place if it is finite.
void checkSource(const SizeSource &source, std::uint32_t index, Diagnostics &faults);
void checkSources(std::span<const SizeSource> sources, Diagnostics &faults);

/// Checks the sizes of boundary parts. Fault: bad-source.
void checkPartSizes(const std::map<std::int32_t, PartSize> &sizes, Diagnostics &faults);

/// Checks the sizes along segments. Fault: bad-source, for the first invalid one.
void checkSegmentSizes(std::span<const PartSize> sizes, Diagnostics &faults);
/// Checks the biases of elements along segments. Code: bad-element-counts.
void checkBiases(std::span<const ElementBias> biases, Diagnostics &faults);
/// Returns the fault of an invalid bias of the elements of `owner`.
Diagnostic biasFault(const ElementBias &bias, const std::string &owner, std::string code);

/// Checks the sizes of nodes. Faults: bad-source, with the place if it is finite.
void checkNodeSizes(std::span<const NodeSize> sizes, Diagnostics &faults);

/// Checks the sizes and maximum areas of regions. Faults: bad-source, bad-region-area, with the index in `ids` and the
/// place if it is finite.
void checkRegions(std::span<const RegionSize> regions, Diagnostics &faults);

/// Checks that the number of elements per turn is absent, or finite and >= 0. Fault: bad-size.
void checkSegmentsPerTurn(const std::optional<double> &value, Diagnostics &faults);

/// Checks that the number of elements across narrow places is absent, or finite and >= 0. Fault: bad-size.
void checkElementsAcross(const std::optional<double> &value, Diagnostics &faults);

/// Checks minimum, maximum and gradation. Faults: bad-size.
void checkLimits(const SpacingSpec &spec, Diagnostics &faults);

} // namespace forefront
