#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "app/batch/suggestion.hpp"
#include "core/engine/base/free_memory.hpp"
#include "core/engine/base/version.hpp"
#include "core/engine/platform/file_handle.hpp"

#if defined(FOREFRONT_WITH_EDITOR)
#include "app/start_editor.hpp"
#endif

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr const char *kUsageText = R"(Forefront: planar triangle meshes by the advancing front technique.

  forefront [FILE]             open the editor with a project or domain file
  forefront view MESH          open a mesh in the editor and inspect its quality
  forefront mesh IN -o OUT     mesh a file in batch           (forefront mesh --help)
  forefront check MESH         check a mesh                   (forefront check --help)
  forefront adapt MESH         remesh to a requested error    (forefront adapt --help)
  forefront convert IN -o OUT  write a mesh in other formats  (forefront convert --help)
  forefront info FILE          tell what a file holds         (forefront info --help)
  forefront formats            list the file formats          (forefront formats --help)
  forefront film IN -o GIF     film a run step by step        (forefront film --help)
  forefront trace IN -o JSON   write every advance of a run   (forefront trace --help)
  forefront run SCRIPT         carry out a script of commands (forefront run --help)
  forefront rules              list the classic method's rules (forefront rules --help)
  forefront tables             reproduce the published tables (forefront tables --help)
  forefront --version          print the version
  forefront --help             print this help

Examples:
  forefront                                        open the editor
  forefront mesh lake.geojson -o lake.msh          mesh with automatic spacing
  forefront mesh plate.poly -o plate.vtu --size 1  mesh with edges of length 1
  forefront check lake.msh --domain lake.geojson   verify that the mesh fits its domain

Exit codes: 0 done, 1 input refused, 2 usage error, 3 cancelled, 4 no window (no display, or no OpenGL 3.3).
)";

#if defined(FOREFRONT_WITH_EDITOR)
/// Opens the editor, with a mesh to inspect if the command is "view". For tests it also accepts --frames N, to close
/// after N frames, and --state-file FILE, to write its state.
int editorCommand(int argc, const char *const *argv, bool view) {
    EditorArguments arguments;
    arguments.judge = view;
    CLI::App app(
        "Opens a mesh of any format in the editor to inspect its quality: colours, histograms, limits, worst places.",
        view ? "forefront view" : "forefront");
    if (!view) {
        app.set_help_flag();
    }
    app.add_option(view ? "MESH" : "FILE", arguments.file)->check(CLI::ExistingFile)->required(view);
    app.add_option("--frames", arguments.frames)->check(wholeNumberWithin(1, 1'000'000'000));
    app.add_option("--state-file", arguments.stateFile);
    if (const auto code = parseOptions(app, argc, argv)) {
        return *code;
    }
    return startEditor(arguments);
}
#else
int editorCommand(int /*argc*/, const char *const * /*argv*/, bool /*view*/) {
    std::fprintf(stderr, "This program was built without the editor.\n\n%s", kUsageText);
    return kUsage;
}
#endif

using Command = int (*)(int, const char *const *);

constexpr std::pair<std::string_view, Command> kCommands[] = {
    {"mesh", meshCommand},   {"check", checkCommand},     {"adapt", adaptCommand}, {"convert", convertCommand},
    {"info", infoCommand},   {"formats", formatsCommand}, {"film", filmCommand},   {"trace", traceCommand},
    {"rules", rulesCommand}, {"tables", tablesCommand},   {"run", runCommand}};

/// Returns the batch command of this name; null if there is none.
Command batchCommand(std::string_view name) {
    const auto *const found =
        std::find_if(std::begin(kCommands), std::end(kCommands), [&](const auto &c) { return c.first == name; });
    return found != std::end(kCommands) ? found->second : nullptr;
}

/// Returns the usage error for a first argument that is neither a command nor a file.
int unknownCommand(const std::string &word) {
    std::vector<std::string_view> names = {"view"};
    std::string list = "view";
    for (const auto &[name, command] : kCommands) {
        names.push_back(name);
        list += ", " + std::string(name);
    }
    return wrongUsage("forefront", "unknown command or file '" + word + "'; expected " + list + " or an existing file" +
                                       suggestion(word, names));
}

int dispatch(int argc, const char *const *argv) {
    useBinaryStandardStreams();
    const std::string_view command = argc > 1 ? argv[1] : "";
    if (command == "view") {
        return editorCommand(argc - 1, argv + 1, true);
    }
    if (const Command batch = batchCommand(command)) {
        keepFreedMemory();
        return batch(argc - 1, argv + 1);
    }
    if (command == "--version") {
        std::printf("forefront %s\n", version());
        return kDone;
    }
    if (command == "--help" || command == "-h" || command == "help") {
        std::fputs(kUsageText, stdout);
        return kDone;
    }
    std::error_code none;
    if (!command.empty() && !command.starts_with('-') && !std::filesystem::exists(command, none)) {
        return unknownCommand(std::string(command));
    }
    return editorCommand(argc, argv, false);
}

} // namespace

} // namespace forefront

int main(int argc, char **argv) {
    try {
        return forefront::dispatch(argc, argv);
    } catch (const std::bad_alloc &) {
        std::fputs("error: out of memory\n", stderr);
    } catch (const std::exception &error) {
        std::fprintf(stderr, "error: %s\n", error.what());
    }
    return forefront::kRefused;
}
