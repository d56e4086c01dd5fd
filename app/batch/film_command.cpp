#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/film_gif.hpp"
#include "app/batch/inputs.hpp"
#include "app/batch/options.hpp"
#include "core/edit/document.hpp"
#include "core/io/files.hpp"
#include "core/session/meshing_session.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr const char *kExamples = R"help(
Examples:
  forefront film plate.json -o run.gif --method classic --steps 200
        the first 200 advances as an animated GIF
  forefront film plate.json -o frames-%d.svg --frames 30
        30 drawings from the start to the finished mesh: frames-1.svg to frames-30.svg
  forefront film plate.json -o moment.svg --from 120 --steps 1 --layers mesh,boundary,front,candidates,caption
        advance 121 with its candidates and a caption

Exit codes: 0 done, 1 input refused (faults on stderr, one per line), 2 usage error.)help";

constexpr int kMaxFrames = 5000;

struct FilmArguments {
    std::filesystem::path input, output;
    std::string inputFormat;
    std::optional<Method> method;
    std::optional<GridKind> grid;
    std::optional<double> size;
    std::optional<std::string> expression;
    int from = 0;
    std::optional<int> steps;
    int frames = 120;
    int width = 800;
    double speed = 10.0; ///< frames per second
    std::vector<std::string> layers;

    bool gif() const { return output.extension() == ".gif"; }
    bool sequence() const { return output.filename().string().find("%d") != std::string::npos; }
};

/// A session whose moves are waited for.
class PatientSession {
  public:
    MeshingSession &session() { return session_; }

    /// Waits until the session rests and returns its snapshot.
    std::shared_ptr<const SessionSnapshot> rest() {
        std::unique_lock lock(mutex_);
        while (session_.busy()) {
            changed_.wait_for(lock, std::chrono::milliseconds(2));
        }
        return session_.latest();
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    MeshingSession session_{[this] { changed_.notify_all(); }};
};

Result<MeshingJob> readJob(const FilmArguments &arguments) {
    const Result<Input> input = openInput(arguments.input, arguments.inputFormat);
    if (!input) {
        return input.faults();
    }
    Result<Document> document = readDocument(input->path, input->options);
    if (!document) {
        return document.faults();
    }
    if (arguments.size || arguments.expression) {
        document->spacing = {};
        document->spacing.size = arguments.size;
        document->spacing.expression = arguments.expression;
    }
    document->options.method = arguments.method.value_or(document->options.method);
    document->options.grid = arguments.grid.value_or(document->options.grid);
    return MeshingJob{toDomain(*document), document->spacing, document->options};
}

FilmLayers layersOf(const FilmArguments &arguments) {
    FilmLayers layers;
    if (!arguments.layers.empty()) {
        layers.shown.fill(false);
        for (const std::string &word : arguments.layers) {
            layers.shown[static_cast<std::size_t>(*fromWord<FilmLayer>(word))] = true;
        }
    }
    return layers;
}

/// Returns the name of a frame, counted from 1.
std::filesystem::path frameName(const std::filesystem::path &pattern, int frame) {
    std::string name = pattern.filename().string();
    name.replace(name.find("%d"), 2, std::to_string(frame));
    return pattern.parent_path() / name;
}

/// Writes the moments of a run.
class Filming {
  public:
    explicit Filming(const FilmArguments &arguments) : arguments_(arguments), layers_(layersOf(arguments)) {}

    Diagnostics film(MeshingJob job) {
        patient_.session().want(layers_.needed());
        patient_.session().start(std::make_shared<const MeshingJob>(std::move(job)), StartMode::Pause);
        const auto start = patient_.rest();
        if (start->state == RunState::Failed) {
            return start->diagnostics;
        }
        sheet_.box = start->mesh->mesh.bounds();
        sheet_.width = arguments_.width;
        patient_.session().finish();
        const std::uint64_t end = patient_.rest()->known;
        const auto from = std::min<std::uint64_t>(static_cast<std::uint64_t>(arguments_.from), end);
        last_ = arguments_.steps ? std::min(end, from + static_cast<std::uint64_t>(*arguments_.steps)) : end;
        return arguments_.gif() ? writeGif(from) : arguments_.sequence() ? writeSequence(from) : writeMoment();
    }
    int written() const { return written_; }

  private:
    /// Calls write(scene, number) for each frame, numbered from 1, until it fails.
    template <class Write>
    Status forFrames(std::uint64_t from, Write write) {
        const std::uint64_t steps = last_ - from;
        const auto frames = static_cast<int>(std::min(steps + 1, static_cast<std::uint64_t>(arguments_.frames)));
        for (int k = 0; k < frames; ++k) {
            const std::uint64_t at =
                frames == 1 ? last_
                            : from + steps * static_cast<std::uint64_t>(k) / static_cast<std::uint64_t>(frames - 1);
            if (Status status = write(sceneAt(at), k + 1); !status.empty()) {
                return status;
            }
            ++written_;
        }
        return {};
    }

