#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace forefront::fuzz {

/// Feeds bytes to one reader, or to the repair; aborts if the result breaks a promise: faults without a place, a mesh
/// with bad indices or numbers, a project that does not survive being written, a repair that leaves something to do.
struct Target {
    const char *name;
    void (*run)(std::string_view bytes);
};
std::span<const Target> targets();
const Target *find(std::string_view name);

/// Returns small valid inputs for a target.
std::vector<std::string> seeds(std::string_view name);

} // namespace forefront::fuzz
