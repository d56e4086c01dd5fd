#include "core/components/gdal/feature_text.hpp"
#include "core/components/gdal/gdal_readers.hpp"
#include "core/components/gdal/gdal_session.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <array>
#include <cpl_conv.h>
#include <memory>
#include <ogr_api.h>

namespace forefront::gdal {

namespace {

using Feature = std::unique_ptr<void, Releaser<OGR_F_Destroy>>;
using Geometry = std::unique_ptr<void, Releaser<OGR_G_DestroyGeometry>>;
using Transformation = std::unique_ptr<void, Releaser<OCTDestroyCoordinateTransformation>>;

bool isArea(OGRwkbGeometryType given) {
    const OGRwkbGeometryType type = wkbFlatten(given);
    return type == wkbPolygon || type == wkbMultiPolygon || type == wkbCurvePolygon || type == wkbMultiSurface ||
           type == wkbSurface || type == wkbTIN || type == wkbPolyhedralSurface || type == wkbTriangle;
}

/// Returns true if a layer has areas; looks for one where the layer may have geometries of any type.
bool hasAreas(OGRLayerH layer) {
    const OGRwkbGeometryType type = wkbFlatten(OGR_L_GetGeomType(layer));
    if (type != wkbUnknown && type != wkbGeometryCollection) {
        return isArea(type);
    }
    OGR_L_ResetReading(layer);
    for (Feature feature(OGR_L_GetNextFeature(layer)); feature != nullptr; feature.reset(OGR_L_GetNextFeature(layer))) {
        OGRGeometryH const geometry = OGR_F_GetGeometryRef(feature.get());
        if (geometry != nullptr && isArea(OGR_G_GetGeometryType(geometry))) {
            return true;
        }
    }
    return false;
}

/// Reads the layers of a map one after the other into one text.
class MapText {
  public:
    MapText(Session &session, const GdalFile &file, std::size_t maximum, GdalMap &map)
        : session_(session), file_(file), maximum_(maximum), map_(map) {}

    bool read(GDALDatasetH set, const std::optional<std::string> &wanted) {
        std::vector<OGRLayerH> layers;
        for (int k = 0; k < GDALDatasetGetLayerCount(set); ++k) {
            OGRLayerH const layer = GDALDatasetGetLayer(set, k);
            if (OGR_L_GetGeomType(layer) != wkbNone) {
                layers.push_back(layer);
                map_.layers.emplace_back(OGR_L_GetName(layer));
            }
        }
        std::vector<std::size_t> chosen;
        if (layers.empty()) {
            return session_.fail("no layer of the file has geometries");
        }
        if (!choose(layers, wanted, chosen)) {
            return false;
        }
        for (const std::size_t k : chosen) {
            map_.read.push_back(map_.layers[k]);
            if (!readLayer(layers[k]) || (map_.read.size() == 1 && !convertPlaces())) {
                return false;
            }
        }
        map_.geoJson = "{\"type\":\"FeatureCollection\"," + system_ + "\"features\":[" + features_ + "]}";
        return true;
    }

  private:
    bool choose(const std::vector<OGRLayerH> &layers, const std::optional<std::string> &wanted,
                std::vector<std::size_t> &chosen) {
        if (!wanted) {
            const auto first = std::find_if(layers.begin(), layers.end(), hasAreas);
            chosen.push_back(first != layers.end() ? static_cast<std::size_t>(first - layers.begin()) : 0);
            return true;
        }
        std::string rest = *wanted;
        const auto find = [&](const std::string &name) {
            const auto found = std::find(map_.layers.begin(), map_.layers.end(), name);
            if (found != map_.layers.end()) {
                chosen.push_back(static_cast<std::size_t>(found - map_.layers.begin()));
            }
            return found != map_.layers.end();
        };
        if (find(rest)) { // perhaps with a comma in its name
            return true;
        }
        while (!rest.empty()) {
            const std::string name = rest.substr(0, rest.find(','));
            rest.erase(0, name.size() + 1);
            if (!find(name)) {
                std::string known;
                for (const std::string &layer : map_.layers) {
                    known += (known.empty() ? "" : ", ") + layer;
                }
                return session_.fail("no layer '" + name + "'", "expected one of " + known);
            }
        }
        return true;
    }

    /// Finds out how the coordinates of a layer are converted, and names the reference system of the text: longitudes
    /// and latitudes as such, whatever the ellipsoid is.
    bool prepare(OGRLayerH layer) {
        OGRSpatialReferenceH const own = OGR_L_GetSpatialRef(layer);
        ReferenceSystem target;
        transformation_.reset();
        if (!file_.projection.empty()) {
            if (own == nullptr) {
                return session_.fail("the layer '" + std::string(OGR_L_GetName(layer)) +
                                         "' names no coordinate reference system to convert from",
                                     "name it, for example with ogr2ogr -a_srs EPSG:n NEW FILE");
            }
            target = session_.named(file_.projection);
            if (target == nullptr) {
                return false;
            }
            const ReferenceSystem source(OSRClone(own));
            OSRSetAxisMappingStrategy(source.get(), OAMS_TRADITIONAL_GIS_ORDER);
            if (OSRIsSame(source.get(), target.get()) == 0) {
                transformation_.reset(OCTNewCoordinateTransformation(source.get(), target.get()));
                if (transformation_ == nullptr) {
                    return session_.fail("cannot convert coordinates to " + file_.projection);
                }
            }
        }
        const std::string system = systemText(target != nullptr ? target.get() : own);
        if (map_.read.size() > 1 && system != system_) {
            return session_.fail("the layers have different coordinate reference systems",
                                 "convert them to one with --projection EPSG:n");
        }
        system_ = system;
        describe(target != nullptr ? target.get() : own);
        return true;
    }

