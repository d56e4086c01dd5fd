#pragma once

#include "app/batch/outputs.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// Adds --elevation.
void addElevationOption(CLI::App &app, std::optional<std::string> &elevation);

/// What the expression of --elevation may call besides x and y: the rasters of a spacing, and the shore of a domain.
struct ElevationCalls {
    const SpacingSpec &spacing;
    const Domain &domain;
};

/// Returns the error of an elevation that no output can hold, or of its file that does not exist; empty if there is
/// none.
std::string checkElevation(const std::optional<std::string> &elevation, const std::vector<Output> &outputs);

/// Returns the faults in the expression of an elevation: expression-syntax, such as for a name that it cannot call, and
/// raster-gap; empty if there are none.
Diagnostics checkElevationExpression(const std::optional<std::string> &elevation,
                                     const std::optional<ElevationCalls> &calls = {});

/// Returns true if the value of --elevation names a file: one that exists, or a name that ends in .asc or .tif.
bool isElevationFile(const std::string &elevation);

/// Returns the elevations of the nodes of a mesh by the value of --elevation; prints the notes of its file.
/// `projection`: the reference system of the mesh, see ImportOptions::projection.
Result<std::vector<double>> readElevations(const std::string &elevation, const MeshView &mesh,
                                           const std::string &projection, const MapSystem &map, bool quiet,
                                           const std::optional<ElevationCalls> &calls = {});

} // namespace forefront
