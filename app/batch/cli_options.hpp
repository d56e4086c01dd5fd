#pragma once

#include "app/batch/command_line.hpp"
#include "app/batch/outputs.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/files/source/import_options.hpp"
#include "core/files/source/overlap_rule.hpp"
#include "core/files/source/picture_sizes.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// Validators for option values. Their messages read "--size: expected a positive number, got 'abc'".
CLI::Validator positiveNumber();
CLI::Validator nonNegativeNumber();
CLI::Validator numberWithin(double minimum, double maximum);
CLI::Validator wholeNumberWithin(int minimum, int maximum);
CLI::Validator oneOf(std::span<const std::string_view> words);

/// Returns the number that is the whole of a text, with or without a sign; nothing for any other text.
std::optional<double> numberIn(std::string_view text);

/// Adds an option whose value is a word of an enumeration. `Value` is the enumeration or a std::optional of it.
template <class Enum, class Value>
CLI::Option *addWordOption(CLI::App &app, const std::string &name, Value &value, const std::string &help) {
    return app
        .add_option_function<std::string>(
            name, [&value](const std::string &word) { value = *fromWord<Enum>(word); }, help)
        ->check(oneOf(wordsOf<Enum>()));
}

/// Adds the options --size and --spacing, which several commands share.
void addSpacingOptions(CLI::App &group, std::optional<double> &size, std::optional<std::string> &expression);

/// Replaces the rules of a spacing by --size or --spacing, if given. Returns true if it did.
bool applySpacingOptions(std::optional<double> size, const std::optional<std::string> &expression,
                         SpacingSpec &spacing);

/// Adds an option for a rectangle, given by its lower left and upper right corner.
CLI::Option *addBoxOption(CLI::App &app, const std::string &name, const std::string &meaning, std::optional<Box2> &box);
/// Adds the options --picture-sizes and --picture-box of a picture that is read as spacing.
void addPictureOptions(CLI::App &app, std::optional<PictureSizes> &sizes, std::optional<Box2> &box);

/// Adds the option --input-format; `input` is the word for the input in the help text.
void addInputFormatOption(CLI::App &app, const std::string &input, std::string &formatId);

/// Adds the options of the commands that write meshes: --output, which is returned, --format, --inner-edges and
/// --numbering.
CLI::Option *addOutputOptions(CLI::App &app, std::vector<std::filesystem::path> &outputs,
                              std::vector<std::string> &formats, MeshForm &form);

/// Adds --max-elements.
void addMaxElementsOption(CLI::App &app, std::optional<double> &maxElements);
/// Sets the limit that was given, if any.
void applyMaxElements(std::optional<double> maxElements, MeshingOptions &options);

/// Adds --set, which may be repeated with other names: expressions for parameters of a project.
void addParameterOption(CLI::App &app, std::map<std::string, std::string> &parameters);

/// The maximum distance of curves from their edges, from the command line.
struct CurveToleranceArgument {
    double value = 0.0;   ///< > 0
    bool percent = false; ///< `value` is a percentage of the domain's diagonal; otherwise a length in domain units

    /// Returns the distance for a domain with this diagonal, in domain units.
    double distance(double diagonal) const { return percent ? 0.01 * value * diagonal : value; }
};
/// Adds --curve-tolerance.
void addCurveToleranceOption(CLI::App &app, std::optional<CurveToleranceArgument> &tolerance);

/// How a drawing or map is read; see ImportOptions.
struct DrawingArguments {
    std::optional<double> weldTolerance; ///< absent: the default of the input's format
    std::optional<OverlapRule> overlap;  ///< of a map
    DegreeRule degrees = DegreeRule::Warn;
    std::string projection;                                       ///< such as "EPSG:3067"; empty: none but `degrees`
    std::optional<std::string> layer, nameProperty, sizeProperty; ///< of a map
    bool beyondPage = false;
    bool dropLines = false;
    bool strokeAreas = false;
    bool shapeRegions = false;
    std::optional<bool> whiteHoles;
    std::vector<PartName> partNames; ///< of a map in its coordinates, else in those of the domain

    void applyTo(ImportOptions &options) const;
    /// Returns the name of the first option given, such as "--weld"; empty if none is.
    std::string firstGiven() const;
    friend bool operator==(const DrawingArguments &, const DrawingArguments &) = default;
};
/// Sets the projection to "local" or a code such as "EPSG:3067". Returns what is wrong with it; empty if nothing is.
std::string setProjection(const std::string &word, DrawingArguments &arguments);
/// Adds the options --weld, --overlap, --layer, --name-property, --size-property, --projection, --allow-degrees,
/// --beyond-page, --drop-lines, --stroke-areas, --shape-regions and --name.
void addDrawingOptions(CLI::App &app, DrawingArguments &arguments);

/// Adds --config, a file of options, which parseOptions() reads.
void addConfigOption(CLI::App &app);

/// Parses the command line, or describes the options if that is asked for. Returns std::nullopt to continue, or the
/// exit code if the program has to end: 0 after printing help, 2 after printing a usage error.
std::optional<int> parseOptions(CLI::App &app, const CommandLine &line);

/// Prints the usage error of `command` ("forefront mesh") to stderr and returns the exit code.
int wrongUsage(const std::string &command, std::string_view message);

} // namespace forefront
