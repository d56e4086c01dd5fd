#include "core/files/components/component.hpp"

#include "core/engine/base/version.hpp"
#include "core/engine/platform/shared_library.hpp"

#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#ifndef FOREFRONT_COMPONENT_FOLDER
#define FOREFRONT_COMPONENT_FOLDER ""
#endif

namespace forefront {

namespace {

/// Returns the folder of the program or shared library that this code is part of; empty if it cannot be found.
std::filesystem::path ownFolder() {
    static const char kPlace = 0;
    return fileOfCode(&kPlace).parent_path();
}

std::vector<std::filesystem::path> componentFolders() {
    const char *const given = std::getenv("FOREFRONT_COMPONENTS"); // NOLINT(concurrency-mt-unsafe): nothing sets it
    if (given != nullptr && *given != '\0') {
        return {given};
    }
    std::vector<std::filesystem::path> folders;
    if (const std::filesystem::path own = ownFolder(); !own.empty()) {
        folders = {own / "forefront", own.parent_path() / "lib" / "forefront"};
    }
    if (constexpr std::string_view kInstalled = FOREFRONT_COMPONENT_FOLDER; !kInstalled.empty()) {
        folders.emplace_back(kInstalled);
    }
    return folders;
}

Diagnostics missing(const std::string &name, const std::string &reason, const std::string &advice) {
    return error("missing-component", "the component forefront-" + name + " is needed, but " + reason, advice);
}

} // namespace

Result<const void *> loadComponent(const std::string &name, const std::string &packages) {
    const std::string file = "forefront-" + name + std::string(kSharedLibraryEnd);
    for (const std::filesystem::path &folder : componentFolders()) {
        const std::filesystem::path path = folder / file;
        std::error_code none;
        if (!std::filesystem::is_regular_file(path, none)) {
            continue;
        }
        std::string failure;
        void *const library = loadSharedLibrary(path, failure);
        if (library == nullptr) {
            return missing(name, "cannot be loaded: " + failure, "on Debian: apt-get install " + packages);
        }
        void *const symbol = findExport(library, "forefront_" + name);
        if (symbol == nullptr) {
            return missing(name, path.string() + " is something else", "reinstall forefront-" + name);
        }
        // Systems give functions as addresses of data. NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast)
        const void *const functions = reinterpret_cast<ComponentEntry>(symbol)(version());
        if (functions == nullptr) {
            return missing(name, path.string() + " belongs to another version of the program",
                           "install forefront-" + name + " of version " + version());
        }
        return functions;
    }
    return missing(name, "was not found",
                   "install the package forefront-" + name + ", or build the program again after apt-get install " +
                       packages);
}

} // namespace forefront
