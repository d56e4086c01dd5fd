#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/interrupt.hpp"
#include "app/batch/run_arguments.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/teaching/film/film_files.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace forefront {

namespace {

constexpr const char *kFilmExamples = R"help(
Examples:
  forefront film plate.json -o run.gif --method classic --steps 200
        the first 200 advances as an animated GIF
  forefront film plate.json -o frames-%d.png --frames 30
        30 pictures from the start to the finished mesh: frames-1.png to frames-30.png
  forefront film plate.json -o moment.pdf --at 121 --labels
        the moment after advance 121, with A, B, C, the search circle, and the candidates with their ranks and scores
  forefront film plate.json -o steps.gif --method classic --from 40 --steps 6 --events --follow --labels
        six advances event by event, with the view close to the front
  forefront film plate.json -o run.html --method classic
        a page that plays the run in a browser, forward and back, with the ten steps, the candidates and the steps of
        the improvement; needs no network. A link to run.html#40 opens it after advance 40, #40.5 at event 5 of the
        next one, and after the last of 100 advances #100.i3 at step 3 of the improvement, #100.improved at its end

Exit codes: 0 done, 1 input refused (faults on stderr, one per line), 2 usage error, 3 cancelled.)help";

struct FilmArguments {
    RunArguments run;
    int from = 0;
    std::optional<int> steps;
    std::optional<int> at;
    bool labels = false;
    std::vector<std::string> layers;
    FilmPlan plan;
};

FilmLayers layersOf(const FilmArguments &arguments) {
    FilmLayers layers;
    if (!arguments.layers.empty()) {
        layers.shown.fill(false);
        for (const std::string &word : arguments.layers) {
            layers.shown[static_cast<std::size_t>(*fromWord<FilmLayer>(word))] = true;
        }
    }
    if (arguments.labels) {
        layers.shown[static_cast<std::size_t>(FilmLayer::Labels)] = true;
    }
    return layers;
}

FilmPlan planOf(const FilmArguments &arguments) {
    FilmPlan plan = arguments.plan;
    plan.from = static_cast<std::uint64_t>(arguments.from);
    if (arguments.steps) {
        plan.steps = static_cast<std::uint64_t>(*arguments.steps);
    }
    if (arguments.at) {
        plan.from = static_cast<std::uint64_t>(*arguments.at);
        plan.steps = 0;
    }
    plan.layers = layersOf(arguments);
    plan.title = isStandardStream(arguments.run.input) ? std::string() : arguments.run.input.stem().string();
    return plan;
}

/// Returns the error for an option that does not apply to this kind of output; empty if there is none.
std::string unusedOption(const CLI::App &app, const FilmPlan &plan) {
    const bool animation = plan.isAnimation();
    for (const char *option : {"--frames", "--width", "--layers", "--labels", "--view", "--follow", "--events"}) {
        if (plan.isPage() && app.count(option) > 0) {
            return std::string(option) + ": a page has no such setting; the reader of the page chooses";
        }
    }
    if (app.count("--speed") > 0 && !animation) {
        return "--speed: applies only to an animation";
    }
    if (app.count("--at") > 0 && (animation || plan.isPage() || plan.numbered())) {
        return "--at: applies only to a single picture; use --from and --steps";
    }
    if (animation || plan.isPage() || plan.numbered()) {
        return {};
    }
    if (app.count("--events") > 0) {
        return "--events: a single picture shows a whole advance; write an animation, or number the pictures with %d";
    }
    if (app.count("--frames") > 0) {
        return "--frames: a single picture has only one frame; write an animation, or number the pictures with %d";
    }
    if (app.count("--from") > 0 && app.count("--steps") == 0) {
        return "--from: a single picture shows the end of the range; also give --steps, such as --steps 1, or use --at";
    }
    return {};
}

