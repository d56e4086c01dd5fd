#include "app/reports/report.hpp"

#include "app/reports/quads_report.hpp"
#include "core/engine/base/hash.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/base/version.hpp"
#include "core/engine/mesh/uneven_elements.hpp"
#include "core/engine/platform/process.hpp"
#include "core/files/json/json_writer.hpp"
#include "core/files/rules/rules_json.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <span>

namespace forefront {

namespace {

std::string sharpCornerLines(const SharpCorners &sharp) {
    constexpr std::size_t kShown = 10;
    if (sharp.corners.empty()) {
        return {};
    }
    char text[200];
    std::snprintf(text, sizeof text,
                  "%zu corner%s of the domain below %.0f degrees; minimum angle elsewhere: %.1f degrees\n",
                  sharp.corners.size(), sharp.corners.size() == 1 ? "" : "s", kSharpCorner, sharp.minAngleElsewhere);
    std::string lines = text;
    for (std::size_t i = 0; i < std::min(kShown, sharp.corners.size()); ++i) {
        const SharpCorner &corner = sharp.corners[i];
        std::snprintf(text, sizeof text, "  %.1f degrees at (%.8g, %.8g)\n", corner.angle, corner.at.x, corner.at.y);
        lines += text;
    }
    if (sharp.corners.size() > kShown) {
        lines += "  " + std::to_string(sharp.corners.size() - kShown) + " more; --stats lists all\n";
    }
    return lines;
}

std::string narrowPlaceLines(const SharpCorners &sharp) {
    if (sharp.narrow.empty()) {
        return {};
    }
    char text[200];
    const NarrowPlace &place = sharp.narrow.front();
    std::snprintf(text, sizeof text,
                  "%zu narrow place%s with angles below %.0f degrees; the narrowest is %.3g wide at (%.8g, %.8g)\n",
                  sharp.narrow.size(), sharp.narrow.size() == 1 ? "" : "s", kSharpCorner, place.width, place.at.x,
                  place.at.y);
    return text;
}

/// Counts parts and holes as if the cracks of a mesh were closed: a crack is no hole.
void countAsClosed(const MeshView &mesh, MeshReport &report) {
    if (openLines(mesh).empty()) {
        return;
    }
    const ClosedMesh closed = closeCracks(mesh);
    std::size_t edges = report.quality.edges;
    for (const OpenLine &line : closed.lines) {
        edges -= line.edges;
    }
    const MeshExtent whole = extentOf(closed.mesh, edges);
    report.extent.parts = whole.parts;
    report.extent.holes = whole.holes;
}

void measureEdges(const MeshView &mesh, MeshReport &report) {
    double shortest = std::numeric_limits<double>::infinity(), longest = 0.0; // squares
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const std::span<const NodeId> corners = mesh.cornersOf(e);
        Vec2 before = mesh.nodes[index(corners.back())];
        for (const NodeId corner : corners) {
            const Vec2 here = mesh.nodes[index(corner)];
            shortest = std::min(shortest, distanceSquared(before, here));
            longest = std::max(longest, distanceSquared(before, here));
            before = here;
        }
    }
    report.shortest = mesh.elementCount() > 0 ? std::sqrt(shortest) : 0.0;
    report.longest = std::sqrt(longest);
}

} // namespace

MeshReport reportOf(const MeshView &mesh, const SpacingField *spacing, bool valid, bool open) {
    MeshReport report;
    report.quality = measureQuality(mesh, spacing);
    report.extent = extentOf(mesh, report.quality.edges);
    if (open) {
        countAsClosed(mesh, report);
    }
    report.bounds = mesh.bounds();
    if (valid) {
        report.sharp = sharpCorners(mesh, kSharpCorner);
        report.leastUniformity = leastJacobianUniformity(mesh);
    }
    report.hash = meshHash(mesh);
    report.hasSpacing = spacing != nullptr;
    measureEdges(mesh, report);
    return report;
}

