#pragma once

namespace forefront {

/// `forefront mesh ...`; argv[0] is the word "mesh". Returns the exit code.
int meshCommand(int argc, const char *const *argv);

/// `forefront check ...`; argv[0] is the word "check". Returns the exit code.
int checkCommand(int argc, const char *const *argv);

} // namespace forefront
