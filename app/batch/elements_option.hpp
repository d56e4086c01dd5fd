#pragma once

#include "app/batch/cli_options.hpp"
#include "core/engine/mesher/options.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

/// The shapes of elements of the command line.
struct ElementsArguments {
    std::optional<Elements> everywhere;                      ///< where no region has others
    std::vector<std::pair<std::string, Elements>> regions{}; ///< by name
    std::vector<std::string> texts{};                        ///< values of --elements
};

/// Adds the option --elements.
void addElementsOption(CLI::App &app, ElementsArguments &arguments);

/// Parses values such as quads and quads:soil. Returns what is wrong; empty if nothing is.
std::string parseElements(ElementsArguments &arguments);

/// Gives a job the shapes of the command line; regions of the input keep theirs unless these name them. Error:
/// "unknown-region", with the list of regions.
Diagnostics applyElements(const ElementsArguments &arguments, MeshingJob &job);

} // namespace forefront