RunReport reportOf(const MeshingOutcome &outcome, const MeshingOptions &options) {
    const std::uint64_t peak = peakMemory(); // before measuring, which needs more memory
    RunReport report;
    static_cast<MeshReport &>(report) =
        reportOf(outcome.mesh, outcome.spacing.get(), true, !outcome.cracks.cracks.empty());
    report.peakBytes = peak;
    report.work = outcome.work;
    report.improve = options.improve;
    report.elements = options.elements;
    if (options.elements == Elements::Triangles && options.method == Method::Classic) {
        report.rules = options.rules;
    }
    report.leastAngle = options.leastAngle;
    report.angles = outcome.leastAngle;
    report.quads = outcome.quads;
    report.elementOrder = options.order;
    report.order = outcome.order;
    report.layers = outcome.layers;
    report.periodic = allPeriodicPairs(outcome.mesh);
    report.cracks = outcome.cracks;
    report.boundaryNames = outcome.mesh.boundaryNames;
    report.secondsPrepare = outcome.secondsPrepare;
    report.secondsMesh = outcome.secondsMesh;
    report.secondsImprove = outcome.secondsImprove;
    return report;
}

Diagnostics flatElements(const MeshQuality &quality) {
    if (quality.flat == 0) {
        return {};
    }
    Diagnostics found = error("flat-element",
                              std::to_string(quality.flat) + (quality.flat == 1 ? " element is" : " elements are") +
                                  " flat: the area is within the rounding error of the nodes",
                              "divide the boundary more finely, or remove nearly straight corners and near contacts");
    found.front().severity = Severity::Warning;
    return found;
}

namespace {

/// Returns some places as a list, the first five of them.
std::string listedPlaces(const std::vector<Vec2> &places) {
    constexpr std::size_t kShown = 5;
    std::string list = placeText(places.front());
    for (std::size_t i = 1; i < std::min(places.size(), kShown); ++i) {
        list += ", " + placeText(places[i]);
    }
    return list + (places.size() > kShown ? " and more" : "");
}

} // namespace

Diagnostics concavePlaces(const QuadReport &quads) {
    Diagnostics found;
    if (!quads.notConvexAt.empty()) {
        found = error("concave-element",
                      std::to_string(quads.notConvex) +
                          (quads.notConvex == 1 ? " quadrilateral has" : " quadrilaterals have") +
                          " a corner of 180 degrees or more, where the domain is sharp or narrow: at " +
                          listedPlaces(quads.notConvexAt),
                      "choose smaller elements there, or divide them with --elements mixed");
        found.front().severity = Severity::Warning;
    }
    if (!quads.trianglesAt.empty()) {
        Diagnostics note = error("triangles-for-quads",
                                 "triangles take the place of quadrilaterals that would not be convex, where the "
                                 "domain is sharp or narrow: at " +
                                     listedPlaces(quads.trianglesAt),
                                 "choose smaller elements there if only quadrilaterals may remain");
        note.front().severity = Severity::Note;
        found.insert(found.end(), note.begin(), note.end());
    }
    return found;
}

