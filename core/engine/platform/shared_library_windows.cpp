#ifdef _WIN32

#include "core/engine/platform/shared_library.hpp"

#include <system_error>
#include <windows.h>

namespace forefront {

void *loadSharedLibrary(const std::filesystem::path &file, std::string &failure) {
    const HMODULE library = LoadLibraryW(file.c_str());
    if (library == nullptr) {
        failure = std::system_category().message(static_cast<int>(GetLastError()));
    }
    return static_cast<void *>(library);
}

void *findExport(void *library, const std::string &name) {
    const FARPROC found = GetProcAddress(static_cast<HMODULE>(library), name.c_str());
    return reinterpret_cast<void *>(found);
}

std::filesystem::path fileOfCode(const void *place) {
    constexpr DWORD kFlags = GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT;
    HMODULE module = nullptr;
    if (GetModuleHandleExW(kFlags, static_cast<const wchar_t *>(place), &module) == 0) {
        return {};
    }
    constexpr DWORD kMaxPath = 32768; // of Windows, in characters
    std::wstring name(kMaxPath, L'\0');
    name.resize(GetModuleFileNameW(module, name.data(), kMaxPath));
    return name;
}

} // namespace forefront

#endif
