#include "app/batch/check_report.hpp"

#include "app/batch/cli_options.hpp"
#include "app/batch/exit_code.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/base/note.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/files/files.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace forefront {

namespace {

std::string optionHelp(const LimitInfo &info) {
    std::string text = info.meaning;
    text.front() = static_cast<char>(text.front() - 'A' + 'a');
    return text;
}

/// Pads a text, which may contain multi-byte characters, to a number of columns.
std::string padded(std::string text, std::size_t columns) {
    const auto width = static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
    return text.append(columns - std::min(columns, width), ' ');
}

} // namespace

void addLimitOptions(CLI::App &group, MeshLimits &limits) {
    for (const MeshLimit limit : valuesOf<MeshLimit>()) {
        const LimitInfo &info = limitInfo(limit);
        const bool unbounded = !std::isfinite(info.maximum);
        group.add_option("--" + std::string(wordOf(limit)), limits[limit], optionHelp(info))
            ->check(unbounded ? positiveNumber() : numberWithin(info.minimum, info.maximum))
            ->type_name("LIMIT");
    }
}

Diagnostics addSavedLimits(const std::filesystem::path &project, const std::map<std::string, std::string> &parameters,
                           MeshLimits &limits) {
    const Result<Document> document = readDocument(project, {.parameters = parameters});
    if (!document) {
        return document.faults();
    }
    for (const MeshLimit limit : valuesOf<MeshLimit>()) {
        limits[limit] = limits[limit] ? limits[limit] : document->limits[limit];
    }
    if (!limits.any()) {
        Diagnostics faults = error("no-limits", "the file holds no limits", "set them in the Checks panel and save");
        faults.front().file = project.string();
        return faults;
    }
    return {};
}

void printMeasures(const MeshView &mesh, const SpacingField *spacing) {
    std::printf("%s%10s", padded("measure", 22).c_str(), "minimum");
    for (const int percent : kPercentiles) {
        std::printf("%9d%%", percent);
    }
    std::printf("%10s%10s\n", "maximum", "mean");
    const MeshEdges edges = edgesOf(mesh);
    for (const Measure measure : valuesOf<Measure>()) {
        if (measure == Measure::Region || measure == Measure::Birth) {
            continue; // their figures mean nothing
        }
        const MeasureSummary summary = summarise(measureValues(measure, mesh, edges, spacing));
        if (summary.count == 0) {
            continue;
        }
        std::printf("%s%10.4g", padded(infoOf(measure).name, 22).c_str(), summary.minimum);
        for (const double value : summary.percentiles) {
            std::printf("%10.4g", value);
        }
        std::printf("%10.4g%10.4g\n", summary.maximum, summary.mean);
    }
}

namespace {

/// Returns a note that the command mesh can change settings until a mesh meets more of the limits, with the options
/// that do; empty if none is violated that a setting could mend.
Diagnostics fixAdvice(const std::vector<LimitVerdict> &verdicts) {
    std::string options;
    bool violated = false;
    for (const LimitVerdict &verdict : verdicts) {
        if (verdict.limit != MeshLimit::MinIslandArea) { // islands belong to the outline
            options += "--limit " + std::string(wordOf(verdict.limit)) + '=' + exactText(verdict.bound) + ' ';
            violated = violated || verdict.broken > 0;
        }
    }
    return violated ? Diagnostics{noteOf("limits", "the command mesh looks for settings that meet these limits",
                                         "add to it: " + options + "--fix")}
                    : Diagnostics();
}

} // namespace

bool printVerdicts(const std::filesystem::path &file, const std::vector<LimitVerdict> &verdicts,
                   const MeshNumbers &numbers, bool prints) {
    bool met = true;
    for (const LimitVerdict &verdict : verdicts) {
        if (prints) {
            std::printf("%s\n", toString(verdict).c_str());
        }
        met = met && verdict.met();
        Diagnostics faults = faultsOf(verdict, numbers);
        for (Diagnostic &fault : faults) {
            fault.file = file.string();
        }
        printFaults(faults);
    }
    printFaults(fixAdvice(verdicts));
    return met;
}

} // namespace forefront
