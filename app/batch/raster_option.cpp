#include "app/batch/raster_option.hpp"

#include "app/batch/coast_notes.hpp"
#include "app/batch/inputs.hpp"
#include "core/engine/spacing/parts/expression/spacing_functions.hpp"
#include "core/engine/spacing/spec/size_presets.hpp"
#include "core/files/elevations.hpp"

#include <memory>
#include <set>
#include <utility>

namespace forefront {

namespace {

/// Returns the name and the file of NAME=FILE; both are empty without them.
std::pair<std::string, std::string> nameAndFile(const std::string &text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals + 1 == text.size()) {
        return {};
    }
    return {text.substr(0, equals), text.substr(equals + 1)};
}

} // namespace

void addRasterOptions(CLI::App &app, CLI::App &group, std::vector<std::string> &rasters,
                      std::vector<std::string> &presets) {
    app.add_option(
           "--raster", rasters,
           "a raster that the expression of the spacing calls by its name: with depth=sea.asc, depth(x,y) is its "
           "bilinear value, depth_x(x,y) and depth_y(x,y) its slopes; an ESRI ASCII grid (.asc) or a GeoTIFF "
           "raster (.tif) with values in the whole domain, up to 2 cells from it; repeatable")
        ->type_name("NAME=FILE")
        ->allow_extra_args(false);
    group
        .add_option(
            "--size-preset", presets,
            "edge length by a rule, in place of --spacing; of several the smallest counts: " + sizePresetHelp() +
                ". max bounds the size, which edges have on average; single edges are longer, by up to about a "
                "half")
        ->type_name("RULE:KEY=VALUE,...")
        ->allow_extra_args(false);
}

std::string checkRasters(const std::vector<std::string> &rasters, const std::vector<std::string> &presets,
                         std::optional<std::string> &expression) {
    std::set<std::string> names;
    for (const std::string &text : rasters) {
        const auto [name, file] = nameAndFile(text);
        if (name.empty()) {
            return "--raster: expected NAME=FILE, such as depth=sea.asc, got '" + text + "'";
        }
        if (const std::string wrong = checkRasterName(name); !wrong.empty()) {
            return "--raster: " + wrong;
        }
        if (!names.insert(name).second) {
            return "--raster: duplicate name '" + name + "'";
        }
    }
    if (presets.empty()) {
        return {};
    }
    const Result<std::string> written = presetExpression(presets);
    if (!written) {
        return "--size-preset: " + written.faults().front().message;
    }
    expression = *written;
    return {};
}

Diagnostics addRasters(const std::vector<std::string> &rasters, const std::string &projection, const MapSystem &map,
                       bool quiet, SpacingSpec &spacing) {
    ImportOptions options;
    options.projection = projection;
    for (const std::string &text : rasters) {
        const auto [name, file] = nameAndFile(text);
        ImportNotes notes;
        Result<Raster> raster = readRaster(file, options, &notes);
        if (!raster) {
            return raster.faults();
        }
        printNotes(notes, quiet);
        printFaults(otherSystem(file, notes.contents().system, map));
        spacing.rasters[name] = std::make_shared<const Raster>(std::move(*raster));
    }
    return {};
}

} // namespace forefront
