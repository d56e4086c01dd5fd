#include "app/batch/commands.hpp"
#include "app/batch/suggestion.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace forefront {

namespace {

constexpr const char *kUsageText =
    R"(Forefront: planar meshes of triangles and quadrilaterals by the advancing front technique.

  forefront [FILE...]          open the editor with project or domain files
  forefront view MESH          open a mesh in the editor and inspect its quality
  forefront mesh IN -o OUT     mesh a file in batch           (forefront mesh --help)
  forefront check MESH         check a mesh                   (forefront check --help)
  forefront adapt MESH         remesh to a requested error    (forefront adapt --help)
  forefront convert IN -o OUT  write a mesh in other formats  (forefront convert --help)
  forefront info FILE          tell what a file holds         (forefront info --help)
  forefront formats            list the file formats          (forefront formats --help)
  forefront film IN -o GIF     film a run step by step        (forefront film --help)
  forefront trace IN -o JSON   write every advance of a run   (forefront trace --help)
  forefront lesson FILE        check a lesson or write a page (forefront lesson --help)
  forefront run SCRIPT         carry out a script of commands (forefront run --help)
  forefront completion SHELL   completion of options for a shell (forefront completion --help)
  forefront help --man         print the manual page
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

constexpr std::array<NamedCommand, 14> kCommands = {{{"mesh", meshCommand},
                                                     {"check", checkCommand},
                                                     {"adapt", adaptCommand},
                                                     {"convert", convertCommand},
                                                     {"info", infoCommand},
                                                     {"formats", formatsCommand},
                                                     {"film", filmCommand},
                                                     {"trace", traceCommand},
                                                     {"lesson", lessonCommand},
                                                     {"run", runCommand},
                                                     {"completion", completionCommand},
                                                     {"help", helpCommand},
                                                     {"rules", rulesCommand},
                                                     {"tables", tablesCommand}}};

} // namespace

std::span<const NamedCommand> batchCommands() {
    return kCommands;
}

const NamedCommand *batchCommand(std::string_view name) {
    const auto *const found =
        std::find_if(kCommands.begin(), kCommands.end(), [&](const NamedCommand &c) { return c.name == name; });
    return found != kCommands.end() ? found : nullptr;
}

std::vector<CommandInfo> describeCommands() {
    std::vector<CommandInfo> commands(kCommands.size());
    for (std::size_t k = 0; k < kCommands.size(); ++k) {
        const std::string name(kCommands[k].name);
        const char *const words[] = {name.c_str()};
        kCommands[k].run({1, words, &commands[k]});
    }
    return commands;
}

std::string unknownCommandText(std::string_view word, std::string_view expected) {
    std::vector<std::string_view> names = {"view"};
    std::string list = "view";
    for (const NamedCommand &command : kCommands) {
        names.push_back(command.name);
        list += ", " + std::string(command.name);
    }
    return "'" + std::string(word) + "'; expected " + list + std::string(expected) + suggestion(word, names);
}

std::string_view usageText() {
    return kUsageText;
}

} // namespace forefront
