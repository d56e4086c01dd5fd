#include "ui/workspace/view/chosen_candidate.hpp"

#include "core/teaching/moment/moment.hpp"

namespace forefront {

std::optional<std::size_t> chosenCandidate(const View &view, const SessionSnapshot &snapshot) {
    const Moment moment = momentOf(snapshot);
    const auto &choice = view.candidate;
    const bool valid = choice && moment && choice->run == snapshot.shownRun &&
                       choice->advance == moment.advance->advance && choice->candidate < moment.candidates;
    return valid ? std::optional(choice->candidate) : std::nullopt;
}

} // namespace forefront
