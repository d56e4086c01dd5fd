#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/interrupt.hpp"
#include "app/batch/outputs.hpp"
#include "app/batch/progress_bar.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/files/files.hpp"
#include "core/files/text/atomic_file.hpp"
#include "core/teaching/lesson/answers.hpp"
#include "core/teaching/lesson/lesson_check.hpp"
#include "core/teaching/lesson/lesson_file.hpp"
#include "core/teaching/lesson/lesson_names.hpp"
#include "core/teaching/lesson/random_numbers.hpp"
#include "core/teaching/lesson/seed_check.hpp"
#include "core/teaching/lesson_page/lesson_page.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr const char *kLessonExamples = R"help(
Examples:
  forefront lesson mine.json
        check a lesson: its names, its drawings, and that each question can be answered
  forefront lesson assets/lessons/*.json
        check several
  forefront lesson mine.json -o mine.html
        write the lesson as a page for a browser, with its questions and its runs; needs no network
  forefront lesson mine.json --seed 7 -o mine-7.html
        the same with other random numbers, such as one page for each learner
  forefront lesson mine.json --answers ann.json,bob.json
        check answers that learners saved, in the editor or on a page, and count the right ones

The format of lessons is described in assets/lessons/README.md. The check runs every drawing, so it knows whether
a position exists, whether a value has a number there and which answers are right. The page shows mesh, front,
candidates and cells; other layers and the panels of the editor are left out. It saves the learner's answers as a file.
A lesson with random numbers is checked with every number of ranges up to 64, and with samples of larger ones, unless
--seed chooses one. Answers are checked with the seed in their file; they are answered again, and a file that claims
what is not so is refused.

Exit codes: 0 no faults, or warnings only; 1 a lesson or a file of answers has faults (on stderr, one per line);
2 usage error, 3 cancelled.)help";

/// What the command line asks for.
struct LessonArguments {
    std::vector<std::filesystem::path> files;
    std::optional<std::filesystem::path> output;
    std::optional<std::int64_t> seed;
    std::vector<std::filesystem::path> answers;
};

Result<LessonFile> readSeeded(const std::filesystem::path &path, std::uint64_t seed) {
    LessonNames names = editorNames();
    names.seed = seed;
    return readLessonFile(path, std::move(names));
}

/// Writes a lesson as a page and returns the exit code.
int writePage(const LessonFile &lesson, LessonRuns &runs, const std::filesystem::path &output, const Progress &progress,
              const InterruptWatch &interrupt) {
    AtomicFile file(output);
    TextWriter out(file);
    Status status = writeLessonPage(lesson.lesson, runs, out, progress);
    out.flush();
    if (!hasErrors(status)) {
        const Status written = file.commit();
        status.insert(status.end(), written.begin(), written.end());
    }
    for (Diagnostic &fault : status) {
        fault.file = fault.line > 0 ? lesson.path.string() : fault.file;
    }
    if (hasErrors(status)) {
        return refuse(status, interrupt);
    }
    printFaults(status);
    printWritten({output}, stdout);
    return kDone;
}

/// Returns how many random numbers a check has tried: ", with the random numbers of 18 seeds, every one of them".
std::string seedsText(const SeedCheck &check) {
    return check.seeds == 0 ? std::string()
                            : ", with " + std::string(check.everyNumber ? "every random number" : "random numbers") +
                                  " of " + countText(check.seeds, "seed");
}

/// Checks a lesson, prints its faults, or what it holds, and writes its page if there is to be one. Returns the exit
/// code.
int checkFile(const std::filesystem::path &path, const LessonArguments &arguments, const InterruptWatch &interrupt) {
    const Result<LessonFile> file = readSeeded(path, static_cast<std::uint64_t>(arguments.seed.value_or(1)));
    if (!file) {
        return refuse(file.faults(), interrupt);
    }
    ProgressBar bar(true);
    const Progress progress = bar.progress(interrupt.token());
    const bool drawsSeeds = file->lesson.seed > 0 && !arguments.seed;
    LessonRuns runs(arguments.output || drawsSeeds ? LessonRuns::Keep::All : LessonRuns::Keep::Last);
    const SeedCheck check = bar.during("checking", [&] {
        return drawsSeeds ? checkSeeds(*file, editorNames(), runs, progress)
                          : SeedCheck{checkLesson(file->lesson, file->source(), runs, {{}, progress.stop}), 0, true};
    });
    if (interrupt.interrupted() || hasErrors(check.faults)) {
        return refuse(check.faults, interrupt);
    }
    printFaults(check.faults);
    std::printf("%s: %s, %s; %s%s\n", file->path.string().c_str(), countText(file->lesson.pages.size(), "page").c_str(),
                countText(questionsOf(file->lesson), "question").c_str(),
                check.faults.empty() ? "no faults"
                                     : ("no errors, " + countText(check.faults.size(), "warning")).c_str(),
                seedsText(check).c_str());
    const Progress quiet{{}, progress.stop};
    return arguments.output ? writePage(*file, runs, *arguments.output, quiet, interrupt) : kDone;
}

/// Checks a file of answers to a lesson and prints how they do. Returns the exit code.
int checkAnswerFile(const std::filesystem::path &lesson, const std::filesystem::path &path,
                    const InterruptWatch &interrupt) {
    constexpr std::size_t kMaxBytes = std::size_t{4} << 20U;
    const Result<std::string> text = readRegularFile(path, kMaxBytes);
    if (!text) {
        return refuse(text.faults(), interrupt);
    }
    SourceText source;
    source.text = *text;
    source.name = path.string();
    const Result<LessonAnswers> answers = readAnswers(source);
    if (!answers) {
        return refuse(answers.faults(), interrupt);
    }
    const Result<LessonFile> file = readSeeded(lesson, std::max<std::uint64_t>(answers->seed, 1));
    if (!file) {
        return refuse(file.faults(), interrupt);
    }
    ProgressBar bar(true);
    LessonRuns runs;
    const Result<AnswerScore> score = bar.during("checking answers", [&] {
        return checkAnswers(*answers, source, file->lesson, runs, bar.progress(interrupt.token()));
    });
    if (!score || interrupt.interrupted()) {
        return refuse(score ? Diagnostics() : score.faults(), interrupt);
    }
    std::printf("%s: %zu of %s right, %zu at the first try\n", path.string().c_str(), score->answered,
                countText(score->questions, "question").c_str(), score->firstTry);
    for (const std::string &line : score->lines) {
        std::printf("  %s\n", line.c_str());
    }
    return kDone;
}

/// Returns what is wrong with the arguments; empty if nothing is.
std::string argumentFault(const LessonArguments &arguments) {
    if (arguments.output && arguments.files.size() > 1) {
        return "--output: expected one lesson, got " + std::to_string(arguments.files.size());
    }
    if (arguments.output && arguments.output->extension() != ".html") {
        return "--output: expected FILE.html, got '" + arguments.output->string() + "'";
    }
    if (!arguments.answers.empty() && (arguments.files.size() > 1 || arguments.output || arguments.seed)) {
        return "--answers: expected one lesson, and neither --output nor --seed";
    }
    return {};
}

} // namespace

int lessonCommand(const CommandLine &line) {
    LessonArguments arguments;
    CLI::App app(
        "Checks lessons: the file, the drawings, positions, and that each question has a right answer; writes one as "
        "a page for a browser; checks answers of learners.",
        "forefront lesson");
    app.footer(kLessonExamples);
    app.add_option("FILE", arguments.files, "lesson, a JSON file")->required();
    app.add_option("-o,--output", arguments.output, "write the lesson as a page, FILE.html")->type_name("FILE");
    app.add_option("--seed", arguments.seed, "choose the random numbers of the lesson; default 1")
        ->type_name("N")
        ->check(CLI::Range(std::int64_t{1}, kMaxLessonSeed));
    app.add_option("--answers", arguments.answers, "check files of answers to the lesson, separated by commas")
        ->delimiter(',')
        ->type_name("FILES");
    if (const auto code = parseOptions(app, line)) {
        return *code;
    }
    if (const std::string wrong = argumentFault(arguments); !wrong.empty()) {
        return wrongUsage(app.get_name(), wrong);
    }
    InterruptWatch interrupt;
    if (arguments.output) {
        if (const Diagnostics faults = checkOutputs({{*arguments.output, {}}}, {arguments.files.front()});
            !faults.empty()) {
            return refuse(faults, interrupt);
        }
    }
    interrupt.deferToStop();
    int code = kDone;
    for (const std::filesystem::path &answers : arguments.answers) {
        code = std::max(code, checkAnswerFile(arguments.files.front(), answers, interrupt));
    }
    for (const std::filesystem::path &file : arguments.files) {
        if (!arguments.answers.empty() || interrupt.interrupted()) {
            break;
        }
        code = std::max(code, checkFile(file, arguments, interrupt));
    }
    return code;
}

} // namespace forefront
