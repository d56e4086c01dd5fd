#include "core/engine/mesher/classic_advancer.hpp"

#include "core/engine/mesher/instantiate.hpp"

namespace forefront {

template <class Grid, class Trace>
bool ClassicAdvancer<Grid, Trace>::advance(AdvanceDelta &delta) {
    const GenerationFront &front = state_.front;
    const SlotId slotA = state_.order.take(front);
    if (slotA == kNoSlot) {
        return false;
    }
    Base base = baseAt(front, slotA);
    delta = update_.begin(slotA);
    search_.startCounting();
    const std::size_t segments = front.segments();
    trace_.takeFirst(state_, slotA);
    trace_.begin(state_, base);
    search_.evaluateSpacing(base);

    Candidate apex;
    const FrontRules &rules = state_.rules;
    const bool secondTime = delta.markA.failureClass > 0;
    const double radius = (secondTime ? rules.secondRadius : rules.radius) * base.rho;
    const bool found = search_.find(base, {radius, true}, apex);
    if (!found && !secondTime && rules.defer) {
        update_.defer(slotA, delta);
    } else {
        if (!found) {
            search_.force(base, radius, apex);
            delta.forced = true;
        }
        update_.addElement(base, apex, delta);
    }
    FrontUpdate<Grid>::forEachNew(delta, [&](SlotId id) { state_.order.offer(front, id); });
    trace_.end(state_, delta, apex.position);
    search_.work().store(delta);
    update_.count(delta, segments, true);
    return true;
}

template <class Grid, class Trace>
void ClassicAdvancer<Grid, Trace>::retreat(const AdvanceDelta &delta) {
    update_.undo(delta);
    FrontUpdate<Grid>::forEachRestored(delta, [&](SlotId id) { state_.order.offer(state_.front, id); });
}

FOREFRONT_INSTANTIATE_FOR_GRIDS_AND_TRACES(ClassicAdvancer)

} // namespace forefront
