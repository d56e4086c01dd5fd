#include "core/engine/mesh/limits.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/mesh/flat_stacks.hpp"
#include "core/engine/mesh/islands.hpp"

namespace forefront {

namespace {

constexpr double kNoMaximum = std::numeric_limits<double>::infinity();
constexpr double kTiny = std::numeric_limits<double>::min();

constexpr std::array<LimitInfo, wordsOf<MeshLimit>().size()> kLimitInfos = {{
    {"minimum angle", "minAngle", Measure::MinAngle, true, 0.0, 90.0, "Smallest angle allowed, in degrees"},
    {"maximum angle", "maxAngle", Measure::MaxAngle, false, 60.0, 180.0, "Largest angle allowed, in degrees"},
    {"minimum \xce\xb1", "minAlpha", Measure::ShapeFactor, true, 0.0, 1.0, "Smallest shape factor \xce\xb1 allowed"},
    {"minimum scaled Jacobian", "minScaledJacobian", Measure::ScaledJacobian, true, 0.0, 1.0,
     "Smallest scaled Jacobian allowed: 1 for equilateral triangles and squares, 0 for flat elements"},
    {"maximum aspect ratio", "maxAspect", Measure::Aspect, false, 1.0, 1e9,
     "Largest ratio allowed of the length of an element to its height, such as along boundary layers"},
    {"maximum layer aspect", "maxLayerAspect", Measure::Aspect, false, 1.0, 1e9,
     "Largest ratio allowed of length to height in boundary layers, the flat elements that are stacked on the "
     "boundary; "
     "with it, the maximum aspect ratio is one of the other elements"},
    {"maximum growth", "maxGrowth", Measure::AreaRatio, false, 1.0, 1e6,
     "Largest ratio allowed between the areas of elements that share an edge"},
    {"minimum edge length", "minLength", Measure::Length, true, kTiny, kNoMaximum, "Shortest edge allowed"},
    {"maximum edge length", "maxLength", Measure::Length, false, kTiny, kNoMaximum, "Longest edge allowed"},
    {"minimum \xce\xb4", "minDelta", Measure::Conformity, true, 0.0, 1.0,
     "Smallest spacing conformity \xce\xb4 = min(L/\xcf\x81, \xcf\x81/L) allowed; needs a spacing"},
    {"minimum across gaps", "minAcross", Measure::Across, true, 1.0, 1000.0,
     "Smallest number of elements allowed between facing parts of the boundary, interfaces and inner lines"},
    {"maximum valence", "maxValence", Measure::Valence, false, 3.0, 1000.0,
     "Largest number of elements allowed around a node"},
    {"minimum island area", "minIslandArea", Measure::IslandArea, true, kTiny, kNoMaximum,
     "Smallest area allowed of an island, a hole of the mesh, in square domain units"},
}};

bool breaks(const LimitInfo &info, double bound, double value) {
    constexpr double kRounding = 1e-9;
    const double slack = kRounding * std::abs(bound);
    return info.isMinimum ? value < bound - slack : value > bound + slack;
}

/// Returns for each edge the area of an island, but only at its first edge: an island counts once.
std::vector<double> areaPerIsland(const MeshView &mesh, const MeshEdges &edges) {
    std::vector<double> values(edges.edges.size(), std::numeric_limits<double>::quiet_NaN());
    for (const MeshIsland &island : islandsOf(mesh, edges)) {
        values[island.edges.front()] = island.area;
    }
    return values;
}

/// Returns the aspect ratios of the elements that a limit is for: of those in boundary layers, or, where these have a
/// limit of their own, of the others.
std::vector<double> aspectsFor(MeshLimit limit, const MeshView &mesh, const MeshEdges &edges,
                               const MeshLimits &limits) {
    std::vector<double> values = measureValues(Measure::Aspect, mesh, edges, nullptr);
    if (!limits[MeshLimit::MaxLayerAspect]) {
        return values;
    }
    const std::vector<bool> inLayers = elementsOfFlatStacks(mesh, edges);
    for (std::size_t e = 0; e < values.size(); ++e) {
        if (inLayers[e] != (limit == MeshLimit::MaxLayerAspect)) {
            values[e] = std::numeric_limits<double>::quiet_NaN();
        }
    }
    return values;
}

std::vector<double> valuesFor(MeshLimit limit, const MeshView &mesh, const MeshEdges &edges, const MeshLimits &limits,
                              const SpacingField *spacing) {
    switch (limit) {
    case MeshLimit::MinIslandArea:
        return areaPerIsland(mesh, edges);
    case MeshLimit::MaxAspect:
    case MeshLimit::MaxLayerAspect:
        return aspectsFor(limit, mesh, edges, limits);
    default:
        return measureValues(limitInfo(limit).measure, mesh, edges, spacing);
    }
}

LimitVerdict verdictOf(MeshLimit limit, double bound, const MeshView &mesh, const MeshEdges &edges,
                       const std::vector<double> &values, std::size_t places) {
    const LimitInfo &info = limitInfo(limit);
    LimitVerdict verdict;
    verdict.limit = limit;
    verdict.bound = bound;
    std::vector<LimitPlace> broken;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = values[i];
        if (std::isnan(value)) {
            continue;
        }
        const bool worse = verdict.judged == 0 || (info.isMinimum ? value < verdict.worst : value > verdict.worst);
        verdict.worst = worse ? value : verdict.worst;
        ++verdict.judged;
        if (breaks(info, bound, value)) {
            broken.push_back({static_cast<std::uint32_t>(i), value, {}});
        }
    }
    verdict.broken = broken.size();
    const std::size_t listed = std::min(places, broken.size());
    std::partial_sort(broken.begin(), broken.begin() + static_cast<std::ptrdiff_t>(listed), broken.end(),
                      [&](const LimitPlace &a, const LimitPlace &b) {
                          return a.value == b.value ? a.part < b.part : (a.value < b.value) == info.isMinimum;
                      });
    broken.resize(listed);
    for (LimitPlace &place : broken) {
        place.at = placeOf(mesh, edges, infoOf(info.measure).part, place.part);
        if (infoOf(info.measure).part == MeshPart::Edges) {
            place.ends = {edges.edges[place.part].a, edges.edges[place.part].b};
        }
    }
    verdict.places = std::move(broken);
    return verdict;
}

} // namespace

