#include "app/reports/periodic_report.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/domain.hpp"

#include <cmath>
#include <numbers>

namespace forefront {

namespace {

double degreesOf(const RigidMap &map) {
    return std::atan2(map.s, map.c) * 180.0 / std::numbers::pi;
}

/// Returns the point that a rotation leaves where it is.
Vec2 centreOf(const RigidMap &map) {
    // (I - R) p = shift; the determinant of I - R is 2 (1 - c).
    const double scale = 1.0 / (2.0 * (1.0 - map.c));
    return {scale * ((1.0 - map.c) * map.shift.x - map.s * map.shift.y),
            scale * (map.s * map.shift.x + (1.0 - map.c) * map.shift.y)};
}

} // namespace

std::vector<PlacedPairs> allPeriodicPairs(const MeshView &mesh) {
    std::vector<PlacedPairs> links;
    for (const PeriodicLink &link : mesh.periodic) {
        PlacedPairs &placed = links.emplace_back(PlacedPairs{periodicPairs(mesh, link), {}});
        for (const NodePair &pair : placed.pairs) {
            placed.places.push_back({mesh.nodes[index(pair.from)], mesh.nodes[index(pair.to)]});
        }
    }
    return links;
}

void addPeriodic(const std::vector<PlacedPairs> &links, const std::map<std::int32_t, std::string> &names,
                 JsonWriter &json) {
    json.key("periodic").beginArray();
    for (const PlacedPairs &each : links) {
        const RigidMap &map = each.link.map;
        json.beginObject().member("from", boundaryName(names, each.link.from));
        json.member("to", boundaryName(names, each.link.to));
        json.member("cos", map.c).member("sin", map.s).member("shift_x", map.shift.x).member("shift_y", map.shift.y);
        json.member("exact", each.exact).member("deviation", each.deviation);
        json.key("pairs").beginArray();
        for (const auto &[first, second] : each.places) {
            json.beginArray().value(first.x).value(first.y).value(second.x).value(second.y).endArray();
        }
        json.endArray().endObject();
    }
    json.endArray();
}

std::string periodicLines(const std::vector<PlacedPairs> &links, const std::map<std::int32_t, std::string> &names) {
    constexpr int kDigits = 6;
    const auto place = [](Vec2 p) { return "(" + numberText(p.x, kDigits) + ", " + numberText(p.y, kDigits) + ")"; };
    std::string lines;
    for (const PlacedPairs &each : links) {
        const RigidMap &map = each.link.map;
        lines += "periodic: " + boundaryName(names, each.link.to) + " is " + boundaryName(names, each.link.from) +
                 (map.translates() ? " moved by " + place(map.shift)
                                   : " turned by " + numberText(degreesOf(map), kDigits) + " degrees about " +
                                         place(centreOf(map))) +
                 "; " + countText(each.pairs.size(), "pair") + " of nodes, " +
                 (each.exact == each.pairs.size()
                      ? std::string("all exact")
                      : std::to_string(each.exact) + " exact, the others within " + numberText(each.deviation, 2)) +
                 '\n';
    }
    return lines;
}

} // namespace forefront
