#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "core/engine/base/free_memory.hpp"
#include "core/engine/base/version.hpp"
#include "core/engine/platform/file_handle.hpp"

#if defined(FOREFRONT_WITH_EDITOR)
#include "app/start_editor.hpp"
#endif

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace forefront {

namespace {

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
    if (!view) {
        app.add_option("FILES", arguments.others)->check(CLI::ExistingFile); // in further tabs
    }
    app.add_option("--frames", arguments.frames)->check(wholeNumberWithin(1, 1'000'000'000));
    app.add_option("--state-file", arguments.stateFile);
    if (const auto code = parseOptions(app, {argc, argv})) {
        return *code;
    }
    return startEditor(arguments);
}
#else
int editorCommand(int /*argc*/, const char *const * /*argv*/, bool /*view*/) {
    std::fprintf(stderr, "This program was built without the editor.\n\n%s", usageText().data());
    return kUsage;
}
#endif

/// Returns the usage error for a first argument that is neither a command nor a file.
int unknownCommand(std::string_view word) {
    return wrongUsage("forefront", "unknown command or file " + unknownCommandText(word, " or an existing file"));
}

int dispatch(int argc, const char *const *argv) {
    useBinaryStandardStreams();
    const std::string_view command = argc > 1 ? argv[1] : "";
    if (command == "view") {
        return editorCommand(argc - 1, argv + 1, true);
    }
    if (const NamedCommand *const batch = batchCommand(command)) {
        keepFreedMemory();
        return batch->run({argc - 1, argv + 1});
    }
    if (command == "--version") {
        std::printf("forefront %s\n", version());
        return kDone;
    }
    if (command == "--help" || command == "-h") {
        std::printf("%s", usageText().data());
        return kDone;
    }
    std::error_code none;
    if (!command.empty() && !command.starts_with('-') && !std::filesystem::exists(command, none)) {
        return unknownCommand(command);
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
