#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/interrupt.hpp"
#include "app/batch/outputs.hpp"
#include "app/batch/run_arguments.hpp"
#include "app/batch/standard_output.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/files/text/atomic_file.hpp"
#include "core/teaching/trace/trace_compare.hpp"
#include "core/teaching/trace/trace_read.hpp"
#include "core/teaching/trace/trace_write.hpp"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace forefront {

namespace {

constexpr const char *kTraceExamples = R"help(
Examples:
  forefront trace ring.json -o run.json --method classic
        every advance of the front as JSON: base, rho, C, candidates with scores and verdicts, tests, elements
  forefront trace ring.json -o start.json --steps 0
        only the divided boundary, from which a program of your own can start
  forefront trace ring.json --method classic --compare mine.json
        find the first advance in which another program differs

Improvement is left out: a trace ends with the front.

Exit codes: 0 done, or the traces agree; 1 the traces differ, or the input is refused (faults on stderr, one per
line); 2 usage error, 3 cancelled.)help";

constexpr std::size_t kMaxTraceBytes = std::size_t{1} << 30;

struct TraceArguments {
    RunArguments run;
    std::optional<std::filesystem::path> output, other;
    std::optional<int> steps;

    std::optional<std::uint64_t> limit() const {
        return steps ? std::optional(static_cast<std::uint64_t>(*steps)) : std::nullopt;
    }
};

/// Writes the trace of a run. `finish` completes the sink and returns its faults.
template <class Sink, class Finish>
Status writeTo(Sink &sink, Finish finish, const TraceArguments &arguments, const MeshingJob &job,
               const Progress &progress) {
    TextWriter out(sink);
    Status status = writeTrace(job, arguments.limit(), out, progress);
    out.flush();
    return status.empty() ? finish() : status;
}

int writeRun(const TraceArguments &arguments, const OpenedRun &run, const InterruptWatch &interrupt) {
    Progress progress;
    progress.stop = interrupt.token();
    Status status;
    if (isStandardStream(*arguments.output)) {
        StandardOutput sink;
        status = writeTo(
            sink, [&] { return sink.status(); }, arguments, run.job, progress);
    } else {
        AtomicFile file(*arguments.output);
        status = writeTo(
            file, [&] { return file.commit(); }, arguments, run.job, progress);
    }
    if (hasErrors(status)) {
        return refuse(locateInRun(status, arguments.run, run.input), interrupt);
    }
    printWritten({*arguments.output}, stdout);
    return kDone;
}

/// Prints the result of a comparison with a file and returns the exit code.
int report(const TraceComparison &result, const SourceText &other, Method method) {
    const auto count = static_cast<unsigned long long>(result.advances);
    if (result.agree) {
        std::printf("the traces agree: %llu %s\n", count, result.advances == 1 ? "advance" : "advances");
        if (result.otherTests > 0) {
            std::printf("note: another test than ours rejects %s, first in %s\n",
                        countText(result.otherTests, "candidate").c_str(), result.otherTest.c_str());
        }
        return kDone;
    }
    const std::string place =
        result.offset ? other.name + ":" + std::to_string(placeOf(other.text, *result.offset).line) + ": " : "";
    std::printf("%sadvance %llu: %s\n", place.c_str(), count + 1, result.difference.c_str());
    if (method == Method::Fast) {
        std::printf("note: this run uses the fast method; add --method classic for Lo's ten steps\n");
    }
    return kRefused;
}

int compareRun(const TraceArguments &arguments, const OpenedRun &run, const InterruptWatch &interrupt) {
    const std::filesystem::path &path = *arguments.other;
    const Result<std::string> text =
        isStandardStream(path) ? readStandardInput(kMaxTraceBytes) : readRegularFile(path, kMaxTraceBytes);
    if (!text) {
        return refuse(text.faults(), interrupt);
    }
    SourceText source;
    source.text = *text;
    source.name = path.string();
    const Result<std::vector<TracedAdvance>> other = readTrace(source);
    if (!other) {
        return refuse(other.faults(), interrupt);
    }
    Progress progress;
    progress.stop = interrupt.token();
    const Result<TraceComparison> result = compareTrace(run.job, *other, arguments.limit(), progress);
    return result ? report(*result, source, run.job.options.method)
                  : refuse(locateInRun(result.faults(), arguments.run, run.input), interrupt);
}

/// Returns the error in a combination of options; empty if it is valid.
std::string wrongOptions(const TraceArguments &arguments) {
    if (!arguments.output && !arguments.other) {
        return "one of --output and --compare is required";
    }
    if (arguments.output && arguments.other) {
        return "--output and --compare exclude each other";
    }
    if (arguments.other && arguments.steps == 0) {
        return "--steps: there is nothing to compare in 0 advances";
    }
    return checkInputs({arguments.run.input, arguments.other}, arguments.run.inputFormat);
}

} // namespace

int traceCommand(const CommandLine &line) {
    TraceArguments arguments;
    CLI::App app("Writes every advance of a meshing run as JSON, or compares a run with the trace of another program.",
                 "forefront trace");
    app.footer(kTraceExamples);
    addRunOptions(app, arguments.run);
    app.add_option("-o,--output", arguments.output, "write the trace; -: standard output")->type_name("FILE");
    app.add_option("--compare", arguments.other, "compare with this trace, by position; -: standard input")
        ->type_name("FILE");
    app.add_option("--steps", arguments.steps, "number of advances; default: to the end of the run")
        ->check(wholeNumberWithin(0, 1'000'000'000));
    addConfigOption(app);
    if (const auto code = parseOptions(app, line)) {
        return *code;
    }
    if (const std::string wrong = wrongOptions(arguments); !wrong.empty()) {
        return wrongUsage(app.get_name(), wrong);
    }
    InterruptWatch interrupt;
    if (arguments.output) {
        if (const Diagnostics faults = checkOutputs({{*arguments.output, {}}}, {arguments.run.input});
            !faults.empty()) {
            return refuse(faults, interrupt);
        }
    }
    std::variant<OpenedRun, int> opened = openRun(app.get_name(), arguments.run, interrupt);
    if (const int *code = std::get_if<int>(&opened)) {
        return *code;
    }
    interrupt.deferToStop();
    const auto &run = std::get<OpenedRun>(opened);
    return arguments.output ? writeRun(arguments, run, interrupt) : compareRun(arguments, run, interrupt);
}

} // namespace forefront
