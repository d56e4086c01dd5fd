#pragma once

#include "app/batch/cli_options.hpp"
#include "app/batch/inputs.hpp"
#include "app/batch/interrupt.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesher/options.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>

namespace forefront {

/// The input of a command that steps through a run, and the options that change it.
struct RunArguments {
    std::filesystem::path input;                   ///< "-": standard input
    std::string inputFormat;                       ///< id; empty: by content and extension
    std::map<std::string, std::string> parameters; ///< expressions by name, from --set
    DrawingArguments drawing;
    std::optional<Method> method;
    std::optional<GridKind> grid;
    std::optional<double> size;
    std::optional<std::string> expression;
    std::optional<double> maxElements;
    std::optional<std::filesystem::path> rules; ///< of the classic method
};

/// Adds the argument IN and the options --input-format, --set, --method, --grid, --size, --spacing, --max-elements,
/// --rules and those of addDrawingOptions().
void addRunOptions(CLI::App &app, RunArguments &arguments);

/// The input of a run, read.
struct OpenedRun {
    Input input;
    MeshingJob job;
};
/// Opens and reads the input of a run and applies the options. Prints the notes of its reader to stderr; where it is
/// refused, prints why and returns the exit code. `command`: "forefront film", for usage errors.
std::variant<OpenedRun, int> openRun(const std::string &command, const RunArguments &arguments,
                                     const InterruptWatch &interrupt);

/// Adds the place of the spacing expression in a project to faults of its run; others are left unchanged.
Diagnostics locateInRun(Diagnostics faults, const RunArguments &arguments, const Input &input);

} // namespace forefront