/// Declares the options of the command; parsing sets the arguments.
void addFilmOptions(CLI::App &app, FilmArguments &arguments) {
    addRunOptions(app, arguments.run);
    app.add_option("-o,--output", arguments.plan.output,
                   "FILE.gif, .mp4 or .webm: animation, videos by the program ffmpeg; FILE.html: page that plays the "
                   "run; NAME-%d.png, .svg or .pdf: one "
                   "picture per frame; FILE.png, .svg or .pdf: one moment, the last unless --at is given")
        ->type_name("FILE")
        ->required();
    auto *const from = app.add_option("--from", arguments.from,
                                      "first moment: the number of advances done; after the last one, the steps of the "
                                      "improvement count on; default 0")
                           ->check(wholeNumberWithin(0, 1'000'000'000));
    auto *const steps = app.add_option("--steps", arguments.steps,
                                       "number of advances shown; default: to the end of the run, with its improvement")
                            ->check(wholeNumberWithin(1, 1'000'000'000));
    app.add_option("--at", arguments.at, "the moment of a single picture, counted as --from")
        ->check(wholeNumberWithin(0, 1'000'000'000))
        ->excludes(from)
        ->excludes(steps);
    app.add_flag("--labels", arguments.labels,
                 "also show A, B, C, the search circle, the rank, score and verdict of each candidate, and a legend");
    app.add_option("--frames", arguments.plan.frames,
                   "maximum number of frames, default 120; long runs skip advances, then steps")
        ->check(wholeNumberWithin(1, FilmPlan::kMaxFrames));
    app.add_option("--width", arguments.plan.width, "width in pixels, default 800")
        ->check(wholeNumberWithin(FilmPlan::kMinWidth, FilmPlan::kMaxWidth));
    app.add_option("--speed", arguments.plan.speed, "frames per second of an animation, default 10")
        ->check(numberWithin(FilmPlan::kSlowest, FilmPlan::kFastest));
    app.add_option("--layers", arguments.layers,
                   "comma-separated: mesh, boundary, front, candidates, grid, caption, labels, improvement (what its "
                   "steps change), colours (of the nodes of a front of quadrilaterals)")
        ->delimiter(',')
        ->check(oneOf(wordsOf<FilmLayer>()));
    addBoxOption(app, "--view", "part of the plane shown; default: the whole domain", arguments.plan.view);
    app.add_flag("--follow", arguments.plan.follow, "the view follows the front: the base takes a tenth of the width");
    app.add_flag("--events", arguments.plan.events, "a frame for each event of an advance, not one for each advance");
}

} // namespace

int filmCommand(const CommandLine &line) {
    FilmArguments arguments;
    CLI::App app("Writes a film of a meshing run: an animated GIF, a video, a page, numbered frames, or one moment.",
                 "forefront film");
    app.footer(kFilmExamples);
    addFilmOptions(app, arguments);
    addConfigOption(app);
    if (const auto code = parseOptions(app, line)) {
        return *code;
    }
    const FilmPlan plan = planOf(arguments);
    if (const std::string fault = outputFault(plan); !fault.empty()) {
        return wrongUsage(app.get_name(), "--output: " + fault);
    }
    if (const std::string fault = unusedOption(app, plan); !fault.empty()) {
        return wrongUsage(app.get_name(), fault);
    }
    InterruptWatch interrupt;
    std::variant<OpenedRun, int> opened = openRun(app.get_name(), arguments.run, interrupt);
    if (const int *code = std::get_if<int>(&opened)) {
        return *code;
    }
    auto &[input, job] = std::get<OpenedRun>(opened);
    interrupt.deferToStop();
    Progress progress;
    progress.stop = interrupt.token();
    const bool gridless = job.options.grid == GridKind::None && !arguments.layers.empty();
    if (gridless && plan.layers.shown[static_cast<std::size_t>(FilmLayer::Grid)]) {
        return wrongUsage(app.get_name(), "--layers: the run has no background grid to show; add --grid");
    }
    const Result<WrittenFilm> written = writeFilm(std::move(job), plan, progress);
    if (!written) {
        return refuse(locateInRun(written.faults(), arguments.run, input), interrupt);
    }
    if (plan.steps && written->last - written->first < *plan.steps) {
        const std::uint64_t steps = written->last - std::min(written->last, written->advances);
        std::fprintf(stderr, "note: the run ends at advance %llu%s, before --steps %llu are shown\n",
                     static_cast<unsigned long long>(written->advances),
                     steps > 0 ? (" and " + countText(steps, "step") + " of the improvement").c_str() : "",
                     static_cast<unsigned long long>(*plan.steps));
    }
    if (plan.layers.has(FilmLayer::Labels) && !plan.isPage() && !written->labelled) {
        std::fprintf(stderr, "note: no labels: %s\n",
                     plan.view ? "no advance of the film lies in --view"
                               : "at the start and in the improvement there is no advance to show");
    }
    const unsigned long long count = plan.isPage() ? written->last : static_cast<unsigned long long>(written->frames);
    std::printf("wrote %s: %llu %s%s\n", plan.output.string().c_str(), count, plan.isPage() ? "advance" : "frame",
                count == 1 ? "" : "s");
    return kDone;
}

} // namespace forefront
