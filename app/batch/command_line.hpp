#pragma once

namespace forefront {

struct CommandInfo;

/// The words of a command, or a request to describe its options instead of running it.
struct CommandLine {
    int argc = 0;
    const char *const *argv = nullptr; ///< argv[0] is the name of the command
    CommandInfo *info = nullptr;       ///< if not null, parseOptions() fills it in and ends the command
};

} // namespace forefront
