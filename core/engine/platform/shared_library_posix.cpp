#ifndef _WIN32

#include "core/engine/platform/shared_library.hpp"

#include <dlfcn.h>
#include <system_error>

namespace forefront {

void *loadSharedLibrary(const std::filesystem::path &file, std::string &failure) {
    void *const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
        const char *const text = dlerror(); // NOLINT(concurrency-mt-unsafe): per thread in glibc
        failure = text != nullptr ? text : "unknown reason";
    }
    return library;
}

void *findExport(void *library, const std::string &name) {
    return dlsym(library, name.c_str());
}

std::filesystem::path fileOfCode(const void *place) {
    Dl_info info{};
    if (dladdr(place, &info) == 0 || info.dli_fname == nullptr) {
        return {};
    }
    std::error_code none;
    const std::filesystem::path given = info.dli_fname;
    // A program that was found by PATH has only its name here.
    return std::filesystem::canonical(given.has_parent_path() ? given : std::filesystem::path("/proc/self/exe"), none);
}

} // namespace forefront

#endif
