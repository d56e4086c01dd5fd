#include "core/engine/platform/program.hpp"

#ifndef _WIN32

#include <cerrno>
#include <cstring>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace forefront {

std::filesystem::path programFile() {
    std::error_code ignored;
    return std::filesystem::read_symlink("/proc/self/exe", ignored);
}

std::string becomeProgram(const std::filesystem::path &program, std::span<const std::string> words) {
    std::vector<std::string> copies = {program.string()};
    copies.insert(copies.end(), words.begin(), words.end());
    std::vector<char *> pointers;
    for (std::string &word : copies) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    ::execv(program.c_str(), pointers.data());
    return std::strerror(errno);
}

} // namespace forefront

#endif
