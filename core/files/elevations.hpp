#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/spacing/spec/raster.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "core/files/source/import_notes.hpp"
#include "core/files/source/import_options.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

/// Reads the values of an ESRI ASCII grid or a GeoTIFF raster, which may have any sign; ImportOptions::projection
/// converts the latter. Faults as for a grid of sizes, see FormatList::readSpacing().
Result<Raster> readRaster(const std::filesystem::path &path, const ImportOptions &options = {},
                          ImportNotes *notes = nullptr);

/// Returns the values of a raster at the nodes of a mesh, for MeshView::elevations. Fault: no-elevation, with the
/// number of nodes without a value and the place of the first.
Result<std::vector<double>> elevationsOf(const MeshView &mesh, const Raster &raster);
/// Does the same with an expression in x and y. Faults also: expression-syntax, with `column`.
Result<std::vector<double>> elevationsOf(const MeshView &mesh, const std::string &expression);
/// Does the same with an expression that may also call what the expression of a spacing may: its names and rasters, and
/// the distance to the shore of the domain; see SpacingFunctions. Faults also: raster-gap, where a raster that is
/// called has no value in or near a part of the domain.
Result<std::vector<double>> elevationsOf(const MeshView &mesh, const std::string &expression,
                                         const SpacingSpec &spacing, const Domain &domain);

/// Returns the warning "dry-elevations" if all elevations are above 0, as depths with the wrong sign are; for files of
/// water models.
Diagnostics warnOfDryElevations(std::span<const double> elevations);

/// Returns the elevations of the nodes with other numbers, as renumbered() gives them.
std::vector<double> renumberedElevations(std::span<const double> elevations, std::span<const NodeId> numbers);

/// Completes the elevations of the first nodes of a mesh: nodes in the middles of edges and elements that follow get
/// the mean of the corners around them.
void addMiddleElevations(const MeshView &mesh, std::vector<double> &elevations);

} // namespace forefront
