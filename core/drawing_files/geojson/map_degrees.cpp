#include "core/drawing_files/geojson/map_degrees.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace forefront {

namespace {

constexpr double kPole = 90.0, kDegreeSlack = 1e-6; // degrees

/// Returns the number after the last colon of a name such as "urn:ogc:def:crs:EPSG::4326".
std::string_view codeOf(std::string_view name) {
    const std::size_t colon = name.rfind(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

} // namespace

bool isGeographic(std::string_view name) {
    // CRS of OGC, and of EPSG: WGS 84 in two and three dimensions, ETRS89, NAD83, NAD27, GDA94, GDA2020, CGCS2000,
    // JGD2011.
    static constexpr std::array<std::string_view, 13> kCodes{"CRS84", "CRS83", "CRS27", "4326", "4979", "4258", "4269",
                                                             "4267",  "4283",  "7844",  "4490", "6668", "WGS84"};
    return std::find(kCodes.begin(), kCodes.end(), codeOf(name)) != kCodes.end();
}

std::string systemCode(std::string_view name) {
    const std::string_view code = codeOf(name);
    const bool digits = !code.empty() && code.find_first_not_of("0123456789") == std::string_view::npos;
    return digits && name.find("EPSG") != std::string_view::npos ? "EPSG:" + std::string(code) : std::string();
}

bool maybeDegrees(const Box2 &box) {
    return !box.empty() && box.min.x >= -180.0 - kDegreeSlack && box.max.x <= 360.0 + kDegreeSlack &&
           box.min.y >= -kPole - kDegreeSlack && box.max.y <= kPole + kDegreeSlack;
}

double degreeDistortion(const Box2 &box) {
    constexpr double kLeast = 1e-6; // of the cosine, which is 0 at a pole
    const double latitude = std::clamp(0.5 * (box.min.y + box.max.y), -kPole, kPole);
    return 1.0 / std::max(std::cos(latitude * (std::numbers::pi / 180.0)), kLeast);
}

} // namespace forefront
