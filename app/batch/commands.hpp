#pragma once

namespace forefront {

/// Runs `forefront mesh ...` and returns the exit code; argv[0] is the word "mesh".
int meshCommand(int argc, const char *const *argv);

/// Runs `forefront check ...` and returns the exit code; argv[0] is the word "check".
int checkCommand(int argc, const char *const *argv);

/// Runs `forefront adapt ...` and returns the exit code; argv[0] is the word "adapt".
int adaptCommand(int argc, const char *const *argv);

/// Runs `forefront convert ...` and returns the exit code; argv[0] is the word "convert".
int convertCommand(int argc, const char *const *argv);

/// Runs `forefront info ...` and returns the exit code; argv[0] is the word "info".
int infoCommand(int argc, const char *const *argv);

/// Runs `forefront formats ...` and returns the exit code; argv[0] is the word "formats".
int formatsCommand(int argc, const char *const *argv);

/// Runs `forefront film ...` and returns the exit code; argv[0] is the word "film".
int filmCommand(int argc, const char *const *argv);

/// Runs `forefront tables ...` and returns the exit code; argv[0] is the word "tables".
int tablesCommand(int argc, const char *const *argv);

/// Runs `forefront rules ...` and returns the exit code; argv[0] is the word "rules".
int rulesCommand(int argc, const char *const *argv);

/// Runs `forefront trace ...` and returns the exit code; argv[0] is the word "trace".
int traceCommand(int argc, const char *const *argv);

/// Runs `forefront run ...` and returns the exit code; argv[0] is the word "run".
int runCommand(int argc, const char *const *argv);

} // namespace forefront
