#include "app/batch/run_arguments.hpp"

#include "app/batch/exit_code.hpp"
#include "app/batch/option_notes.hpp"
#include "app/batch/rules_option.hpp"
#include "core/drawing/document/document.hpp"
#include "core/drawing_files/documents.hpp"

#include <utility>

namespace forefront {

namespace {

/// Reads the job of an input and applies the options.
Result<MeshingJob> readJob(const RunArguments &arguments, const Input &input) {
    ImportNotes notes;
    Result<Document> document = readDocument(input.path, input.options, &notes);
    if (!document) {
        return document.faults();
    }
    Result<MeshingJob> read = readJobOf(*document, input.path.string(), &notes);
    printNotes(notes, false);
    if (!read) {
        return read;
    }
    MeshingJob &job = *read;
    const Diagnostics remarks = namePartsOf(arguments.drawing, input, false, job.domain);
    if (hasErrors(remarks)) {
        return remarks;
    }
    printFaults(remarks);
    if (arguments.size || arguments.expression) {
        printFaults(replacedSpacing(arguments.size ? "--size" : "--spacing", job.spacing));
    }
    applySpacingOptions(arguments.size, arguments.expression, job.spacing);
    job.options.method = arguments.method.value_or(job.options.method);
    job.options.grid = arguments.grid.value_or(job.options.grid);
    applyMaxElements(arguments.maxElements, job.options);
    if (Diagnostics faults = applyRules(arguments.rules, job.options); !faults.empty()) {
        return faults;
    }
    return read;
}

} // namespace

void addRunOptions(CLI::App &app, RunArguments &arguments) {
    app.add_option("IN", arguments.input, "project, drawing or domain; -: standard input")->required();
    addInputFormatOption(app, "IN", arguments.inputFormat);
    addParameterOption(app, arguments.parameters);
    addDrawingOptions(app, arguments.drawing);
    addWordOption<Method>(app, "--method", arguments.method, "method; default: from the project, or fast");
    addWordOption<GridKind>(app, "--grid", arguments.grid, "background grid");
    auto *spacing = app.add_option_group("Spacing", "at most one; default: from the project, or automatic");
    addSpacingOptions(*spacing, arguments.size, arguments.expression);
    spacing->require_option(0, 1);
    addMaxElementsOption(app, arguments.maxElements);
    addRulesOption(app, arguments.rules);
}

std::variant<OpenedRun, int> openRun(const std::string &command, const RunArguments &arguments,
                                     const InterruptWatch &interrupt) {
    Result<Input> input = openInput(arguments.input, arguments.inputFormat);
    if (!input) {
        return refuse(input.faults(), interrupt);
    }
    std::string wrong = checkDrawingOptions(arguments.drawing, *input, false);
    wrong = wrong.empty() ? setParameters(*input, arguments.parameters) : wrong;
    if (!wrong.empty()) {
        return wrongUsage(command, wrong);
    }
    arguments.drawing.applyTo(input->options);
    Result<MeshingJob> job = readJob(arguments, *input);
    if (!job) {
        return refuse(job.faults(), interrupt);
    }
    return OpenedRun{std::move(*input), std::move(*job)};
}

Diagnostics locateInRun(Diagnostics faults, const RunArguments &arguments, const Input &input) {
    return arguments.expression ? faults : locateSpacing(std::move(faults), input);
}

} // namespace forefront
