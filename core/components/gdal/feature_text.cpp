#include "core/components/gdal/feature_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cpl_conv.h>
#include <cpl_string.h>

namespace forefront::gdal {

namespace {

template <class Number>
void appendNumber(Number value, std::string &text) {
    std::array<char, 32> digits{};
    text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

bool appendPosition(OGRGeometryH points, int k, std::string &text) {
    const std::array<double, 3> place = {OGR_G_GetX(points, k), OGR_G_GetY(points, k), OGR_G_GetZ(points, k)};
    const std::size_t count = OGR_G_Is3D(points) != 0 ? 3 : 2;
    for (std::size_t c = 0; c < count; ++c) {
        if (!std::isfinite(place[c])) {
            return false;
        }
        text += c == 0 ? '[' : ',';
        appendNumber(place[c], text);
    }
    text += ']';
    return true;
}

bool appendPositions(OGRGeometryH line, std::string &text) {
    text += '[';
    for (int k = 0; k < OGR_G_GetPointCount(line); ++k) {
        text += k > 0 ? "," : "";
        if (!appendPosition(line, k, text)) {
            return false;
        }
    }
    text += ']';
    return true;
}

/// Appends the parts of a geometry with commas between them, each by `append`.
template <class Append>
bool appendParts(OGRGeometryH geometry, Append append, std::string &text) {
    text += '[';
    for (int k = 0; k < OGR_G_GetGeometryCount(geometry); ++k) {
        text += k > 0 ? "," : "";
        if (!append(OGR_G_GetGeometryRef(geometry, k), text)) {
            return false;
        }
    }
    text += ']';
    return true;
}

bool appendRings(OGRGeometryH polygon, std::string &text) {
    return appendParts(polygon, appendPositions, text);
}

bool appendPoint(OGRGeometryH point, std::string &text) {
    return appendPosition(point, 0, text);
}

} // namespace

std::string jsonString(std::string_view given) {
    std::string valid(given);
    if (CPLIsUTF8(valid.c_str(), static_cast<int>(valid.size())) == FALSE) {
        char *const ascii = CPLForceToASCII(valid.c_str(), static_cast<int>(valid.size()), '?');
        valid = ascii;
        CPLFree(ascii);
    }
    std::string text = "\"";
    for (const char c : valid) {
        constexpr const char *kHex = "0123456789abcdef";
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            text += '\\';
            text += c;
        } else if (byte < 0x20) {
            text += "\\u00";
            text += kHex[byte >> 4U];
            text += kHex[byte & 15U];
        } else {
            text += c;
        }
    }
    return text += '"';
}

bool appendGeometry(OGRGeometryH geometry, std::string &text) {
    const auto coordinates = [&](const char *type, auto append) {
        text += std::string("{\"type\":\"") + type + "\",\"coordinates\":";
        const bool finite = append(geometry, text);
        text += '}';
        return finite;
    };
    const auto parts = [](auto append) {
        return [append](OGRGeometryH whole, std::string &out) { return appendParts(whole, append, out); };
    };
    switch (wkbFlatten(OGR_G_GetGeometryType(geometry))) {
    case wkbPoint:
        return coordinates("Point", appendPoint);
    case wkbLineString:
        return coordinates("LineString", appendPositions);
    case wkbPolygon:
        return coordinates("Polygon", appendRings);
    case wkbMultiPoint:
        return coordinates("MultiPoint", parts(appendPoint));
    case wkbMultiLineString:
        return coordinates("MultiLineString", parts(appendPositions));
    case wkbMultiPolygon:
        return coordinates("MultiPolygon", parts(appendRings));
    case wkbGeometryCollection: {
        text += "{\"type\":\"GeometryCollection\",\"geometries\":";
        const bool finite = appendParts(geometry, appendGeometry, text);
        text += '}';
        return finite;
    }
    default:
        return false;
    }
}

void appendProperties(OGRFeatureH feature, std::string &text) {
    text += '{';
    bool first = true;
    for (int k = 0; k < OGR_F_GetFieldCount(feature); ++k) {
        if (OGR_F_IsFieldSetAndNotNull(feature, k) == 0) {
            continue;
        }
        const OGRFieldDefnH field = OGR_F_GetFieldDefnRef(feature, k);
        text += first ? "" : ",";
        first = false;
        text += jsonString(OGR_Fld_GetNameRef(field)) + ':';
        const OGRFieldType type = OGR_Fld_GetType(field);
        if (type == OFTInteger || type == OFTInteger64) {
            appendNumber(static_cast<long long>(OGR_F_GetFieldAsInteger64(feature, k)), text);
        } else if (const double real = OGR_F_GetFieldAsDouble(feature, k); type == OFTReal && std::isfinite(real)) {
            appendNumber(real, text);
        } else {
            text += jsonString(OGR_F_GetFieldAsString(feature, k));
        }
    }
    text += '}';
}

} // namespace forefront::gdal
