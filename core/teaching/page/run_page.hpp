#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/files/text/text_writer.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace forefront {

/// The content of a page that plays a run in a browser.
struct RunPagePlan {
    static constexpr std::uint64_t kMaxAdvances = 5000; ///< about 5 MB
    static constexpr std::size_t kMaxImproveBytes = 250'000;

    std::string title;
    std::uint64_t from = 0;             ///< number of advances done when the page opens
    std::optional<std::uint64_t> steps; ///< number of advances after those; not set: to the end of the run
    std::uint64_t maxAdvances = kMaxAdvances;
    std::size_t maxImproveBytes = kMaxImproveBytes; ///< of the steps of the improvement; further ones are one step
};

/// The extent of a written page.
struct WrittenRunPage {
    std::uint64_t advances = 0; ///< that the page plays, from the first one on
    bool complete = false;      ///< it ends with the run, and shows the improved mesh
};

/// Runs a job and writes an HTML page that plays it: canvas, timeline, the ten steps with their values, candidates,
/// captions and the steps of the improvement. Elements are shown with their corners alone. The page needs no network
/// and nothing beside it. Faults: those of the job, bad-range (the run ends before the page begins), too-large (more
/// than RunPagePlan::maxAdvances), cancelled; those of the sink are its own.
Result<WrittenRunPage> writeRunPage(const MeshingJob &job, const RunPagePlan &plan, TextWriter &out,
                                    const Progress &progress);

} // namespace forefront
