#include "app/batch/fix_option.hpp"

#include "app/batch/cli_options.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/option_notes.hpp"
#include "core/drawing/commands/limit_fix.hpp"
#include "core/drawing/document/document.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/base/number_text.hpp"

#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Reads NAME=VALUE; returns what is wrong, empty if nothing is.
std::string readLimit(const std::string &text, MeshLimits &limits) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::optional<MeshLimit> limit = fromWord<MeshLimit>(text.substr(0, equals));
    if (!limit) {
        return "unknown limit '" + text.substr(0, equals) + "'; expected " + wordList<MeshLimit>();
    }
    const std::optional<double> value = numberIn(std::string_view(text).substr(std::min(equals + 1, text.size())));
    if (!value) {
        return "expected NAME=VALUE, such as max-growth=2, got '" + text + '\'';
    }
    if (const std::string fault = limitFault(*limit, *value); !fault.empty()) {
        return std::string(wordOf(*limit)) + ": " + fault;
    }
    limits[*limit] = *value;
    return {};
}

std::size_t violations(const std::vector<LimitVerdict> &verdicts) {
    return std::accumulate(verdicts.begin(), verdicts.end(), std::size_t{0},
                           [](std::size_t sum, const LimitVerdict &verdict) { return sum + verdict.broken; });
}

/// The part of a document that fixes change.
Document settingsOf(const MeshingJob &job) {
    Document document;
    document.spacing = job.spacing;
    document.options = job.options;
    return document;
}

/// Applies the fix of each violated limit, one after the other. Returns what they change; empty: nothing helps.
std::string applyFixes(const std::vector<LimitVerdict> &verdicts, Document &document) {
    std::string changes;
    for (const LimitVerdict &verdict : verdicts) {
        if (std::optional<LimitFix> fix = fixOf(document, verdict)) {
            changes += (changes.empty() ? "" : ", ") + fix->change;
            document = std::move(fix->document);
        }
    }
    return changes;
}

/// Notes the limits that are still violated and why nothing more is done about them.
void noteWhatIsLeft(const std::vector<LimitVerdict> &verdicts, Diagnostics &remarks) {
    for (const LimitVerdict &verdict : verdicts) {
        if (!verdict.met() && verdict.broken > 0) {
            const bool islands = verdict.limit == MeshLimit::MinIslandArea;
            remarks.push_back(
                noteOf("not-fixed",
                       std::string("--fix cannot mend ") + limitInfo(verdict.limit).name + ' ' +
                           valueText(verdict.limit, verdict.bound) + " at " + countText(verdict.broken, "place"),
                       islands ? "islands belong to the outline: remove the small ones from the drawing"
                               : "change the outline there, or the limit; forefront check lists the places")
                    .front());
        }
    }
}

} // namespace

void addFixOptions(CLI::App &app, MeshLimits &limits, bool &fix) {
    app.add_option_function<std::vector<std::string>>(
           "--limit",
           [&limits](const std::vector<std::string> &texts) {
               for (const std::string &text : texts) {
                   if (const std::string wrong = readLimit(text, limits); !wrong.empty()) {
                       throw CLI::ValidationError("--limit", wrong);
                   }
               }
           },
           "a limit that the mesh should meet, such as max-growth=2, besides those of a project; a warning tells where "
           "it does not; limits: " +
               wordList<MeshLimit>() + "; can be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME=VALUE");
    app.add_flag(
        "--fix", fix,
        "change the settings until the mesh meets its limits: the gradation for growth, elements across narrow "
        "places, bounds of the size for lengths, the least angle, else the best improvement; each change is "
        "reported, and what none can mend");
}

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
    Document document = settingsOf(best.job);
    constexpr int kPatience = 3; // rounds without fewer violations
    for (int round = 0, idle = 0; round < kMaxFixRounds && idle < kPatience && violations(left) > 0; ++round) {
        const std::string changes = applyFixes(verdicts, document);
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
                noteOf("not-fixed", "--fix stops before " + changes + ": " + outcome.faults().front().message).front());
            break;
        }
        verdicts = judge(*outcome);
        const std::size_t before = violations(left), after = violations(verdicts);
        best.remarks.push_back(noteOf("fixed", "--fix: " + changes + ": " + std::to_string(before) +
                                                   " violations, then " + std::to_string(after) + ", " +
                                                   std::to_string(best.outcome.mesh.elementCount()) +
                                                   " elements, then " + std::to_string(outcome->mesh.elementCount()) +
                                                   (after < before ? "" : "; not kept"))
                                   .front());
        idle = after < before ? 0 : idle + 1;
        if (after < before) {
            best.job = std::move(next);
            best.outcome = std::move(*outcome);
            left = verdicts;
        }
    }
    noteWhatIsLeft(left, best.remarks);
    return best;
}

} // namespace forefront
