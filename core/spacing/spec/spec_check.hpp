#pragma once

#include "core/base/diagnostic.hpp"
#include "core/domain/domain.hpp"
#include "core/spacing/spec/spacing_spec.hpp"

#include <optional>
#include <span>
#include <string>

namespace forefront {

// Each check appends what is wrong with the numbers it is given.

/// Faults: bad-size unless the value is absent or a finite number above 0.
void checkSize(const std::optional<double> &value, const std::string &name, Diagnostics &faults);

/// Faults: bad-source, with the index in `ids` and the place where it is finite.
void checkSource(const SizeSource &source, std::uint32_t index, Diagnostics &faults);
void checkSources(std::span<const SizeSource> sources, Diagnostics &faults);

/// Faults: bad-region-area, with the marker as part.
void checkRegionAreas(std::span<const RegionMarker> markers, Diagnostics &faults);

/// Faults: bad-size unless the number is absent, or finite and >= 0.
void checkSegmentsPerTurn(const std::optional<double> &value, Diagnostics &faults);

/// Checks minimum, maximum and gradation. Faults: bad-size.
void checkLimits(const SpacingSpec &spec, Diagnostics &faults);

} // namespace forefront
