#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace forefront {

/// How the names of shared libraries end on this system.
#ifdef _WIN32
inline constexpr std::string_view kSharedLibraryEnd = ".dll";
#else
inline constexpr std::string_view kSharedLibraryEnd = ".so";
#endif

/// Loads a shared library, which stays loaded. Returns null and sets `failure` to the system's reason if it cannot.
void *loadSharedLibrary(const std::filesystem::path &file, std::string &failure);

/// Returns the address of a name that a loaded library exports; null if it exports no such name.
void *findExport(void *library, const std::string &name);

/// Returns the program or shared library that holds the code or data at `place`; empty if it cannot be found.
std::filesystem::path fileOfCode(const void *place);

} // namespace forefront