namespace {

bool onlyTriangles(const MeshQuality &quality) {
    return quality.kinds[static_cast<std::size_t>(CellKind::Triangle3)] == quality.elements;
}

/// Adds the figures of meshes that hold quadrilaterals or elements of second order.
void addKinds(const MeshReport &report, JsonWriter &json) {
    const MeshQuality &quality = report.quality;
    if (onlyTriangles(quality)) {
        return;
    }
    json.member("scaled_jacobian_min", quality.minScaledJacobian);
    if (report.leastUniformity) {
        json.member("jacobian_uniformity_min", *report.leastUniformity);
    }
    json.key("elements_by_kind").beginObject();
    for (const CellKind kind : kElementKinds) {
        if (const std::size_t count = quality.kinds[static_cast<std::size_t>(kind)]; count > 0) {
            json.member(wordOf(kind), count);
        }
    }
    json.endObject();
}

/// Returns a name or, where the mesh has none, the one that exports and the editor use.
const std::string &named(const std::string &name, const std::string &usual) {
    return name.empty() ? usual : name;
}

void addFigures(const MeshReport &report, JsonWriter &json) {
    const MeshQuality &q = report.quality;
    const double unknown = std::numeric_limits<double>::quiet_NaN(); // null
    json.member("nodes", q.nodes).member("elements", q.elements).member("area", q.area);
    json.key("bounds").values(
        std::vector<double>{report.bounds.min.x, report.bounds.min.y, report.bounds.max.x, report.bounds.max.y});
    json.member("parts", report.extent.parts).member("holes", report.extent.holes);
    json.key("regions").beginArray();
    for (const RegionExtent &region : report.extent.regions) {
        json.beginObject().member("tag", region.tag).member("name", named(region.name, regionName({}, region.tag)));
        json.member("elements", region.elements).member("area", region.area).endObject();
    }
    json.endArray();
    json.key("boundaries").beginArray();
    for (const BoundaryExtent &boundary : report.extent.boundaries) {
        json.beginObject()
            .member("tag", boundary.tag)
            .member("name", named(boundary.name, boundaryName({}, boundary.tag)));
        json.member("edges", boundary.edges).member("length", boundary.length).endObject();
    }
    json.endArray();
    json.member("alpha_mean", q.alphaMean).member("alpha_geometric_mean", q.alphaGeometricMean);
    json.member("alpha_min", q.alphaMin)
        .member("flat_elements", q.flat)
        .member("delta_mean", report.hasSpacing ? q.deltaMean : unknown);
    json.member("delta_area_mean", report.hasSpacing ? q.deltaAreaMean : unknown);
    json.member("edge_length_min", report.shortest).member("edge_length_max", report.longest);
    json.member("min_angle_deg", q.minAngle).member("max_angle_deg", q.maxAngle);
    json.member("min_angle_elsewhere_deg", report.sharp.minAngleElsewhere);
    addKinds(report, json);
    json.key("sharp_corners").beginArray();
    for (const SharpCorner &corner : report.sharp.corners) {
        json.beginObject().member("x", corner.at.x).member("y", corner.at.y);
        json.member("angle_deg", corner.angle).endObject();
    }
    json.endArray();
    json.key("narrow_places").beginArray();
    for (const NarrowPlace &place : report.sharp.narrow) {
        json.beginObject().member("x", place.at.x).member("y", place.at.y);
        json.member("width", place.width).member("elements", place.elements).endObject();
    }
    json.endArray();
}

/// Returns true if a run made quadrilaterals, be it in one region alone.
bool hasQuads(const RunReport &report) {
    return report.elements != Elements::Triangles || report.quads.quadrilaterals > 0;
}

} // namespace

std::string statisticsJson(const MeshReport &report, bool valid, const std::vector<LimitVerdict> &verdicts) {
    JsonWriter json(JsonWriter::Layout::Indented);
    json.beginObject().member("version", version()).member("valid", valid);
    json.key("limits").beginArray();
    for (const LimitVerdict &verdict : verdicts) {
        json.beginObject().member("limit", wordOf(verdict.limit)).member("bound", verdict.bound);
        json.member("met", verdict.met()).member("worst", verdict.worst);
        json.member("violated_by", verdict.broken).endObject();
    }
    json.endArray();
    addFigures(report, json);
    json.member("hash", toHex(report.hash));
    return json.endObject().text();
}

