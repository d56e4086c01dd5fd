#include "core/teaching/page/recorded_run.hpp"

#include "core/engine/mesh/quality.hpp"
#include "core/files/json/json.hpp"
#include "core/teaching/moment/short_texts.hpp"
#include "core/teaching/page/run_record.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

namespace {

/// Returns the line below the title: "Classic method, hierarchical grid".
std::string aboutText(const MeshingOptions &options) {
    std::string text = makesQuads(options)                 ? "Front of quadrilaterals, "
                       : options.method == Method::Classic ? "Classic method, "
                                                           : "Fast method, ";
    return text + (options.grid == GridKind::None ? "no" : std::string(wordOf(options.grid))) + " grid";
}

/// Writes the values that the player shows of a finished mesh. `figures`: of a mesh of quadrilaterals, else null.
void writeShape(TextWriter &out, const MeshView &mesh, const QuadFigures *figures) {
    if (figures != nullptr) {
        out << "\"mean\":" << figures->jacobianMean << ",\"least\":" << figures->jacobianMin
            << ",\"irregular\":" << figures->irregular;
        return;
    }
    const MeshQuality quality = measureQuality(mesh, nullptr);
    out << "\"mean\":" << quality.alphaMean << ",\"least\":" << quality.alphaMin;
}

/// Writes the lines of the ten steps and the words of the verdicts, as the editor has them.
void writeTexts(TextWriter &out, const RecordedRun &run) {
    const FrontRules *const rules = run.options.method == Method::Classic ? &run.options.rules : nullptr;
    out << ",\n\"lines\":[";
    for (int step = 1; step <= kStepCount; ++step) {
        const Step each = static_cast<Step>(step);
        out << (step == 1 ? "" : ",") << scriptString(run.isColoured() ? squareStepLine(each) : stepLine(each, rules));
    }
    out << "],\n\"verdicts\":[";
    for (const Verdict verdict : valuesOf<Verdict>()) {
        out << (verdict == Verdict::NotTried ? "" : ",") << scriptString(shortVerdict(verdict));
    }
    out << ']';
}

/// Writes the colours of the nodes of a two-coloured front as a string of 0 and 1.
void writeColours(TextWriter &out, const std::vector<std::uint8_t> &colours) {
    out << ",\n\"colours\":\"";
    for (const std::uint8_t colour : colours) {
        out << (colour == 0 ? '0' : '1');
    }
    out << '"';
}

bool hasQuadrilaterals(const MeshView &mesh) {
    return std::ranges::any_of(mesh.blocks(), [](const MeshView::Block &block) { return block.traits().corners == 4; });
}

} // namespace

Result<RecordedRun> recordRun(const MeshingJob &job, const RunPagePlan &plan, const Progress &progress) {
    MeshingJob shown = job;
    shown.options.order = ElementOrder::First; // the page shows corners only
    Result<MeshStepper> stepper = MeshStepper::create(std::move(shown), progress);
    if (!stepper) {
        return stepper.faults();
    }
    stepper->stepImprovement();
    return recordRun(*stepper, job.options, plan, progress);
}

Result<RecordedRun> recordRun(MeshStepper &stepper, const MeshingOptions &options, const RunPagePlan &plan,
                              const Progress &progress) {
    stepper.seek(0);
    RecordedRun run{options, stepper.mesh(), stepper.front(), {}, {}, {}, false, {}};
    while (!plan.steps || run.advances.size() < plan.from + *plan.steps) {
        if (progress.cancelled()) {
            return error("cancelled", "the page was cancelled");
        }
        if (stepper.advance() == 0) {
            break;
        }
        if (run.advances.size() == plan.maxAdvances) {
            return error("too-large",
                         "the run has more than " + std::to_string(plan.maxAdvances) + " advances, too many for a page",
                         "choose a larger size, or limit the page with --steps");
        }
        run.advances.push_back(stepper.explanation());
    }
    if (plan.from > run.advances.size()) {
        return error("bad-range", "the page begins after advance " + std::to_string(plan.from) +
                                      ", but the run has only " + std::to_string(run.advances.size()) + " advances");
    }
    stepper.seek(run.advances.size()); // back from the first step of the improvement, if the run has such steps
    run.complete = stepper.complete() && stepper.position() == stepper.known();
    run.mesh = stepper.mesh();
    run.triangles = stepper.triangles();
    const std::size_t steps = stepper.snapshot({.mesh = false, .front = false})->improveSteps;
    if (run.complete && (options.improve != ImproveLevel::None || steps > 0)) {
        if (!stepper.finish(progress)) {
            return progress.cancelled() ? error("cancelled", "the page was cancelled")
                                        : error("unfinished-run", "the mesh cannot be completed after its front",
                                                "mesh the drawing to see why");
        }
        run.improved = stepper.mesh();
        const unsigned width = run.isColoured() || hasQuadrilaterals(*run.improved) ? 4 : 3;
        stepper.seek(run.advances.size());
        run.improvement = recordImprovement(stepper, run.mesh, width, plan.maxImproveBytes, progress);
        if (progress.cancelled()) {
            return error("cancelled", "the page was cancelled");
        }
    }
    return run;
}

