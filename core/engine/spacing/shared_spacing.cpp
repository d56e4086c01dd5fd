#include "core/engine/spacing/shared_spacing.hpp"

#include "core/engine/base/cancelled.hpp"

#include <chrono>

namespace forefront {

Result<std::shared_ptr<const SpacingField>> SharedSpacing::get(const SpacingSpec &spec, const Domain &domain,
                                                               const Progress &progress, GivenSegments segments) {
    constexpr auto kUntilCancelled = std::chrono::milliseconds(10);
    std::unique_lock lock(mutex_);
    while (building_ && !progress.cancelled()) {
        changed_.wait_for(lock, kUntilCancelled);
    }
    if (progress.cancelled()) {
        return cancelled("building the node spacing");
    }
    if (built_) {
        return *built_;
    }
    /// Lets the others go on, also if memory runs out.
    struct Building {
        SharedSpacing &of;
        std::unique_lock<std::mutex> &lock;
        ~Building() {
            if (!lock.owns_lock()) {
                lock.lock();
            }
            of.building_ = false;
            of.changed_.notify_all();
        }
    } const building{*this, lock};
    building_ = true;
    lock.unlock();
    Result<std::shared_ptr<const SpacingField>> field = SpacingField::build(spec, domain, progress, segments);
    lock.lock();
    if (field || !progress.cancelled()) {
        built_ = field;
    }
    return field;
}

} // namespace forefront
