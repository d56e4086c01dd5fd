#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/interrupt.hpp"
#include "app/batch/outputs.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/files/text/atomic_file.hpp"
#include "core/teaching/lesson/lesson_check.hpp"
#include "core/teaching/lesson/lesson_file.hpp"
#include "core/teaching/lesson/lesson_names.hpp"
#include "core/teaching/lesson_page/lesson_page.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
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

The format of lessons is described in assets/lessons/README.md. The check runs every drawing, so it knows whether
a position exists, whether a value has a number there and which answers are right. The page shows mesh, front,
candidates and cells; other layers and the panels of the editor are left out. It saves the learner's answers as a file.

Exit codes: 0 no faults, or warnings only; 1 a lesson has faults (on stderr, one per line); 2 usage error, 3 cancelled.)help";

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

/// Checks a lesson, prints its faults, or what it holds, and writes its page if there is to be one. Returns the exit
/// code.
int checkFile(const std::filesystem::path &path, const std::optional<std::filesystem::path> &output,
              const InterruptWatch &interrupt) {
    const Result<LessonFile> file = readLessonFile(path, editorNames());
    if (!file) {
        return refuse(file.faults(), interrupt);
    }
    Progress progress;
    progress.stop = interrupt.token();
    LessonRuns runs(output ? LessonRuns::Keep::All : LessonRuns::Keep::Last);
    const Diagnostics faults = checkLesson(file->lesson, file->source(), runs, progress);
    if (interrupt.interrupted() || hasErrors(faults)) {
        return refuse(faults, interrupt);
    }
    printFaults(faults);
    const std::string found = faults.empty() ? "no faults" : "no errors, " + countText(faults.size(), "warning");
    std::printf("%s: %s, %s; %s\n", path.string().c_str(), countText(file->lesson.pages.size(), "page").c_str(),
                countText(questionsOf(file->lesson), "question").c_str(), found.c_str());
    return output ? writePage(*file, runs, *output, progress, interrupt) : kDone;
}

} // namespace

int lessonCommand(const CommandLine &line) {
    std::vector<std::filesystem::path> files;
    std::optional<std::filesystem::path> output;
    CLI::App app(
        "Checks lessons: the file, the drawings, positions, and that each question has a right answer; writes one as "
        "a page for a browser.",
        "forefront lesson");
    app.footer(kLessonExamples);
    app.add_option("FILE", files, "lesson, a JSON file")->required();
    app.add_option("-o,--output", output, "write the lesson as a page, FILE.html")->type_name("FILE");
    if (const auto code = parseOptions(app, line)) {
        return *code;
    }
    if (output && files.size() > 1) {
        return wrongUsage(app.get_name(), "--output: expected one lesson, got " + std::to_string(files.size()));
    }
    if (output && output->extension() != ".html") {
        return wrongUsage(app.get_name(), "--output: expected FILE.html, got '" + output->string() + "'");
    }
    InterruptWatch interrupt;
    if (output) {
        if (const Diagnostics faults = checkOutputs({{*output, {}}}, {files.front()}); !faults.empty()) {
            return refuse(faults, interrupt);
        }
    }
    interrupt.deferToStop();
    int code = kDone;
    for (const std::filesystem::path &file : files) {
        const int checked = checkFile(file, output, interrupt);
        if (interrupt.interrupted()) {
            return checked;
        }
        code = std::max(code, checked);
    }
    return code;
}

} // namespace forefront