std::string scriptString(const std::string &text) {
    std::string json = jsonString(text);
    for (std::size_t at = json.find('<'); at != std::string::npos; at = json.find('<', at)) {
        json.replace(at, 1, "\\u003c");
    }
    return json;
}

/// Returns text as the content of an HTML element.
std::string htmlText(const std::string &text) {
    std::string html;
    for (const char c : text) {
        html += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    }
    return html;
}

void writeRun(TextWriter &out, const RecordedRun &run, const std::string &title, std::uint64_t from,
              const std::vector<bool> &detailed) {
    writeRunWithoutSteps(out, run, title, from, detailed);
    writeSteps(out, run.improved ? &run.improvement : nullptr);
}

void writeSteps(TextWriter &out, const RecordedImprovement *improvement) {
    if (improvement != nullptr) {
        out << ",\"moments\":" << improvement->moments() << ",\"total\":" << improvement->total
            << ",\"unit\":" << improvement->unit << ",\"steps\":[";
        for (const std::string &step : improvement->steps) {
            out << (&step == improvement->steps.data() ? "\n" : ",\n") << step;
        }
        out << "]}";
    }
    out << '}';
}

void writeRunWithoutSteps(TextWriter &out, const RecordedRun &steps, const std::string &title, std::uint64_t from,
                          const std::vector<bool> &detailed) {
    RunRecord record(out);
    WordList words;
    out << "{\"title\":" << scriptString(title) << ",\"about\":" << jsonString(aboutText(steps.options))
        << ",\"from\":" << from << ",\"boundaryNodes\":" << steps.start.nodes.size();
    writeTexts(out, steps);
    if (steps.isColoured()) {
        writeColours(out, steps.triangles.colours);
    }
    out << ",\n\"nodes\":";
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
        const auto number = static_cast<std::size_t>(&advance - steps.advances.data());
        if (detailed.empty() || detailed[number]) {
            record.advance(*advance, steps.triangles.elements, words);
        } else {
            record.elements(*advance, steps.triangles.elements);
        }
    }
    out << "],\n\"words\":[";
    for (const std::string &word : words.words()) {
        out << (&word == words.words().data() ? "" : ",\n") << scriptString(word);
    }
    const RecordedImprovement &improvement = steps.improvement;
    const bool isColoured = steps.isColoured();
    out << "],\n\"raw\":";
    if (isColoured && !steps.improved) { // its figures are those of the first step
        out << "null";
    } else {
        out << '{';
        writeShape(out, steps.mesh, isColoured ? &improvement.before : nullptr);
        out << '}';
    }
    out << ",\n\"improved\":";
    if (!steps.improved) {
        out << "null";
        return;
    }
    out << '{';
    writeShape(out, *steps.improved, isColoured ? &improvement.after : nullptr);
    out << ",\"corners\":" << improvement.width << ",\"nodes\":";
    record.nodes(steps.improved->nodes);
    out << ",\"edges\":";
    record.edges(*steps.improved);
    out << ",\"elements\":";
    record.cells(*steps.improved, improvement.width);
    if (isColoured) {
        out << ",\"start\":";
        record.cells(steps.mesh, improvement.width);
    }
}

} // namespace forefront
