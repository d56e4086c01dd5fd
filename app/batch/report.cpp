#include "app/batch/report.hpp"

#include "core/engine/base/hash.hpp"
#include "core/engine/base/number_text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <sys/resource.h>

namespace forefront {

namespace {

std::uint64_t peakBytes() {
    rusage usage{};
    return getrusage(RUSAGE_SELF, &usage) == 0 ? static_cast<std::uint64_t>(usage.ru_maxrss) * 1024U : 0U;
}

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
        lines += "  and " + std::to_string(sharp.corners.size() - kShown) + " more, all in --stats\n";
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

} // namespace

MeshReport reportOf(const Mesh &mesh, const SpacingField *spacing, bool valid) {
    MeshReport report;
    report.quality = measure(mesh, spacing);
    report.extent = extentOf(mesh, report.quality.segments);
    if (valid) {
        report.sharp = sharpCorners(mesh, kSharpCorner);
    }
    report.hash = meshHash(mesh);
    return report;
}

RunReport reportOf(const MeshingOutcome &outcome, const MeshingOptions &options) {
    const std::uint64_t peak = peakBytes(); // before measuring, which needs more memory
    RunReport report;
    static_cast<MeshReport &>(report) = reportOf(outcome.mesh, outcome.spacing.get(), true);
    report.peakBytes = peak;
    report.work = outcome.work;
    report.improve = options.improve;
    report.secondsPrepare = outcome.secondsPrepare;
    report.secondsMesh = outcome.secondsMesh;
    report.secondsImprove = outcome.secondsImprove;
    return report;
}

namespace {

void addFigures(const MeshReport &report, nlohmann::ordered_json &json) {
    const MeshQuality &q = report.quality;
    json["nodes"] = q.nodes;
    json["elements"] = q.elements;
    json["area"] = q.area;
    json["parts"] = report.extent.parts;
    json["holes"] = report.extent.holes;
    json["regions"] = nlohmann::ordered_json::array();
    for (const RegionExtent &region : report.extent.regions) {
        json["regions"].push_back(
            {{"tag", region.tag}, {"name", region.name}, {"elements", region.elements}, {"area", region.area}});
    }
    json["boundaries"] = nlohmann::ordered_json::array();
    for (const BoundaryExtent &boundary : report.extent.boundaries) {
        json["boundaries"].push_back(
            {{"tag", boundary.tag}, {"name", boundary.name}, {"edges", boundary.edges}, {"length", boundary.length}});
    }
    json["alpha_mean"] = q.alphaMean;
    json["alpha_geometric_mean"] = q.alphaGeometricMean;
    json["alpha_min"] = q.alphaMin;
    json["delta_mean"] = q.deltaMean;
    json["min_angle_deg"] = q.minAngle;
    json["max_angle_deg"] = q.maxAngle;
    json["min_angle_elsewhere_deg"] = report.sharp.minAngleElsewhere;
    json["sharp_corners"] = nlohmann::ordered_json::array();
    for (const SharpCorner &corner : report.sharp.corners) {
        json["sharp_corners"].push_back({{"x", corner.at.x}, {"y", corner.at.y}, {"angle_deg", corner.angle}});
    }
    json["narrow_places"] = nlohmann::ordered_json::array();
    for (const NarrowPlace &place : report.sharp.narrow) {
        json["narrow_places"].push_back(
            {{"x", place.at.x}, {"y", place.at.y}, {"width", place.width}, {"elements", place.elements}});
    }
}

} // namespace

std::string statisticsJson(const MeshReport &report, bool valid, const std::vector<LimitVerdict> &verdicts) {
    nlohmann::ordered_json json;
    json["valid"] = valid;
    json["limits"] = nlohmann::ordered_json::array();
    for (const LimitVerdict &verdict : verdicts) {
        json["limits"].push_back({{"limit", wordOf(verdict.limit)},
                                  {"bound", verdict.bound},
                                  {"met", verdict.met()},
                                  {"worst", verdict.worst},
                                  {"violated_by", verdict.broken}});
    }
    addFigures(report, json);
    json["hash"] = toHex(report.hash);
    return json.dump(2) + '\n';
}

std::string statisticsJson(const RunReport &report) {
    nlohmann::ordered_json json;
    addFigures(report, json);
    json["front_mean"] = report.work.frontMean();
    json["neighbours_mean"] = report.work.neighboursMean();
    json["tests_mean"] = report.work.testsMean();
    const auto perElement = [&](std::uint64_t sum) {
        return report.work.elements == 0 ? 0.0 : static_cast<double>(sum) / static_cast<double>(report.work.elements);
    };
    json["cells_mean"] = perElement(report.work.cellsVisited);
    json["candidates_mean"] = perElement(report.work.candidates);
    json["forced_mean"] = perElement(report.work.forced);
    json["improve"] = wordOf(report.improve);
    json["seconds_prepare"] = report.secondsPrepare;
    json["seconds_mesh"] = report.secondsMesh;
    json["seconds_improve"] = report.secondsImprove;
    json["peak_bytes"] = report.peakBytes;
    json["hash"] = toHex(report.hash);
    return json.dump(2) + '\n';
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

std::string summary(const RunReport &report) {
    const MeshQuality &q = report.quality;
    const double cpu = report.meshCpu();
    const std::string size = std::to_string(q.nodes) + " nodes, " + std::to_string(q.elements) + " elements, hash " +
                             toHex(report.hash) + '\n' + extentLine(q.area, report.extent);
    char text[500];
    std::snprintf(
        text, sizeof text,
        "shape factor: mean %.4f, geometric mean %.4f, minimum %.4f; angles %.1f to %.1f degrees\n"
        "spacing conformity: mean %.4f\n"
        "%.3f s for the mesh (%.3f preparation, %.3f front, %.3f improvement), %.0f elements/s, peak %.1f MB\n",
        q.alphaMean, q.alphaGeometricMean, q.alphaMin, q.minAngle, q.maxAngle, q.deltaMean, cpu, report.secondsPrepare,
        report.secondsMesh, report.secondsImprove, cpu > 0.0 ? static_cast<double>(q.elements) / cpu : 0.0,
        static_cast<double>(report.peakBytes) / 1e6);
    return sharpCornerLines(report.sharp) + narrowPlaceLines(report.sharp) + size + text;
}

} // namespace forefront