namespace {

void addLeastAngle(double asked, const LeastAngleReport &angles, JsonWriter &json) {
    json.key("least_angle").beginObject();
    json.member("asked", asked).member("reached", angles.reached);
    json.member("added_nodes", angles.addedNodes).member("divided_edges", angles.dividedEdges);
    json.key("forced").beginArray();
    for (const ForcedAngle &place : angles.forced) {
        json.beginObject().member("x", place.at.x).member("y", place.at.y).member("angle", place.angle);
        json.member("by", wordOf(place.reason)).member("elements", place.elements);
        json.member("reach", place.reach).endObject();
    }
    json.endArray().endObject();
}

void addOrder(const SecondOrderReport &order, JsonWriter &json) {
    json.key("second_order").beginObject();
    json.member("curved_edges", order.curvedEdges);
    json.member("moved_corners", order.movedCorners);
    json.key("straight_edges").beginArray();
    for (const StraightEdge &edge : order.straight) {
        json.beginObject().member("x", edge.at.x).member("y", edge.at.y);
        json.member("reason", wordOf(edge.reason)).endObject();
    }
    json.endArray();
    json.key("uneven_elements").beginArray();
    for (const UnevenElement &element : order.uneven) {
        json.beginObject().member("x", element.at.x).member("y", element.at.y);
        json.member("least_over_greatest", element.ratio).endObject();
    }
    json.endArray().endObject();
}

void addLayers(const RunReport &report, JsonWriter &json) {
    const LayerReport &layers = report.layers;
    json.key("boundary_layers").beginObject();
    json.member("rays", layers.rays).member("fans", layers.fans);
    json.member("layers_min", layers.fewest).member("layers_max", layers.most);
    json.member("quadrilaterals", layers.quadrilaterals).member("triangles", layers.triangles);
    json.key("shortened").beginArray();
    for (const ShortenedRay &ray : layers.shortened) {
        json.beginObject().member("x", ray.base.x).member("y", ray.base.y);
        json.member("boundary", boundaryName(report.boundaryNames, ray.tag));
        json.member("asked", ray.asked).member("made", ray.made).member("reason", wordOf(ray.stop));
        json.member("stopped_by", boundaryName(report.boundaryNames, ray.stoppedBy)).endObject();
    }
    json.endArray().endObject();
}

/// Returns a line on the boundary layers; empty without any.
std::string layersLine(const LayerReport &layers) {
    if (layers.rays == 0) {
        return {};
    }
    const std::string counts = layers.fewest == layers.most
                                   ? std::to_string(layers.most)
                                   : std::to_string(layers.fewest) + " to " + std::to_string(layers.most);
    return "boundary layers: " + counts + " on " + countText(layers.rays, "ray") + ", " +
           countText(layers.quadrilaterals, "quadrilateral") + " and " + countText(layers.triangles, "triangle") +
           "; fewer than asked for on " + countText(layers.shortened.size(), "ray") + '\n';
}

} // namespace

std::string statisticsJson(const RunReport &report) {
    const auto perElement = [&](std::uint64_t sum) {
        return report.work.elements == 0 ? 0.0 : static_cast<double>(sum) / static_cast<double>(report.work.elements);
    };
    JsonWriter json(JsonWriter::Layout::Indented);
    json.beginObject().member("version", version()).member("input", report.input);
    addFigures(report, json);
    json.member("front_mean", report.work.frontMean());
    if (report.elements == Elements::Triangles) { // the two-coloured front does not count the work of its searches
        json.member("neighbours_mean", report.work.neighboursMean());
        json.member("considered_mean", report.work.consideredMean()).member("tests_mean", report.work.testsMean());
        json.member("cells_mean", perElement(report.work.cellsVisited));
        json.member("candidates_mean", perElement(report.work.candidates));
    }
    json.member("forced_mean", perElement(report.work.forced)).member("improve", wordOf(report.improve));
    json.member("seconds_prepare", report.secondsPrepare).member("seconds_mesh", report.secondsMesh);
    json.member("seconds_improve", report.secondsImprove).member("peak_bytes", report.peakBytes);
    if (report.leastAngle) {
        addLeastAngle(*report.leastAngle, report.angles, json);
    }
    if (hasQuads(report)) {
        addQuads(report.quads, json);
    }
    if (report.elementOrder == ElementOrder::Second) {
        addOrder(report.order, json);
    }
    if (report.layers.rays > 0) {
        addLayers(report, json);
    }
    if (!report.periodic.empty()) {
        addPeriodic(report.periodic, report.boundaryNames, json);
    }
    if (!report.cracks.cracks.empty()) {
        addCracks(report.cracks, report.boundaryNames, json);
    }
    if (report.rules != FrontRules()) {
        json.key("rules");
        writeRules(report.rules, json);
    }
    json.member("hash", toHex(report.hash));
    return json.endObject().text();
}

std::string extentLine(double area, const MeshExtent &extent) {
    constexpr std::size_t kShown = 6;
    constexpr int kDigits = 6;
    const auto counted = [](std::size_t count, const char *what) {
        return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
    };
    std::string line = "area " + numberText(area, kDigits) + ", " + counted(extent.parts, "part") + ", " +
                       counted(extent.holes, "hole");
    const std::vector<RegionExtent> &regions = extent.regions;
    for (std::size_t k = 0; k < std::min(kShown, regions.size()) && regions.size() > 1; ++k) {
        const RegionExtent &region = regions[k];
        line += (k == 0 ? "; regions: " : ", ") + (region.name.empty() ? std::to_string(region.tag) : region.name) +
                " with " + numberText(region.area, kDigits);
    }
    return line + (regions.size() > kShown ? " and " + std::to_string(regions.size() - kShown) + " more" : "") + '\n';
}

