#include "core/teaching/lesson/position_check.hpp"

#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <string>

namespace forefront {

namespace {

Diagnostic positionFault(std::string message, std::string advice) {
    Diagnostic fault;
    fault.code = "lesson-position";
    fault.message = std::move(message);
    fault.advice = std::move(advice);
    return fault;
}

} // namespace

std::optional<Diagnostic> beyondEnd(const LessonPosition &position, std::uint64_t advances, std::size_t improveSteps) {
    if (position.atEnd || position.advance <= advances + improveSteps) {
        return std::nullopt;
    }
    return positionFault("position " + std::to_string(position.advance) + " is beyond the end of the run, which has " +
                             countText(advances, "advance") + " and " + countText(improveSteps, "step") +
                             " of improvement",
                         "expected at most " + std::to_string(advances + improveSteps) + ", or \"end\"");
}

std::optional<Diagnostic> tooManyEvents(const LessonPosition &position, const SessionSnapshot &there) {
    const std::uint64_t past = there.advance - std::min(there.advance, position.advance);
    if (position.atEnd || position.events == 0 || past == 0 || (past == 1 && there.eventCursor == there.eventCount)) {
        return std::nullopt;
    }
    return positionFault(std::to_string(position.events) + " events are more than advance " +
                             std::to_string(position.advance + 1) + " has; the page begins after " +
                             countText(there.advance, "advance"),
                         "use fewer \"events\"");
}

} // namespace forefront