const LimitInfo &limitInfo(MeshLimit limit) {
    return kLimitInfos[static_cast<std::size_t>(limit)];
}

bool MeshLimits::any() const {
    return std::any_of(values.begin(), values.end(), [](const auto &value) { return value.has_value(); });
}

Diagnostics warningsOf(std::span<const LimitVerdict> verdicts) {
    Diagnostics warnings;
    for (const LimitVerdict &verdict : verdicts) {
        if (!verdict.met()) {
            Diagnostics warning = error("limit", "the mesh violates a limit: " + toString(verdict),
                                        "a check of the mesh lists the places");
            warning.front().severity = Severity::Warning;
            warnings.push_back(std::move(warning.front()));
        }
    }
    return warnings;
}

std::string valueText(MeshLimit limit, double value) {
    return numberText(value, 4) + infoOf(limitInfo(limit).measure).unit;
}

MeshLimits mergedLimits(MeshLimits limits, const MeshLimits &given) {
    for (const MeshLimit limit : valuesOf<MeshLimit>()) {
        limits[limit] = given[limit] ? given[limit] : limits[limit];
    }
    return limits;
}

std::string limitFault(MeshLimit limit, double value) {
    const LimitInfo &info = limitInfo(limit);
    if (value >= info.minimum && value <= info.maximum && std::isfinite(value)) {
        return {};
    }
    const std::string range =
        info.minimum > 0.0 && info.maximum == kNoMaximum
            ? "a positive number"
            : "a number from " + numberText(info.minimum, 6) + " to " + numberText(info.maximum, 6);
    return "expected " + range + ", got " + numberText(value, 6);
}

std::vector<LimitVerdict> checkLimits(const MeshView &mesh, const MeshEdges &edges, const MeshLimits &limits,
                                      const SpacingField *spacing, std::size_t places) {
    std::vector<LimitVerdict> verdicts;
    for (const MeshLimit limit : valuesOf<MeshLimit>()) {
        if (const std::optional<double> bound = limits[limit]) {
            verdicts.push_back(
                verdictOf(limit, *bound, mesh, edges, valuesFor(limit, mesh, edges, limits, spacing), places));
        }
    }
    return verdicts;
}

std::vector<LimitVerdict> checkLimits(const MeshView &mesh, const MeshLimits &limits, const SpacingField *spacing,
                                      std::size_t places) {
    return limits.any() ? checkLimits(mesh, edgesOf(mesh), limits, spacing, places) : std::vector<LimitVerdict>();
}

std::string toString(const LimitVerdict &verdict) {
    const LimitInfo &info = limitInfo(verdict.limit);
    const std::string head = std::string(info.name) + ' ' + valueText(verdict.limit, verdict.bound) + ": ";
    if (verdict.judged == 0) {
        return head + (verdict.limit == MeshLimit::MinDelta         ? "not checked: there is no spacing"
                       : verdict.limit == MeshLimit::MinAcross      ? "met: nothing faces across a gap"
                       : verdict.limit == MeshLimit::MinIslandArea  ? "met: there are no islands"
                       : verdict.limit == MeshLimit::MaxLayerAspect ? "met: there are no boundary layers"
                                                                    : "met: there is nothing to measure");
    }
    const std::string worst = "worst " + valueText(verdict.limit, verdict.worst);
    if (verdict.met()) {
        return head + "met, " + worst;
    }
    const std::string parts =
        verdict.limit == MeshLimit::MinIslandArea ? "islands" : std::string(wordOf(infoOf(info.measure).part)) + 's';
    std::string text = head + "violated by " + std::to_string(verdict.broken) + " of " +
                       std::to_string(verdict.judged) + ' ' + parts + ", " + worst;
    return verdict.places.empty() ? text : text + " at " + placeText(verdict.places.front().at);
}

Diagnostics faultsOf(const LimitVerdict &verdict, const MeshNumbers &numbers) {
    const MeasureInfo &measure = infoOf(limitInfo(verdict.limit).measure);
    const auto nameOf = [&](const LimitPlace &place) {
        const auto node = [&](NodeId id) { return std::to_string(numbers.nodes.of(index(id))); };
        return measure.part == MeshPart::Edges      ? node(place.ends[0]) + '-' + node(place.ends[1])
               : measure.part == MeshPart::Elements ? std::to_string(numbers.elements.of(place.part))
                                                    : std::to_string(numbers.nodes.of(place.part));
    };
    Diagnostics faults;
    for (const LimitPlace &place : verdict.places) {
        Diagnostic fault;
        fault.code = wordOf(verdict.limit);
        fault.message = std::string(wordOf(measure.part)) + ' ' + nameOf(place) + ": " + measure.symbol + ' ' +
                        valueText(verdict.limit, place.value) + " violates the limit " +
                        valueText(verdict.limit, verdict.bound);
        fault.at = place.at;
        fault.ids = {place.part};
        faults.push_back(std::move(fault));
    }
    return faults;
}

} // namespace forefront
