#pragma once

#include "core/files/format.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace forefront::fuzz {

/// Feeds bytes to the readers of one format, to those of lessons and scripts, to the repair of domains, or to a run
/// that meshes.
struct Target {
    const char *name;
    const Format *format;                               ///< null: not a format
    void (*runOther)(std::string_view bytes) = nullptr; ///< what runs instead
    std::size_t inputs = 4000;                          ///< of the tests, shared by its seeds

    /// Aborts if the result breaks a promise: faults without a place, a mesh with bad indices or numbers, a project
    /// that does not survive being written, a repair that is not complete.
    void run(std::string_view bytes) const;
};
/// Returns the targets in the order of the list of formats, then the lessons, the scripts, the repair and the runs.
const std::vector<Target> &targets();
const Target *find(std::string_view name);

/// Returns small inputs for a target: a mesh in its format, if it has a writer, and hand-made ones.
std::vector<std::string> seeds(const Target &target);

} // namespace forefront::fuzz