std::string kindsLine(const MeshReport &report) {
    const MeshQuality &quality = report.quality;
    if (onlyTriangles(quality)) {
        return {};
    }
    std::string line;
    for (const CellKind kind : kElementKinds) {
        if (const std::size_t count = quality.kinds[static_cast<std::size_t>(kind)]; count > 0) {
            line += (line.empty() ? "" : ", ") + std::to_string(count) + ' ' +
                    (count == 1 ? traitsOf(kind).name : traitsOf(kind).plural);
        }
    }
    char text[120];
    std::snprintf(text, sizeof text, "; scaled Jacobian: minimum %.4f", quality.minScaledJacobian);
    line += text;
    if (report.leastUniformity) {
        std::snprintf(text, sizeof text, "; Jacobian determinant in each element: at least %.4f of its maximum",
                      *report.leastUniformity);
        line += text;
    }
    return line + '\n';
}

std::string conformityLine(const MeshQuality &quality) {
    char text[100];
    std::snprintf(text, sizeof text, "spacing conformity: mean %.4f at edges, %.4f over the area\n", quality.deltaMean,
                  quality.deltaAreaMean);
    return text;
}

namespace {

/// Returns lines on the least angle of a mesh and on the places that have smaller ones.
std::string leastAngleLines(const RunReport &report) {
    if (!report.leastAngle) {
        return {};
    }
    constexpr std::size_t kShown = 10;
    const LeastAngleReport &angles = report.angles;
    char text[60];
    std::snprintf(text, sizeof text, "least angle: %.2f degrees, ", angles.reached);
    std::string lines = (angles.reached > 0.0 ? text : "least angle: every element is forced, ") +
                        std::to_string(angles.addedNodes) + " nodes added, " + std::to_string(angles.dividedEdges) +
                        " of them on lines\n";
    for (std::size_t i = 0; i < std::min(kShown, angles.forced.size()); ++i) {
        const ForcedAngle &place = angles.forced[i];
        lines += "  smaller at " + placeText(place.at) + ": " + toString(place) + '\n';
    }
    if (angles.forced.size() > kShown) {
        lines += "  and " + std::to_string(angles.forced.size() - kShown) + " more places\n";
    }
    return lines;
}

} // namespace

std::string summary(const RunReport &report) {
    const MeshQuality &q = report.quality;
    const double cpu = report.meshCpu();
    const std::string size = std::to_string(q.nodes) + " nodes, " + std::to_string(q.elements) + " elements, hash " +
                             toHex(report.hash) + '\n' + extentLine(q.area, report.extent) + kindsLine(report);
    char text[500];
    std::snprintf(
        text, sizeof text,
        "shape factor: mean %.4f, geometric mean %.4f, minimum %.4f; angles %.1f to %.1f degrees\n%s"
        "%.3f s for the mesh (%.3f preparation, %.3f front, %.3f improvement), %.0f elements/s, peak %.1f MB\n",
        q.alphaMean, q.alphaGeometricMean, q.alphaMin, q.minAngle, q.maxAngle, conformityLine(q).c_str(), cpu,
        report.secondsPrepare, report.secondsMesh, report.secondsImprove,
        cpu > 0.0 ? static_cast<double>(q.elements) / cpu : 0.0, static_cast<double>(report.peakBytes) / 1e6);
    const std::string rules = report.rules == FrontRules() ? "" : "changed rules: " + changesText(report.rules) + '\n';
    return leastAngleLines(report) + sharpCornerLines(report.sharp) + narrowPlaceLines(report.sharp) + rules + size +
           (hasQuads(report) ? quadLines(report.quads, report.elements == Elements::Quads) : std::string()) +
           layersLine(report.layers) + periodicLines(report.periodic, report.boundaryNames) +
           crackLines(report.cracks, report.boundaryNames) + text;
}

} // namespace forefront
