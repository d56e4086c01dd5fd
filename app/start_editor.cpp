#include "app/start_editor.hpp"

#include "core/engine/platform/program.hpp"

#include <cstdio>
#include <filesystem>
#include <string>

namespace forefront {

int startEditor(const EditorArguments &arguments) {
    namespace fs = std::filesystem;
    const fs::path folder = programFile().parent_path();
    const std::string name = "forefront-editor";
    std::error_code failed;
    // In the build tree; relative to the installed program, which can be moved; where it was installed first, if the
    // system does not tell where the program is.
    for (const fs::path &place :
         {folder / name, folder / FOREFRONT_EDITOR_FOLDER / name, fs::path(FOREFRONT_EDITOR_INSTALLED) / name}) {
        if (fs::is_regular_file(place, failed)) {
            const std::string reason = becomeProgram(place, editorWords(arguments));
            std::fprintf(stderr, "forefront: cannot start %s: %s\n", place.string().c_str(), reason.c_str());
            return kNoWindow;
        }
    }
    std::fprintf(stderr, "forefront: cannot open a window: %s not found beside the program; install Forefront again\n",
                 name.c_str());
    return kNoWindow;
}

} // namespace forefront
