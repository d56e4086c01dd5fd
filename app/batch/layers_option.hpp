#pragma once

#include "app/batch/cli_options.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesher/options.hpp"

#include <string>
#include <vector>

namespace forefront {

/// Boundary layers as on the command line: a part by its name, and the specification without its tag.
struct LayersArgument {
    std::string name;
    LayerSpec spec;
};

/// Adds the option --layers. `texts`: its values.
void addLayersOption(CLI::App &app, std::vector<std::string> &texts);

/// Parses the values of --layers, such as "wing:first=1e-4,growth=1.2,count=20". Returns what is wrong; empty if
/// nothing is.
std::string parseLayers(const std::vector<std::string> &texts, std::vector<LayersArgument> &layers);

/// Gives a job the layers of the command line; those of a project on the same parts are replaced. A name may also be a
/// default name such as boundary_2. Errors: "unknown-boundary", with the list of parts.
Diagnostics applyLayers(const std::vector<LayersArgument> &layers, MeshingJob &job);

} // namespace forefront
