#include "app/batch/elevation_option.hpp"

#include "app/batch/coast_notes.hpp"
#include "app/batch/inputs.hpp"
#include "app/batch/output_formats.hpp"
#include "core/engine/base/letter_case.hpp"
#include "core/files/elevations.hpp"

#include <filesystem>

namespace forefront {

namespace {

Result<std::vector<double>> expressionElevations(const std::string &expression, const MeshView &mesh,
                                                 const std::optional<ElevationCalls> &calls) {
    Result<std::vector<double>> values =
        calls ? elevationsOf(mesh, expression, calls->spacing, calls->domain) : elevationsOf(mesh, expression);
    if (values) {
        return values;
    }
    Diagnostics faults = values.faults();
    for (Diagnostic &fault : faults) {
        fault.message = "--elevation: " + fault.message;
    }
    return faults;
}

} // namespace

void addElevationOption(CLI::App &app, std::optional<std::string> &elevation) {
    app.add_option("--elevation", elevation,
                   "elevations of the nodes: an ESRI ASCII grid (.asc), a GeoTIFF raster (.tif), or an expression of x "
                   "and y such as -5-0.01*x, which in mesh may call rasters of the project and of --raster, "
                   "-depth(x,y), as in --spacing; "
                   "depths are the same with the other sign; without it, that of the project; formats: " +
                       idsOf(&FileFormat::holdsElevations))
        ->type_name("FILE|EXPR");
}

std::string checkElevation(const std::optional<std::string> &elevation, const std::vector<Output> &outputs) {
    if (!elevation) {
        return {};
    }
    if (anyHas(outputs, &FileFormat::holdsElevations)) {
        std::error_code none;
        if (isElevationFile(*elevation)) {
            return std::filesystem::exists(*elevation, none) ? "" : "--elevation: file " + *elevation + " not found";
        }
        return {};
    }
    return "--elevation: no output holds elevations; write one of the formats " + idsOf(&FileFormat::holdsElevations);
}

Diagnostics checkElevationExpression(const std::optional<std::string> &elevation,
                                     const std::optional<ElevationCalls> &calls) {
    if (!elevation || isElevationFile(*elevation)) {
        return {};
    }
    const Result<std::vector<double>> compiled = expressionElevations(*elevation, TriMesh(), calls);
    return compiled ? Diagnostics() : compiled.faults();
}

bool isElevationFile(const std::string &elevation) {
    std::error_code none;
    const std::string extension = lowerCase(std::filesystem::path(elevation).extension().string());
    return std::filesystem::exists(elevation, none) || extension == ".asc" || extension == ".tif" ||
           extension == ".tiff";
}

Result<std::vector<double>> readElevations(const std::string &elevation, const MeshView &mesh,
                                           const std::string &projection, const MapSystem &map, bool quiet,
                                           const std::optional<ElevationCalls> &calls) {
    if (!isElevationFile(elevation)) {
        return expressionElevations(elevation, mesh, calls);
    }
    ImportNotes notes;
    ImportOptions options;
    options.projection = projection;
    const Result<Raster> raster = readRaster(elevation, options, &notes);
    if (!raster) {
        return raster.faults();
    }
    printNotes(notes, quiet);
    printFaults(otherSystem(elevation, notes.contents().system, map));
    Result<std::vector<double>> values = elevationsOf(mesh, *raster);
    if (values) {
        return values;
    }
    Diagnostics faults = values.faults();
    for (Diagnostic &fault : faults) {
        fault.file = elevation;
    }
    return faults;
}

} // namespace forefront