    /// Records the code and the well-known text of the reference system.
    void describe(OGRSpatialReferenceH system) {
        const char *const authority = system != nullptr ? OSRGetAuthorityName(system, nullptr) : nullptr;
        const char *const code = system != nullptr ? OSRGetAuthorityCode(system, nullptr) : nullptr;
        map_.systemCode = authority != nullptr && code != nullptr ? std::string(authority) + ':' + code : std::string();
        map_.systemWkt.clear();
        char *text = nullptr;
        const std::array<const char *, 3> options{"FORMAT=WKT2_2019", "MULTILINE=NO", nullptr};
        if (system != nullptr && OSRExportToWktEx(system, &text, options.data()) == OGRERR_NONE && text != nullptr) {
            map_.systemWkt = text;
        }
        CPLFree(text);
    }

    static std::string systemText(OGRSpatialReferenceH system) {
        if (system == nullptr) {
            return {};
        }
        std::string name = "urn:ogc:def:crs:OGC:1.3:CRS84";
        if (OSRIsGeographic(system) == 0) {
            const char *const authority = OSRGetAuthorityName(system, nullptr);
            const char *const code = OSRGetAuthorityCode(system, nullptr);
            const char *const given = OSRGetName(system);
            name = authority != nullptr && code != nullptr ? "urn:ogc:def:crs:" + std::string(authority) + "::" + code
                                                           : std::string(given != nullptr ? given : "unknown");
        }
        return "\"crs\":{\"type\":\"name\",\"properties\":{\"name\":" + jsonString(name) + "}},";
    }

    /// Converts the given places like the layer that was read last.
    bool convertPlaces() {
        map_.places = file_.places;
        for (Vec2 &place : map_.places) {
            const std::string given = placeText(place);
            if (transformation_ != nullptr &&
                (OCTTransform(transformation_.get(), 1, &place.x, &place.y, nullptr) == FALSE || !isFinite(place))) {
                return session_.fail("the place " + given + " cannot be converted to " + file_.projection,
                                     "give places in the coordinates of the map");
            }
        }
        return true;
    }

    bool readLayer(OGRLayerH layer) {
        if (!prepare(layer)) {
            return false;
        }
        OGR_L_ResetReading(layer);
        for (Feature feature(OGR_L_GetNextFeature(layer)); feature != nullptr;
             feature.reset(OGR_L_GetNextFeature(layer))) {
            if (!addFeature(feature.get())) {
                return false;
            }
            if (features_.size() > maximum_) {
                return session_.fail("the features need more than " + std::to_string(maximum_) + " bytes as text");
            }
        }
        return true;
    }

    bool addFeature(OGRFeatureH feature) {
        features_ += features_.empty() ? "" : ",\n";
        features_ += "{\"type\":\"Feature\",\"properties\":";
        appendProperties(feature, features_);
        features_ += ",\"geometry\":";
        OGRGeometryH const given = OGR_F_GetGeometryRef(feature);
        if (given == nullptr || OGR_G_IsEmpty(given) != 0) {
            features_ += "null}";
            return true;
        }
        // Curves become lines in steps of 4 degrees, which is GDAL's own choice; surfaces become polygons.
        Geometry geometry(OGR_G_GetLinearGeometry(given, 0.0, nullptr));
        const OGRwkbGeometryType type = wkbFlatten(OGR_G_GetGeometryType(geometry.get()));
        if (type == wkbTriangle || type == wkbTIN || type == wkbPolyhedralSurface) {
            geometry.reset(OGR_G_ForceToMultiPolygon(geometry.release()));
        }
        const std::string number = std::to_string(OGR_F_GetFID(feature));
        if (transformation_ != nullptr && OGR_G_Transform(geometry.get(), transformation_.get()) != OGRERR_NONE) {
            return session_.fail("feature " + number + " cannot be converted to " + file_.projection);
        }
        if (!appendGeometry(geometry.get(), features_)) {
            return session_.fail("feature " + number + " has coordinates that are not finite, or a geometry of type " +
                                 OGR_G_GetGeometryName(geometry.get()));
        }
        features_ += '}';
        return true;
    }

    Session &session_;
    const GdalFile &file_;
    std::size_t maximum_;
    GdalMap &map_;
    Transformation transformation_;
    std::string system_; ///< member "crs", with a comma; empty: unknown
    std::string features_;
};

} // namespace

bool readMap(const GdalFile &file, const std::optional<std::string> &layers, std::size_t maximum, GdalMap &map,
             GdalReport &report) {
    Session session(report);
    const Dataset set = session.open(file, GDAL_OF_VECTOR);
    return set != nullptr && MapText(session, file, maximum, map).read(set.get(), layers);
}

} // namespace forefront::gdal
