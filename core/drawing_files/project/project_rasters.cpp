#include "core/drawing_files/project/project_rasters.hpp"

#include "core/engine/spacing/parts/expression/spacing_functions.hpp"
#include "core/files/common/cell_grid.hpp"
#include "core/files/json/json_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>

namespace forefront {
namespace {

void readRasterValues(const JsonValue &list, JsonCheck &check, Raster &raster) {
    bool given = false;
    for (const JsonValue value : list) {
        if (check.full()) {
            return;
        }
        const bool missing = value.is(JsonKind::Null);
        raster.values.push_back(missing ? std::numeric_limits<double>::quiet_NaN()
                                        : check.number(value, "a value of a raster"));
        given = given || !missing;
    }
    if (raster.values.empty() || raster.values.size() % raster.columns != 0) {
        check.fault(list, "bad-count",
                    "expected whole rows of " + std::to_string(raster.columns) + " values, found " +
                        std::to_string(raster.values.size()));
    } else if (!given) {
        check.fault(list, "no-values", "a raster has no values");
    }
    raster.rows = raster.values.size() / raster.columns;
}

std::shared_ptr<const Raster> readRasterItem(const JsonValue &object, JsonCheck &check) {
    Raster raster;
    if (!check.expect(object, JsonKind::Object, "a raster")) {
        return nullptr;
    }
    const auto origin = check.member(object, "origin", "the raster");
    const auto pitch = check.member(object, "pitch", "the raster");
    const auto columns = check.member(object, "columns", "the raster");
    const auto values = check.member(object, "values", "the raster");
    if (!origin || !pitch || !columns || !values || !check.expect(*values, JsonKind::Array, "\"values\"")) {
        return nullptr;
    }
    check.noteUnknown(object, {"origin", "pitch", "columns", "values"});
    raster.origin = check.point(*origin, "the origin of a raster");
    raster.pitch = check.point(*pitch, "the pitch of a raster");
    if (!(raster.pitch.x > 0.0) || !(raster.pitch.y > 0.0)) {
        check.fault(*pitch, "bad-number", "the pitch of a raster must be positive");
    }
    constexpr auto kMaxColumns = static_cast<std::int64_t>(kMaxGridValues);
    raster.columns = static_cast<std::size_t>(
        std::max<std::int64_t>(1, check.integer(*columns, 1, kMaxColumns, "the number of columns of a raster")));
    readRasterValues(*values, check, raster);
    return std::make_shared<const Raster>(std::move(raster));
}

} // namespace

void writeRasters(const RasterMap &rasters, JsonText &out) {
    out << "{\n      ";
    out.list(rasters, ",\n      ", [&](const auto &entry) {
        const Raster &raster = *entry.second;
        out << jsonString(entry.first) << ": {\"origin\": ";
        out.point(raster.origin);
        out << ", \"pitch\": ";
        out.point(raster.pitch);
        out << ", \"columns\": " << raster.columns << ", \"values\": [";
        out.list(raster.values, ", ", [&](double value) {
            if (std::isfinite(value)) {
                out.number(value);
            } else {
                out << "null";
            }
        });
        out << "]}";
    });
    out << "\n    }";
}

RasterMap readRasters(const JsonValue &object, JsonCheck &check) {
    RasterMap rasters;
    if (!check.expect(object, JsonKind::Object, "\"rasters\"")) {
        return rasters;
    }
    for (auto member = object.begin(); !(member == object.end()) && !check.full(); ++member) {
        const std::string name = member.key();
        if (const std::string wrong = checkRasterName(name); !wrong.empty()) {
            check.fault(member.keyValue(), "bad-name", wrong);
            continue;
        }
        auto raster = readRasterItem(*member, check);
        if (raster != nullptr && !rasters.emplace(name, std::move(raster)).second) {
            check.fault(member.keyValue(), "bad-name", "duplicate raster name '" + name + "'");
        }
    }
    return rasters;
}

} // namespace forefront
