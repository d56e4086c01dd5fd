#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <condition_variable>
#include <mutex>
#include <optional>

namespace FOREFRONT_API forefront {

/// The field of one specification and one domain, for several threads that need the same field: the first one builds
/// it, the others wait for it.
class SharedSpacing {
  public:
    /// Returns the field, or the faults found in building it, see SpacingField::build(). All calls must pass the same
    /// arguments. A thread that is cancelled returns "cancelled" and leaves building to the others.
    Result<std::shared_ptr<const SpacingField>> get(const SpacingSpec &spec, const Domain &domain,
                                                    const Progress &progress = {},
                                                    GivenSegments segments = GivenSegments::Divided);

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool building_ = false;
    std::optional<Result<std::shared_ptr<const SpacingField>>> built_;
};

} // namespace forefront
