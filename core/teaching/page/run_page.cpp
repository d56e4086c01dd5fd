#include "core/teaching/page/run_page.hpp"

#include "core/engine/mesh/quality.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "core/files/json/json.hpp"
#include "core/teaching/page/player.hpp"
#include "core/teaching/page/run_record.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// The steps of a run, as far as a page plays them.
struct SteppedAdvances {
    Mesh start;                          ///< before the first advance
    std::vector<FrontSegmentView> front; ///< before the first advance
    std::vector<std::shared_ptr<const AdvanceExplanation>> advances;
    Mesh mesh;             ///< after the last one, not improved
    bool complete = false; ///< they end with the run
};

Result<SteppedAdvances> stepThrough(MeshingJob job, const RunPagePlan &plan, const Progress &progress) {
    job.options.improve = ImproveLevel::None;
    job.options.order = ElementOrder::First;
    Result<MeshStepper> stepper = MeshStepper::create(std::move(job), progress);
    if (!stepper) {
        return stepper.faults();
    }
    SteppedAdvances steps{stepper->mesh(), stepper->front(), {}, {}, false};
    while (!plan.steps || steps.advances.size() < plan.from + *plan.steps) {
        if (progress.cancelled()) {
            return error("cancelled", "the page was cancelled");
        }
        if (stepper->advance() == 0) {
            break;
        }
        if (steps.advances.size() == RunPagePlan::kMaxAdvances) {
            return error("too-large",
                         "the run has more than " + std::to_string(RunPagePlan::kMaxAdvances) +
                             " advances, too many for a page",
                         "choose a larger size, or limit the page with --steps");
        }
        steps.advances.push_back(stepper->explanation());
    }
    if (plan.from > steps.advances.size()) {
        return error("bad-range", "the page begins after advance " + std::to_string(plan.from) +
                                      ", but the run has only " + std::to_string(steps.advances.size()) + " advances");
    }
    steps.complete = stepper->atEnd();
    steps.mesh = stepper->mesh();
    return steps;
}

/// Returns text that cannot end the script element that it is in.
std::string inScript(std::string text) {
    for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 3)) {
        text.insert(at + 1, "\\");
    }
    return text;
}

/// Returns the line below the title: "Classic method, hierarchical grid".
std::string aboutText(const MeshingOptions &options) {
    std::string text = options.method == Method::Classic ? "Classic method, " : "Fast method, ";
    return text + (options.grid == GridKind::None ? "no" : std::string(wordOf(options.grid))) + " grid";
}

/// Writes the values that the player shows of a finished mesh.
void writeShape(TextWriter &out, const MeshView &mesh) {
    const MeshQuality quality = measureQuality(mesh, nullptr);
    out << "\"mean\":" << quality.alphaMean << ",\"least\":" << quality.alphaMin;
}

void writeRun(TextWriter &out, const SteppedAdvances &steps, const Mesh *improved, const MeshingOptions &options,
              const RunPagePlan &plan) {
    RunRecord record(out);
    WordList words;
    out << "{\"title\":" << inScript(jsonString(plan.title)) << ",\"about\":" << jsonString(aboutText(options))
        << ",\"from\":" << plan.from << ",\"boundaryNodes\":" << steps.start.nodes.size() << ",\n\"nodes\":";
    record.nodes(steps.mesh.nodes);
    out << ",\n\"edges\":";
    record.edges(steps.start);
    out << ",\n\"front\":[";
    for (const FrontSegmentView &segment : steps.front) {
        out << (&segment == steps.front.data() ? "" : ",") << index(segment.nodeA) << ',' << index(segment.nodeB);
    }
    out << "],\n\"advances\":[";
    for (const auto &advance : steps.advances) {
        out << (&advance == steps.advances.data() ? "\n" : ",\n");
        record.advance(*advance, steps.mesh, words);
    }
    out << "],\n\"words\":[";
    for (const std::string &word : words.words()) {
        out << (&word == words.words().data() ? "" : ",\n") << inScript(jsonString(word));
    }
    out << "],\n\"raw\":{";
    writeShape(out, steps.mesh);
    out << "},\n\"improved\":";
    if (improved == nullptr) {
        out << "null}";
        return;
    }
    out << '{';
    writeShape(out, *improved);
    out << ",\"nodes\":";
    record.nodes(improved->nodes);
    out << ",\"edges\":";
    record.edges(*improved);
    out << ",\"elements\":";
    record.triangles(*improved);
    out << "}}";
}

/// Returns text as the content of an HTML element.
std::string inHtml(const std::string &text) {
    std::string html;
    for (const char c : text) {
        html += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    }
    return html;
}

} // namespace

Result<WrittenRunPage> writeRunPage(const MeshingJob &job, const RunPagePlan &plan, TextWriter &out,
                                    const Progress &progress) {
    Result<SteppedAdvances> steps = stepThrough(job, plan, progress);
    if (!steps) {
        return steps.faults();
    }
    Mesh improved;
    const bool improves = steps->complete && job.options.improve != ImproveLevel::None;
    if (improves) {
        MeshingJob shown = job;
        shown.options.order = ElementOrder::First; // as the front made them
        Result<MeshingOutcome> outcome = meshDomain(shown, progress);
        if (!outcome) {
            return outcome.faults();
        }
        improved = std::move(outcome->mesh);
    }
    out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<meta name=\"generator\" content=\"Forefront\">\n<title>"
        << inHtml(plan.title) << "</title>\n<style>\n"
        << playerStyle() << "</style>\n</head>\n<body>\n"
        << playerBody() << "<script type=\"application/json\" id=\"run\">\n";
    writeRun(out, *steps, improves ? &improved : nullptr, job.options, plan);
    out << "\n</script>\n<script>\n" << playerScript() << "</script>\n</body>\n</html>\n";
    return WrittenRunPage{steps->advances.size(), steps->complete};
}

} // namespace forefront
