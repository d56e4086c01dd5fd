#include "core/drawing_files/geojson/gdal_map.hpp"

#include "core/drawing_files/geojson/geojson.hpp"
#include "core/drawing_files/geojson/kml_models.hpp"
#include "core/drawing_files/geojson/topojson.hpp"
#include "core/files/common/names.hpp"
#include "core/files/components/gdal_source.hpp"
#include "core/files/foreign_files.hpp"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

using namespace std::string_view_literals;

/// Passes the notes on the text that GDAL made on, without their places in it.
void passOn(const ImportNotes &notes, const GdalMap &map, const SourceText &source) {
    if (source.notes == nullptr) {
        return;
    }
    for (const ImportNote &note : notes.entries()) {
        if (note.code == "crs" && !source.options.projection.empty()) {
            continue; // the text is in the system that was asked for
        }
        source.notes->add(note.code, note.message, source.name, source.text, 0, note.count, note.severity);
    }
    DrawingContents contents = notes.contents();
    contents.layers = map.layers;
    contents.severalLayers = map.layers.size() > 1;
    contents.layer = {};
    for (const std::string &layer : map.read) {
        contents.layer += (contents.layer.empty() ? "" : ",") + layer;
    }
    if (!contents.system.centre) {
        contents.system.code = map.systemCode;
        contents.system.wkt = map.systemWkt;
    }
    source.notes->setContents(contents);
    if (!source.options.layer && map.layers.size() > map.read.size()) {
        std::vector<std::string> others;
        std::copy_if(map.layers.begin(), map.layers.end(), std::back_inserter(others),
                     [&](const std::string &layer) { return layer != map.read.front(); });
        constexpr std::size_t kShown = 8;
        source.note("layers",
                    "only the layer '" + cleanName(map.read.front()) + "' is read, not " + listed(others, kShown) +
                        "; --layer chooses",
                    0);
    }
}

Result<DomainFile> readByGdal(const SourceText &source, std::initializer_list<const char *> drivers) {
    const Result<const GdalFunctions *> gdal = gdalComponent();
    if (!gdal) {
        return gdal.faults();
    }
    GdalMap map;
    GdalReport report;
    GdalSource file(source, drivers);
    for (const PartName &part : source.options.partNames) {
        file.file.places.insert(file.file.places.end(), {part.from, part.to});
    }
    if (!(*gdal)->readMap(file.file, source.options.layer, source.options.maxBytes, map, report)) {
        return gdalFailure(report);
    }
    noteWarnings(report, source);
    ImportNotes notes;
    SourceText text{map.geoJson, source.name, {}, source.options};
    text.options.layer.reset();
    for (std::size_t k = 0; k < text.options.partNames.size(); ++k) {
        text.options.partNames[k].from = map.places[2 * k];
        text.options.partNames[k].to = map.places[2 * k + 1];
    }
    text.notes = &notes;
    Result<DomainFile> read = readGeoJsonFile(text);
    passOn(notes, map, source);
    if (read) {
        return read;
    }
    Diagnostics faults = read.faults();
    for (Diagnostic &fault : faults) {
        fault.line = fault.column = 0; // of a text that the user does not have
    }
    return faults;
}

} // namespace

Result<DomainFile> readShapefile(const SourceText &source) {
    if (source.path.empty()) {
        return error("cannot-read", "a shapefile is several files, .shp, .shx and .dbf",
                     "read it from its folder, not from memory or standard input");
    }
    return readByGdal(source, {"ESRI Shapefile"});
}

Result<DomainFile> readGeoPackage(const SourceText &source) {
    return readByGdal(source, {"GPKG"});
}

Result<DomainFile> readKml(const SourceText &source) {
    const KmlWithoutModels kml = withoutModels(source.text);
    if (kml.models == 0) {
        return readByGdal(source, {"LIBKML", "KML"});
    }
    source.note("kml-model", "3D models are left out: the domain is planar", 0, kml.models);
    SourceText plain = source;
    plain.text = kml.text;
    plain.path.clear(); // read from memory
    return readByGdal(plain, {"LIBKML", "KML"});
}

Result<DomainFile> readFlatGeobuf(const SourceText &source) {
    return readByGdal(source, {"FlatGeobuf"});
}

Result<DomainFile> readGeoJsonMap(const SourceText &source) {
    return source.options.projection.empty() ? readGeoJsonFile(source) : readByGdal(source, {"GeoJSON", "GeoJSONSeq"});
}

Result<DomainFile> readTopoJsonMap(const SourceText &source) {
    return source.options.projection.empty() ? readTopoJsonFile(source) : readByGdal(source, {"TopoJSON"});
}

bool looksLikeShapefile(std::string_view head) {
    return head.starts_with("\0\0\x27\x0a"sv);
}

bool looksLikeGeoPackage(std::string_view head) {
    constexpr std::size_t kApplication = 68; // byte of the number of the application in SQLite
    return head.starts_with("SQLite format 3\0"sv) && head.size() > kApplication &&
           head.substr(kApplication).starts_with("GP");
}

bool looksLikeKml(std::string_view head) {
    return rootElement(head) == "kml";
}

bool looksLikeFlatGeobuf(std::string_view head) {
    return head.starts_with("fgb\x03"
                            "fgb"sv);
}

} // namespace forefront
