#include "core/files/ugrid/ugrid_system.hpp"

#include "core/engine/base/number_text.hpp"

#include <charconv>
#include <string_view>

namespace forefront {

namespace {

/// Returns the well-known text of a local projection; version 1, which all readers know.
std::string localWkt(Vec2 centre) {
    const std::string radius = exactText(kEarthRadius);
    return "PROJCS[\"Azimuthal equidistant about " + exactText(centre.x) + " " + exactText(centre.y) +
           "\",GEOGCS[\"Sphere\",DATUM[\"Sphere with the mean radius of the Earth\",SPHEROID[\"Sphere\"," + radius +
           ",0]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],PROJECTION[\"Azimuthal_Equidistant\"],"
           "PARAMETER[\"latitude_of_center\"," +
           exactText(centre.y) + "],PARAMETER[\"longitude_of_center\"," + exactText(centre.x) +
           "],PARAMETER[\"false_easting\",0],PARAMETER[\"false_northing\",0],UNIT[\"metre\",1],AXIS[\"Easting\",EAST],"
           "AXIS[\"Northing\",NORTH]]";
}

std::vector<NetcdfAttribute> localMapping(Vec2 centre) {
    return {{"name", std::string("azimuthal equidistant projection of a sphere")},
            {"grid_mapping_name", std::string("azimuthal_equidistant")},
            {"longitude_of_projection_origin", std::vector<double>{centre.x}},
            {"latitude_of_projection_origin", std::vector<double>{centre.y}},
            {"false_easting", std::vector<double>{0.0}},
            {"false_northing", std::vector<double>{0.0}},
            {"earth_radius", std::vector<double>{kEarthRadius}},
            {"wkt", localWkt(centre)}};
}

/// Adds the number of a code such as "EPSG:3067".
void addCode(const std::string &code, std::vector<NetcdfAttribute> &attributes) {
    constexpr std::string_view kAuthority = "EPSG:";
    std::int32_t number = 0;
    if (code.starts_with(kAuthority) &&
        std::from_chars(code.data() + kAuthority.size(), code.data() + code.size(), number).ec == std::errc()) {
        attributes.push_back({"epsg", std::vector<std::int32_t>{number}});
        attributes.push_back({"EPSG_code", code});
    }
}

} // namespace

std::string systemVariable(const MapSystem &system) {
    const bool usual = system.code.empty() || system.code == "EPSG:4326";
    return !system.geographic ? "projected_coordinate_system" : usual ? "wgs84" : "geographic_coordinate_system";
}

std::string projectedUnit(LengthUnit unit, const MapSystem &system) {
    if (unit == LengthUnit::Inch || unit == LengthUnit::Foot) {
        return unit == LengthUnit::Inch ? "inch" : "foot";
    }
    if (unit != LengthUnit::None) {
        return std::string(wordOf(unit));
    }
    // The axes come last, as LENGTHUNIT["US survey foot",0.304800609601219].
    const std::string_view text = system.wkt;
    constexpr std::string_view kMark = "LENGTHUNIT[\"";
    const std::size_t at = text.rfind(kMark);
    const std::size_t comma = at == text.npos ? text.npos : text.find(',', at);
    if (comma == text.npos) {
        return "m";
    }
    double metres = 1.0;
    std::from_chars(text.data() + comma + 1, text.data() + text.size(), metres);
    return metres == 1.0 ? std::string("m") : exactText(metres) + " m";
}

NetcdfVariable systemOf(const MapSystem &system) {
    std::vector<NetcdfAttribute> attributes;
    if (system.centre) {
        attributes = localMapping(*system.centre);
    } else if (system.geographic) {
        // Maps whose system is unnamed are in WGS 84 by RFC 7946.
        const std::string code = system.code.empty() ? "EPSG:4326" : system.code;
        attributes = {{"name", code}, {"grid_mapping_name", std::string("latitude_longitude")}};
        if (code == "EPSG:4326") {
            attributes.push_back({"longitude_of_prime_meridian", std::vector<double>{0.0}});
            attributes.push_back({"semi_major_axis", std::vector<double>{6'378'137.0}});
            attributes.push_back({"inverse_flattening", std::vector<double>{298.257223563}});
        }
        addCode(code, attributes);
    } else {
        // What Delft3D FM writes for systems whose parameters it does not list.
        attributes = {{"name", system.code.empty() ? std::string("unnamed") : system.code},
                      {"grid_mapping_name", std::string("Unknown projected")}};
        addCode(system.code, attributes);
        if (system.code.empty()) {
            attributes.push_back({"wkt", system.wkt});
        }
    }
    if (!system.wkt.empty() && !system.centre) {
        attributes.push_back({"crs_wkt", system.wkt});
    }
    return {systemVariable(system), {}, std::move(attributes), false, [](BigEndian &values) { values.integer(0); }};
}

} // namespace forefront
