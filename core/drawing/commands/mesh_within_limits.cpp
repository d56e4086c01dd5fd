#include "core/drawing/commands/mesh_within_limits.hpp"

#include "core/drawing/commands/limit_fix.hpp"
#include "core/drawing/document/document.hpp"
#include "core/engine/base/note.hpp"
#include "core/engine/base/number_text.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Returns what fixes read and change, as a document without shapes.
Document settingsOf(const MeshingJob &job) {
    Document document;
    document.spacing = job.spacing;
    document.options = job.options;
    document.layers = job.layers;
    return document;
}

/// Applies the fix of each violated limit, one after the other. Returns what they change; empty: nothing helps.
std::string applyFixes(const std::vector<LimitVerdict> &verdicts, const SpacingField *spacing, Document &document) {
    std::string changes;
    for (const LimitVerdict &verdict : verdicts) {
        if (std::optional<LimitFix> fix = fixOf(document, verdict, spacing)) {
            changes += (changes.empty() ? "" : ", ") + fix->change;
            document = std::move(fix->document);
        }
    }
    return changes;
}

const char *adviceOn(MeshLimit limit, bool layered) {
    const bool aspect = limit == MeshLimit::MaxAspect || limit == MeshLimit::MaxLayerAspect;
    return limit == MeshLimit::MinIslandArea ? "islands belong to the outline: remove the small ones from the drawing"
           : layered && aspect ? "the heights of boundary layers are given: make the first one higher, or limit their "
                                 "aspect ratio apart "
                                 "from that of the other elements"
                               : "change the outline there, or the limit; a check of the mesh lists the places";
}

/// Notes the limits that are still violated and why nothing more is done about them.
void noteWhatIsLeft(const std::vector<LimitVerdict> &verdicts, bool layered, Diagnostics &remarks) {
    for (const LimitVerdict &verdict : verdicts) {
        if (!verdict.met() && verdict.broken > 0) {
            remarks.push_back(noteOf("not-fixed",
                                     std::string("no setting mends ") + limitInfo(verdict.limit).name + ' ' +
                                         valueText(verdict.limit, verdict.bound) + " at " +
                                         countText(verdict.broken, "place"),
                                     adviceOn(verdict.limit, layered)));
        }
    }
}

} // namespace

Result<FixedMesh> meshWithinLimits(MeshingJob job, const MeshLimits &limits, const Progress &progress) {
    Result<MeshingOutcome> first = meshDomain(job, progress);
    if (!first) {
        return first.faults();
    }
    FixedMesh best{std::move(job), std::move(*first), {}};
    const auto judge = [&](const MeshingOutcome &outcome) {
        return checkLimits(outcome.mesh, limits, outcome.spacing.get(), 1);
    };
    std::vector<LimitVerdict> verdicts = judge(best.outcome), left = verdicts;
    std::shared_ptr<const SpacingField> spacing = best.outcome.spacing;
    Document document = settingsOf(best.job);
    constexpr int kPatience = 3; // rounds without fewer violations
    for (int round = 0, idle = 0; round < kMaxFixRounds && idle < kPatience && violations(left) > 0; ++round) {
        const std::string changes = applyFixes(verdicts, spacing.get(), document);
        if (changes.empty()) {
            break;
        }
        MeshingJob next = best.job;
        next.spacing = document.spacing;
        next.options = document.options;
        next.shared = nullptr; // the field of other sizes
        Result<MeshingOutcome> outcome = meshDomain(next, progress);
        if (!outcome) {
            if (hasCode(outcome.faults(), "cancelled")) {
                return outcome.faults();
            }
            best.remarks.push_back(
                noteOf("not-fixed", "the fix stops before " + changes + ": " + outcome.faults().front().message));
            break;
        }
        verdicts = judge(*outcome);
        spacing = outcome->spacing;
        const std::size_t before = violations(left), after = violations(verdicts);
        const bool better = whyNoBetter(left, verdicts).empty();
        best.remarks.push_back(noteOf(
            "fixed", "fix: " + changes + ": " + std::to_string(before) + " violations, then " + std::to_string(after) +
                         ", " + std::to_string(best.outcome.mesh.elementCount()) + " elements, then " +
                         std::to_string(outcome->mesh.elementCount()) + (better ? "" : "; not kept")));
        idle = better ? 0 : idle + 1;
        if (better) {
            best.job = std::move(next);
            best.outcome = std::move(*outcome);
            left = verdicts;
        }
    }
    noteWhatIsLeft(left, !best.job.layers.empty(), best.remarks);
    return best;
}

} // namespace forefront
