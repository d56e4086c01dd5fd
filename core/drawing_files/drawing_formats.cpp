#include "core/drawing_files/drawing_formats.hpp"

#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/dxf/dxf.hpp"
#include "core/drawing_files/geojson/gdal_map.hpp"
#include "core/drawing_files/geojson/geojson.hpp"
#include "core/drawing_files/geojson/topojson.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/drawing_files/svg/svg.hpp"
#include "core/drawing_files/wkt/wkt.hpp"
#include "core/engine/domain/chains/chain_order.hpp"
#include "core/files/format.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {
namespace {

void reorder(std::vector<PartOrigin> &origins, const std::vector<std::uint32_t> &order) {
    const std::vector<PartOrigin> known = std::exchange(origins, {});
    origins.reserve(order.size());
    for (const std::uint32_t number : order) {
        origins.push_back(number < known.size() ? known[number] : PartOrigin{});
    }
}

/// Reads a drawing or map, and orders its segments by chains as the editor does, so that it meshes the same in the
/// editor and in batch.
Result<DomainFile> inDrawnOrder(const SourceText &source, DomainFile file) {
    ChainOrder order;
    file.domain = inChainOrder(file.domain, &order);
    if (source.origin != nullptr) {
        reorder(source.origin->of(DomainPartKind::Node), order.nodes);
        reorder(source.origin->of(DomainPartKind::Segment), order.segments);
        reorder(source.origin->of(DomainPartKind::ConstraintPoint), order.points);
    }
    return file; // its sizes belong to places
}

template <Result<Domain> (*Read)(const SourceText &)>
Result<DomainFile> readInChainOrder(const SourceText &source) {
    LengthUnit unit = LengthUnit::None;
    SourceText measured = source;
    measured.unit = &unit;
    Result<Domain> domain = Read(measured);
    return domain ? inDrawnOrder(source, DomainFile{std::move(*domain), {}, unit}) : domain.faults();
}

template <Result<DomainFile> (*Read)(const SourceText &)>
Result<DomainFile> readMapInChainOrder(const SourceText &source) {
    Result<DomainFile> file = Read(source);
    return file ? inDrawnOrder(source, std::move(*file)) : file.faults();
}

Result<DomainFile> readProjectDomain(const SourceText &source) {
    const auto document = readProjectText(source);
    if (!document) {
        return document.faults();
    }
    Result<MeshingJob> job = readJobOf(*document, source.name, source.notes);
    if (!job) {
        return job.faults();
    }
    return DomainFile{std::move(job->domain), std::move(job->spacing),  document->unit,
                      std::move(job->cracks), std::move(job->periodic), std::move(job->mapped),
                      std::move(job->strips), std::move(job->layers),   std::move(job->regionElements)};
}

/// Returns the description of a map that the component forefront-gdal reads.
constexpr Format gdalMap(const char *id, const char *name, const char *extension, bool layers,
                         bool (*recognise)(std::string_view), Result<DomainFile> (*read)(const SourceText &)) {
    return {.about = {.id = id,
                      .name = name,
                      .extension = extension,
                      .kind = FileKind::Map,
                      .readsDomain = true,
                      .hasLayers = layers,
                      .arranges = true,
                      .component = "gdal"},
            .recognise = recognise,
            .readDomain = read};
}

// The formats of drawings with their names, capabilities and functions, in the order of menus.
constexpr std::array kDrawings = {
    Format{.about = {.id = "project",
                     .name = "Forefront project",
                     .extension = ".json",
                     .otherExtensions = ".forefront",
                     .kind = FileKind::Project,
                     .readsDomain = true,
                     .readsSpacing = true},
           .recognise = looksLikeProject,
           .readDomain = readProjectDomain,
           .readSpacing = readProjectSpacing},
    Format{.about = {.id = "geojson",
                     .name = "GeoJSON",
                     .extension = ".geojson",
                     .otherExtensions = ".json",
                     .kind = FileKind::Map,
                     .readsDomain = true,
                     .arranges = true},
           .recognise = looksLikeGeoJson,
           .mayShowLate = true,
           .readDomain = readMapInChainOrder<readGeoJsonMap>},
    Format{.about = {.id = "topojson",
                     .name = "TopoJSON",
                     .extension = ".topojson",
                     .otherExtensions = ".json",
                     .kind = FileKind::Map,
                     .readsDomain = true,
                     .hasLayers = true,
                     .arranges = true},
           .recognise = looksLikeTopoJson,
           .mayShowLate = true,
           .readDomain = readMapInChainOrder<readTopoJsonMap>},
    Format{.about = {.id = "wkt",
                     .name = "well-known text",
                     .extension = ".wkt",
                     .kind = FileKind::Domain,
                     .readsDomain = true,
                     .arranges = true},
           .recognise = looksLikeWkt,
           .readDomain = readInChainOrder<readWkt>},
    gdalMap("shapefile", "ESRI shapefile", ".shp", false, looksLikeShapefile, readMapInChainOrder<readShapefile>),
    gdalMap("gpkg", "GeoPackage", ".gpkg", true, looksLikeGeoPackage, readMapInChainOrder<readGeoPackage>),
    gdalMap("kml", "KML", ".kml", true, looksLikeKml, readMapInChainOrder<readKml>),
    gdalMap("flatgeobuf", "FlatGeobuf", ".fgb", false, looksLikeFlatGeobuf, readMapInChainOrder<readFlatGeobuf>),
};

/// Returns the formats of drawings, then those of the engine. SVG and DXF are among both: the drawing library reads
/// them.
std::vector<Format> everyFormat() {
    std::vector<Format> list(kDrawings.begin(), kDrawings.end());
    for (Format format : engineFormats().formats()) {
        if (format.about.kind == FileKind::Drawing) {
            format.about.readsDomain = format.about.readsCurves = format.about.arranges = true;
            format.recognise = looksLikeSvg;
            format.readDomain = readInChainOrder<readSvg>;
        }
        if (format.about.id == std::string_view("dxf")) {
            format.about.readsDomain = format.about.readsCurves = true;
            format.about.hasLayers = format.about.arranges = true;
            format.recognise = looksLikeDxf;
            format.readDomain = readInChainOrder<readDxf>;
        }
        list.push_back(format);
    }
    return list;
}

} // namespace

const FormatList &allFormats() {
    static const std::vector<Format> kFormats = everyFormat();
    static const FormatList kList(kFormats);
    return kList;
}

} // namespace forefront
