#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/progress.hpp"
#include "core/teaching/lesson/lesson_file.hpp"
#include "core/teaching/lesson/lesson_run.hpp"

#include <cstddef>

namespace forefront {

/// The outcome of checking a lesson with several seeds.
struct SeedCheck {
    Diagnostics faults;      ///< of the first seed with errors; else of the first with warnings
    std::size_t seeds = 0;   ///< that were checked
    bool everyNumber = true; ///< they draw all numbers of all ranges, not only samples of large ones
};

/// Checks a lesson with random numbers, as checkLesson() does, with the seeds that seedsToCheck() chooses. `names`: as
/// for readLessonFile(); `runs`: keep all runs, so that each drawing is run once. Faults name their seed; "cancelled"
/// alone if it was.
SeedCheck checkSeeds(const LessonFile &lesson, const LessonNames &names, LessonRuns &runs, const Progress &progress);

} // namespace forefront
