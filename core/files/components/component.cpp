#include "core/files/components/component.hpp"

#include "core/engine/base/version.hpp"

#include <cstdlib>
#include <dlfcn.h>
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
    Dl_info info{};
    if (dladdr(&kPlace, &info) == 0 || info.dli_fname == nullptr) {
        return {};
    }
    std::error_code none;
    const std::filesystem::path given = info.dli_fname;
    // A program that was found by PATH has only its name here.
    const std::filesystem::path file =
        std::filesystem::canonical(given.has_parent_path() ? given : std::filesystem::path("/proc/self/exe"), none);
    return file.parent_path();
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

/// Returns the text of the last failure to load a library.
std::string loadingFailure() {
    const char *const text = dlerror(); // NOLINT(concurrency-mt-unsafe): per thread in glibc
    return text != nullptr ? text : "unknown reason";
}

} // namespace

Result<const void *> loadComponent(const std::string &name, const std::string &packages) {
    const std::string file = "forefront-" + name + ".so";
    for (const std::filesystem::path &folder : componentFolders()) {
        const std::filesystem::path path = folder / file;
        std::error_code none;
        if (!std::filesystem::is_regular_file(path, none)) {
            continue;
        }
        void *const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (library == nullptr) {
            return missing(name, "cannot be loaded: " + loadingFailure(), "on Debian: apt-get install " + packages);
        }
        void *const symbol = dlsym(library, ("forefront_" + name).c_str());
        if (symbol == nullptr) {
            return missing(name, path.string() + " is something else", "reinstall forefront-" + name);
        }
        // POSIX has functions converted like this. NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast)
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