    Diagnostics writeGif(std::uint64_t from) {
        const int delay = std::max(2, static_cast<int>(100.0 / arguments_.speed + 0.5));
        Result<GifFilm> gif = GifFilm::create(arguments_.output, sheet_.width, sheet_.height(), delay);
        if (!gif) {
            return gif.faults();
        }
        const Status status = forFrames(from, [&](const FilmScene &scene, int) { return gif->add(scene); });
        return status.empty() ? gif->finish() : status;
    }
    Diagnostics writeSequence(std::uint64_t from) {
        return forFrames(from, [&](const FilmScene &scene, int number) {
            return writeFileAtomically(frameName(arguments_.output, number), svgOf(scene));
        });
    }
    Diagnostics writeMoment() {
        written_ = 1;
        return writeFileAtomically(arguments_.output, svgOf(sceneAt(last_)));
    }

    FilmScene sceneAt(std::uint64_t advance) {
        patient_.session().seek(advance);
        return sceneOf(*patient_.rest(), sheet_, layers_, last_);
    }

    const FilmArguments &arguments_;
    FilmLayers layers_;
    FilmSheet sheet_;
    std::uint64_t last_ = 0; ///< last advance of the film
    int written_ = 0;
    PatientSession patient_;
};

/// Returns what is wrong with the output, or an empty text.
std::string outputFault(const FilmArguments &arguments) {
    const std::string extension = arguments.output.extension().string();
    if (extension != ".gif" && extension != ".svg") {
        return "--output: unknown extension '" + extension + "'; expected .gif or .svg";
    }
    if (arguments.gif() && arguments.sequence()) {
        return "--output: a GIF holds all frames; leave out %d";
    }
    return {};
}

} // namespace

int filmCommand(int argc, const char *const *argv) {
    FilmArguments arguments;
    CLI::App app("Films a meshing run: an animated GIF, a sequence of SVG drawings, or one moment.", "forefront film");
    app.footer(kExamples);
    app.add_option("IN", arguments.input, "project, drawing or domain; -: standard input")->required();
    addInputFormatOption(app, "IN", arguments.inputFormat);
    app.add_option("-o,--output", arguments.output,
                   "FILE.gif: animation; NAME-%d.svg: a drawing for each frame; FILE.svg: the last moment")
        ->type_name("FILE")
        ->required();
    addWordOption<Method>(app, "--method", arguments.method, "method; otherwise that of the project, or fast");
    addWordOption<GridKind>(app, "--grid", arguments.grid, "background grid");
    auto *spacing = app.add_option_group("Spacing", "at most one; otherwise that of the project, or automatic");
    addSpacingOptions(*spacing, arguments.size, arguments.expression);
    spacing->require_option(0, 1);
    app.add_option("--from", arguments.from, "first moment: the number of advances done; default 0")
        ->check(wholeNumberWithin(0, 1'000'000'000));
    app.add_option("--steps", arguments.steps, "number of advances shown; otherwise to the end of the run")
        ->check(wholeNumberWithin(1, 1'000'000'000));
    app.add_option("--frames", arguments.frames, "maximum number of frames, default 120; long runs skip advances")
        ->check(wholeNumberWithin(1, kMaxFrames));
    app.add_option("--width", arguments.width, "width in pixels, default 800")->check(wholeNumberWithin(100, 4000));
    app.add_option("--speed", arguments.speed, "frames per second of a GIF, default 10")
        ->check(numberWithin(0.1, 50.0));
    app.add_option("--layers", arguments.layers,
                   "comma-separated: mesh, boundary, front, candidates, grid, caption (SVG)")
        ->delimiter(',')
        ->check(oneOf(wordsOf<FilmLayer>()));
    if (const auto code = parseOptions(app, argc, argv)) {
        return *code;
    }
    if (const std::string fault = outputFault(arguments); !fault.empty()) {
        return wrongUsage(app.get_name(), fault);
    }
    Result<MeshingJob> job = readJob(arguments);
    if (!job) {
        printFaults(job.faults());
        return kRefused;
    }
    Filming filming(arguments);
    if (const Diagnostics faults = filming.film(std::move(*job)); !faults.empty()) {
        printFaults(faults);
        return kRefused;
    }
    std::printf("wrote %s: %d %s\n", arguments.output.c_str(), filming.written(),
                filming.written() == 1 ? "frame" : "frames");
    return kDone;
}

} // namespace forefront
