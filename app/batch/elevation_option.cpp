#include "app/batch/elevation_option.hpp"

#include "app/batch/inputs.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/base/letter_case.hpp"
#include "core/files/elevations.hpp"

#include <algorithm>
#include <filesystem>

namespace forefront {

namespace {

std::string formatsWithElevations() {
    std::string list;
    for (const FileFormat &format : allFormats().list()) {
        if (format.holdsElevations) {
            list += (list.empty() ? "" : ", ") + std::string(format.id);
        }
    }
    return list;
}

bool holdsElevations(const Output &output) {
    if (!output.format.empty()) {
        return allFormats().withId(output.format)->holdsElevations;
    }
    for (const FileFormat *format : allFormats().withExtensionOf(output.path)) {
        if (format->writesMesh) {
            return format->holdsElevations;
        }
    }
    return false;
}

} // namespace

void addElevationOption(CLI::App &app, std::optional<std::string> &elevation) {
    app.add_option("--elevation", elevation,
                   "elevations of the nodes: an ESRI ASCII grid (.asc), a GeoTIFF raster (.tif), or an expression of x "
                   "and y such as -5-0.01*x; "
                   "depths are the same with the other sign; formats: " +
                       formatsWithElevations())
        ->type_name("FILE|EXPR");
}

std::string checkElevation(const std::optional<std::string> &elevation, const std::vector<Output> &outputs) {
    if (!elevation) {
        return {};
    }
    if (std::any_of(outputs.begin(), outputs.end(), holdsElevations)) {
        std::error_code none;
        if (isElevationFile(*elevation)) {
            return std::filesystem::exists(*elevation, none) ? "" : "--elevation: file " + *elevation + " not found";
        }
        const Result<std::vector<double>> compiled = elevationsOf(TriMesh(), *elevation);
        return compiled ? "" : "--elevation: " + compiled.faults().front().message;
    }
    return "--elevation: no output holds elevations; write one of the formats " + formatsWithElevations();
}

bool isElevationFile(const std::string &elevation) {
    std::error_code none;
    const std::string extension = lowerCase(std::filesystem::path(elevation).extension().string());
    return std::filesystem::exists(elevation, none) || extension == ".asc" || extension == ".tif" ||
           extension == ".tiff";
}

Result<std::vector<double>> readElevations(const std::string &elevation, const MeshView &mesh,
                                           const std::string &projection, bool quiet) {
    if (!isElevationFile(elevation)) {
        Result<std::vector<double>> values = elevationsOf(mesh, elevation);
        if (values) {
            return values;
        }
        Diagnostics faults = values.faults();
        for (Diagnostic &fault : faults) {
            fault.message = "--elevation: " + fault.message;
        }
        return faults;
    }
    ImportNotes notes;
    ImportOptions options;
    options.projection = projection;
    const Result<Raster> raster = readRaster(elevation, options, &notes);
    if (!raster) {
        return raster.faults();
    }
    printNotes(notes, quiet);
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
