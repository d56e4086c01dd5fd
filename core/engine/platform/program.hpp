#pragma once

#include <filesystem>
#include <span>
#include <string>

// For the editor, so only on systems that have its window.

namespace forefront {

/// Returns the file of the running program; empty if the system does not tell.
std::filesystem::path programFile();

/// Starts another program in place of this one, with `words` after its name. Returns only on failure, with the reason.
std::string becomeProgram(const std::filesystem::path &program, std::span<const std::string> words);

} // namespace forefront
