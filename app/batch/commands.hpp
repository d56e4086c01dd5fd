#pragma once

namespace forefront {

/// `forefront mesh ...`; argv[0] is the word "mesh". Returns the exit code.
int meshCommand(int argc, const char *const *argv);

/// `forefront check ...`; argv[0] is the word "check". Returns the exit code.
int checkCommand(int argc, const char *const *argv);

/// `forefront adapt ...`; argv[0] is the word "adapt". Returns the exit code.
int adaptCommand(int argc, const char *const *argv);

/// `forefront tables ...`; argv[0] is the word "tables". Returns the exit code.
int tablesCommand(int argc, const char *const *argv);

} // namespace forefront
