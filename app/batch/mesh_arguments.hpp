#pragma once

#include "core/io/inner_edges.hpp"
#include "core/mesher/options.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace forefront {

/// What the command line of `forefront mesh` asks for.
struct MeshArguments {
    std::filesystem::path input;
    std::vector<std::filesystem::path> outputs;
    std::vector<std::string> formats; ///< of the outputs in their order; the rest by extension
    InnerEdges innerEdges = InnerEdges::Keep;
    std::optional<double> size;
    std::optional<std::string> expression;
    std::optional<std::filesystem::path> spacingFile;
    std::optional<double> gradation;
    std::optional<GridKind> grid;
    int gridColumns = 0, gridRows = 0;
    bool keepBoundary = false;
    bool repair = false;
    std::optional<Method> method;
    std::optional<ImproveLevel> improve;
    std::optional<unsigned> threads;
    std::optional<std::filesystem::path> statistics;
    bool quiet = false;

    /// The statistics go to the standard output, which then holds nothing else.
    bool printsStatistics() const { return statistics && *statistics == "-"; }
    std::string format(std::size_t output) const { return output < formats.size() ? formats[output] : std::string(); }
};

/// The arguments, or the exit code with which to leave (help was shown: 0; wrong usage, said on stderr: 2).
std::variant<MeshArguments, int> parseMeshArguments(int argc, const char *const *argv);

} // namespace forefront
