#include "core/teaching/lesson/seed_check.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/teaching/lesson/lesson_check.hpp"
#include "core/teaching/lesson/random_numbers.hpp"

#include <string>

namespace forefront {

SeedCheck checkSeeds(const LessonFile &lesson, const LessonNames &names, LessonRuns &runs, const Progress &progress) {
    const SeedsToCheck chosen = seedsToCheck(lesson.lesson.random);
    SeedCheck outcome{{}, 0, chosen.all};
    for (const std::uint64_t seed : chosen.seeds) {
        progress("checking the random numbers",
                 static_cast<double>(outcome.seeds) / static_cast<double>(chosen.seeds.size()));
        const Result<Lesson> drawn = lesson.withSeed(seed, names);
        Diagnostics faults = drawn ? checkLesson(*drawn, lesson.source(), runs, {{}, progress.stop}) : drawn.faults();
        if (progress.cancelled()) {
            outcome.faults = cancelled("the check");
            return outcome;
        }
        ++outcome.seeds;
        for (Diagnostic &fault : faults) {
            fault.message += " (with the random numbers of --seed " + std::to_string(seed) + ')';
        }
        if (hasErrors(faults)) {
            outcome.faults = std::move(faults);
            return outcome;
        }
        if (outcome.faults.empty()) {
            outcome.faults = std::move(faults);
        }
    }
    return outcome;
}

} // namespace forefront
