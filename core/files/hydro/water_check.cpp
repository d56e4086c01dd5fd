#include "core/files/hydro/water_check.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/mesh/edge_table.hpp"
#include "core/files/hydro/shoreline.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// A violation: how bad it is, for the order, and its error.
struct WaterFault {
    double badness;
    Diagnostic fault;
};

/// Returns the area inside an outline, counter-clockwise positive.
double areaWithin(const MeshView &mesh, std::span<const NodeId> outline) {
    const Vec2 origin = mesh.nodes[index(outline.front())];
    double twice = 0.0;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        twice += cross(mesh.nodes[index(outline[k])] - origin,
                       mesh.nodes[index(outline[(k + 1) % outline.size()])] - origin);
    }
    return 0.5 * twice;
}

Diagnostic waterError(const char *code, std::string message, Vec2 at) {
    Diagnostic fault;
    fault.code = code;
    fault.message = std::move(message);
    fault.at = at;
    return fault;
}

std::vector<WaterFault> areaRatios(const MeshView &mesh, double limit, const MeshNumbers &numbers) {
    std::vector<double> areas;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        areas.push_back(std::fabs(areaWithin(mesh, mesh.cornersOf(e))));
    }
    std::vector<WaterFault> faults;
    const EdgeTable table(mesh);
    table.forEach([&](NodeId low, NodeId high, std::span<const HalfEdge> sides) {
        if (sides.size() != 2) {
            return;
        }
        const std::size_t a = table.halfEdges().elementOf(sides[0]), b = table.halfEdges().elementOf(sides[1]);
        const double smaller = std::min(areas[a], areas[b]), larger = std::max(areas[a], areas[b]);
        const double ratio = smaller > 0.0 ? larger / smaller : std::numeric_limits<double>::infinity();
        if (ratio > limit * (1.0 + 1e-9)) { // rounding does not decide
            Diagnostic fault = waterError("area-ratio",
                                          "elements " + std::to_string(numbers.elements.of(a)) + " and " +
                                              std::to_string(numbers.elements.of(b)) + ": areas in the ratio " +
                                              numberText(ratio, 4) + " violate the limit " + numberText(limit, 6),
                                          0.5 * (mesh.nodes[index(low)] + mesh.nodes[index(high)]));
            fault.ids = {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)};
            faults.push_back({ratio, std::move(fault)});
        }
    });
    return faults;
}

std::vector<WaterFault> smallIslands(const MeshView &mesh, double limit) {
    std::vector<WaterFault> faults;
    for (const ShoreStretch &stretch : shoreline(mesh, {})) {
        if (stretch.kind != ShoreStretch::Kind::Island) {
            continue;
        }
        const double area = std::fabs(areaWithin(mesh, stretch.nodes));
        if (area < limit * (1.0 - 1e-9)) {
            Vec2 mean;
            for (const NodeId node : stretch.nodes) {
                mean = mean + (1.0 / static_cast<double>(stretch.nodes.size())) * mesh.nodes[index(node)];
            }
            faults.push_back(
                {-area, waterError("small-island",
                                   "an island of " + countText(stretch.nodes.size(), "node") + " has the area " +
                                       numberText(area, 4) + ", below the limit " + numberText(limit, 6),
                                   mean)});
        }
    }
    return faults;
}

/// Adds the worst faults, and a note on the others.
void addWorst(std::vector<WaterFault> found, std::size_t most, const char *what, Diagnostics &faults) {
    std::stable_sort(found.begin(), found.end(),
                     [](const WaterFault &a, const WaterFault &b) { return a.badness > b.badness; });
    for (std::size_t k = 0; k < std::min(most, found.size()); ++k) {
        faults.push_back(std::move(found[k].fault));
    }
    if (found.size() > most) {
        Diagnostic &note = faults.emplace_back();
        note.severity = Severity::Note;
        note.code = "more";
        note.message = countText(found.size() - most, what) + " more violate" + (found.size() - most == 1 ? "s" : "") +
                       " the limit";
    }
}

} // namespace

Diagnostics checkWater(const MeshView &mesh, const WaterLimits &limits, std::size_t most, const MeshNumbers &numbers) {
    Diagnostics faults;
    if (limits.areaRatio) {
        addWorst(areaRatios(mesh, *limits.areaRatio, numbers), most, "side", faults);
    }
    if (limits.islandArea) {
        addWorst(smallIslands(mesh, *limits.islandArea), most, "island", faults);
    }
    return faults;
}

} // namespace forefront
