#pragma once

#include "app/batch/cli_options.hpp"
#include "app/batch/crack_option.hpp"
#include "app/batch/elements_option.hpp"
#include "app/batch/layers_option.hpp"
#include "app/batch/outputs.hpp"
#include "app/batch/strip_option.hpp"
#include "core/engine/mesh/limits.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/files/source/picture_sizes.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace forefront {

/// The command line of `forefront mesh`.
struct MeshArguments {
    std::vector<std::filesystem::path> inputs;  ///< "-": standard input
    std::filesystem::path input;                ///< of() sets it
    std::string inputFormat;                    ///< id; empty: by content and extension
    std::vector<std::filesystem::path> outputs; ///< "{}" in a name: the name of the input without its extension
    std::vector<std::string> formats;           ///< ids for the outputs in order; the rest by extension
    MeshForm form;
    std::map<std::string, std::string> parameters; ///< expressions by name, from --set
    std::optional<double> size;
    std::optional<std::string> expression;
    std::vector<std::string> rasters; ///< NAME=FILE
    std::vector<std::string> presets; ///< rules; they set `expression`
    std::optional<std::filesystem::path> spacingFile;
    bool sizeFromBoundary = false;
    std::optional<PictureSizes> pictureSizes; ///< of a picture as spacing file, without its box
    std::optional<Box2> pictureBox;
    std::optional<std::uint64_t> targetElements;
    std::optional<double> gradation;
    std::optional<double> segmentsPerTurn;
    std::optional<double> elementsAcross;
    std::optional<CurveToleranceArgument> curveTolerance;
    std::vector<LayersArgument> layers;
    std::vector<std::string> periodic; ///< values of --periodic
    CrackArguments cracks;
    std::vector<std::string> mapped; ///< values of --mapped
    StripArguments strips;
    std::optional<GridKind> grid;
    int gridColumns = 0, gridRows = 0;
    ElementsArguments elements;
    std::optional<ElementOrder> order;
    std::optional<QuadNodes> quadNodes;
    std::optional<double> leastAngle; ///< degrees
    bool keepBoundary = false;
    bool verify = false;
    bool repair = false;
    DrawingArguments drawing;
    MeshLimits limits; ///< besides those of a project
    bool fix = false;
    bool strict = false;
    std::optional<Method> method;
    std::optional<std::filesystem::path> rules; ///< of the classic method
    std::optional<ImproveLevel> improve;
    std::optional<unsigned> threads;
    std::optional<double> maxElements;
    std::optional<std::filesystem::path> statistics;
    bool dryRun = false; ///< estimate the run instead of meshing
    bool json = false;   ///< print JSON
    bool quiet = false;

    /// Returns true if the statistics go to standard output, which then receives nothing else.
    bool printsStatistics() const { return statistics && *statistics == "-"; }
    /// Returns the arguments for one of the inputs, with its name in those of the outputs.
    MeshArguments of(const std::filesystem::path &file) const;
};

/// Parses the command line. Returns the arguments, or the exit code if the program has to end: 0 after printing help, 2
/// after printing a usage error.
std::variant<MeshArguments, int> parseMeshArguments(const CommandLine &line);

} // namespace forefront
