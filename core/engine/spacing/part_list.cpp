#include "core/engine/spacing/part_list.hpp"

#include "core/engine/spacing/parts/automatic/automatic.hpp"
#include "core/engine/spacing/parts/automatic/boundary_spacing.hpp"
#include "core/engine/spacing/parts/automatic/gap_sites.hpp"
#include "core/engine/spacing/parts/background/background_cover.hpp"
#include "core/engine/spacing/parts/background/limit_gradation.hpp"
#include "core/engine/spacing/parts/curvature/curvature_sites.hpp"
#include "core/engine/spacing/parts/expression/spacing_functions.hpp"
#include "core/engine/spacing/parts/node_sizes/node_size_sites.hpp"
#include "core/engine/spacing/parts/part_sizes/part_size_sites.hpp"
#include "core/engine/spacing/parts/sources/source_sites.hpp"
#include "core/engine/spacing/parts/steep_note.hpp"
#include "core/engine/spacing/sites/steep_sites.hpp"
#include "core/engine/spacing/spec/spec_check.hpp"

#include <algorithm>
#include <array>

namespace forefront {
namespace {

void neverFaulty(const SpacingSpec &, Diagnostics &) {}

/// Returns true if both are null or their contents are equal; shared content is not compared.
template <class T>
bool samePointed(const std::shared_ptr<const T> &a, const std::shared_ptr<const T> &b) {
    return a == b || (a && b && *a == *b);
}

Diagnostics addSize(const PartInput &input, FieldParts &parts) {
    parts.lowerCap(*input.spec.size, SpacingOrigin::Constant);
    return {};
}

Diagnostics addExpression(const PartInput &input, FieldParts &parts) {
    auto expression = ExpressionSpacing::build(input.spec, input.domain, input.faces.inside(), input.box);
    if (!expression) {
        return expression.faults();
    }
    const std::size_t before = parts.few.sites.size();
    addSteepSites([&](std::span<const Vec2> points, std::span<double> rho) { expression->atMany(points, rho); },
                  {SpacingOrigin::Expression, SiteReason::ExpressionEdge, 0}, input.steepSearch(), parts.few,
                  input.progress);
    if (!input.spec.gradation && parts.few.sites.size() > before) {
        parts.notes.push_back(steepNote("the spacing expression", parts.few.sites[before].a));
    }
    parts.point<ExpressionSpacing>() = std::move(*expression);
    return {};
}

/// Functions cannot be compared.
bool sameFunction(const SpacingSpec &a, const SpacingSpec &b) {
    return !a.hasFunction() && !b.hasFunction();
}

void checkRasterCells(const RasterMap &rasters, Diagnostics &faults) {
    for (const auto &[name, raster] : rasters) {
        const bool sound = raster != nullptr && raster->columns > 0 && raster->rows > 0 &&
                           raster->values.size() == raster->columns * raster->rows && raster->pitch.x > 0.0 &&
                           raster->pitch.y > 0.0 &&
                           std::any_of(raster->values.begin(), raster->values.end(),
                                       [](double value) { return std::isfinite(value); });
        const std::string wrong = checkRasterName(name);
        if (!sound || !wrong.empty()) {
            const Diagnostics fault =
                error("bad-raster", wrong.empty() ? "the raster '" + name + "' is invalid" : wrong,
                      "give it columns x rows values, at least one of them finite, and a pitch above 0");
            faults.insert(faults.end(), fault.begin(), fault.end());
        }
    }
}

void checkFunction(const SpacingSpec &spec, Diagnostics &faults) {
    if (spec.function && spec.bulkFunction) {
        const Diagnostics both = error("two-functions", "the spacing has both a function and a bulk function",
                                       "give one of them; the bulk function is faster");
        faults.insert(faults.end(), both.begin(), both.end());
    }
}

Diagnostics addFunction(const PartInput &input, FieldParts &parts) {
    auto function = FunctionSpacing::build(input.spec, input.domain, input.faces.inside(), input.box);
    if (!function) {
        return function.faults();
    }
    const std::size_t before = parts.few.sites.size();
    addSteepSites([&](std::span<const Vec2> points, std::span<double> rho) { function->atMany(points, rho); },
                  {SpacingOrigin::Function, SiteReason::FunctionEdge, 0}, input.steepSearch(), parts.few,
                  input.progress);
    if (!input.spec.gradation && parts.few.sites.size() > before) {
        parts.notes.push_back(steepNote("the size function", parts.few.sites[before].a));
    }
    parts.point<FunctionSpacing>() = std::move(*function);
    return {};
}

bool samePaint(const SpacingSpec &a, const SpacingSpec &b) {
    if (a.paint.tiles.empty() && b.paint.tiles.empty()) {
        return true; // what was painted is erased, or nothing ever was
    }
    return a.paint.origin == b.paint.origin && a.paint.pitch == b.paint.pitch && a.paint.replaces == b.paint.replaces &&
           std::equal(
               a.paint.tiles.begin(), a.paint.tiles.end(), b.paint.tiles.begin(), b.paint.tiles.end(),
               [](const auto &s, const auto &t) { return s.first == t.first && samePointed(s.second, t.second); });
}

Diagnostics addPaint(const PartInput &input, FieldParts &parts) {
    auto painted = PaintedPart::build(input.spec.paint, input.box, input.minimum);
    if (!painted) {
        return painted.faults();
    }
    parts.point<PaintedPart>() = std::move(*painted);
    PaintedPart::addSites(input.spec.paint, input.minimum, input.gradation, parts.few);
    return {};
}

Diagnostics addBackground(const PartInput &input, FieldParts &parts) {
    const BackgroundMesh &mesh = *input.spec.background;
    auto background = BackgroundPart::build(mesh, input.minimum, input.progress);
    if (!background) {
        return background.faults();
    }
    if (const auto gentle = input.spec.gradation
                                ? nullptr
                                : withoutSteepEdges(mesh, input.minimum, kSteepestGradation, input.progress)) {
        noteSteepMesh(*gentle, input, parts.notes);
        background = BackgroundPart::build(*gentle, input.minimum, input.progress);
        if (!background) {
            return background.faults();
        }
    }
    Diagnostics remarks = compareCover(mesh, *background, input);
    if (hasErrors(remarks)) {
        return remarks;
    }
    parts.notes.insert(parts.notes.end(), remarks.begin(), remarks.end());
    parts.point<FilledBackground>().emplace(std::move(*background));
    if (const auto gradation = input.spec.gradation) {
        BackgroundPart::addBorderSites(mesh, input.minimum, *gradation, parts.few, input.progress);
        BackgroundPart::addSteepSites(mesh, input.minimum, *gradation, parts.few);
    }
    return {};
}

Diagnostics addSources(const PartInput &input, FieldParts &parts) {
    addSourceSites(input.spec.sources, input.minimum, input.givenGradation(), parts.few);
    parts.point<GradedSources>() = GradedSources::build(input.spec.sources, input.givenGradation(), input.box);
    noteSteepSources(input, parts.notes);
    parts.point<BoxSources>() = BoxSources::build(input.spec.sources, input.minimum, input.givenGradation(), input.box);
    for (const SizeSource &source : input.spec.sources) {
        parts.words.sources.push_back(source.name);
    }
    return {};
}

Diagnostics addPartSizes(const PartInput &input, FieldParts &parts) {
    addPartSizeSites(input.domain, input.spec.partSizes, input.spec.placed.segments, input.minimum,
                     input.givenGradation(), parts.few);
    noteSteepParts(input, parts.notes);
    for (const auto &[tag, size] : input.spec.partSizes) {
        parts.words.parts[static_cast<std::uint32_t>(tag)] = boundaryName(input.domain.boundaryNames, tag);
    }
    return {};
}

Diagnostics addSegmentSizes(const PartInput &input, FieldParts &parts) {
    addSegmentSizeSites(input.domain, input.spec.placed, input.minimum, input.givenGradation(), parts.few);
    noteSteepSegments(input, parts.notes);
    return {};
}

Diagnostics addNodeSizes(const PartInput &input, FieldParts &parts) {
    addNodeSizeSites(input.spec.placed.nodes, input.minimum, input.givenGradation(), parts.few);
    noteSteepNodes(input, parts.notes);
    for (const NodeSize &node : input.spec.placed.nodes) {
        parts.words.nodes.push_back(node.name);
    }
    return {};
}

Diagnostics addBoundary(const PartInput &input, FieldParts &parts) {
    addBoundarySites(input.domain, input.minimum, input.gradation, parts.few);
    return {};
}

Diagnostics addBends(const PartInput &input, FieldParts &parts) {
    addCurvatureSites(input.domain, input.faces, curveChains(input.domain), input.spec.placed.counts(),
                      *input.spec.segmentsPerTurn, input.minimum, input.gradation, SpacingOrigin::Boundary, false,
                      input.progress, parts.few);
    return {};
}

Diagnostics addGaps(const PartInput &input, FieldParts &parts) {
    const SpacingSpec &spec = input.spec;
    double longest = std::min(parts.cap, spec.maximum.value_or(parts.cap));
    if (spec.usesAutomatic() && !spec.background) {
        longest = std::min(longest, std::max(automaticMaximum(input.box), largestRegionSize(spec.placed.regions)));
    }
    addGapSites(input.domain, input.faces, *spec.elementsAcross, std::min(longest, 0.5 * input.box.diagonal()),
                input.minimum, input.gradation, input.progress, parts.few);
    return {};
}

Diagnostics addRegions(const PartInput &input, FieldParts &parts) {
    parts.words.regions = namesOf(input.spec.placed.regions, input.domain, input.faces);
    noteSteepRegions(input, parts.words.regions, parts.notes);
    auto regions = RegionPart::build(input.spec.placed.regions, input.faces, input.minimum, input.spec.placed.quads);
    if (regions) {
        regions->addSites(input.gradation, input.givenGradation(), parts.few);
        parts.point<RegionPart>() = std::move(*regions);
    }
    return {};
}

// The order is also that of the sites, so it decides which of several equal ones the inspector names.
constexpr auto kKinds = std::to_array<SpacingPartKind>({
    {"size", [](const SpacingSpec &spec) { return spec.size.has_value(); },
     [](const SpacingSpec &spec, Diagnostics &faults) { checkSize(spec.size, "spacing", faults); },
     [](const SpacingSpec &a, const SpacingSpec &b) { return a.size == b.size; }, addSize},
    {"expression", [](const SpacingSpec &spec) { return spec.expression.has_value(); },
     [](const SpacingSpec &spec, Diagnostics &faults) { checkRasterCells(spec.rasters, faults); },
     [](const SpacingSpec &a, const SpacingSpec &b) {
         return a.expression == b.expression &&
                (!a.expression || (a.names == b.names && sameRasters(a.rasters, b.rasters)));
     },
     addExpression},
    {"function", [](const SpacingSpec &spec) { return spec.hasFunction(); }, checkFunction, sameFunction, addFunction},
    {"paint", [](const SpacingSpec &spec) { return !spec.paint.tiles.empty(); }, neverFaulty, samePaint, addPaint},
    {"background", [](const SpacingSpec &spec) { return spec.background != nullptr; }, neverFaulty,
     [](const SpacingSpec &a, const SpacingSpec &b) { return samePointed(a.background, b.background); }, addBackground},
    {"sources", [](const SpacingSpec &spec) { return !spec.sources.empty(); },
     [](const SpacingSpec &spec, Diagnostics &faults) { checkSources(spec.sources, faults); },
     [](const SpacingSpec &a, const SpacingSpec &b) {
         return a.sources == b.sources && a.keepAutomatic.value_or(false) == b.keepAutomatic.value_or(false);
     },
     addSources},
    {"partSizes", [](const SpacingSpec &spec) { return !spec.partSizes.empty(); },
     [](const SpacingSpec &spec, Diagnostics &faults) { checkPartSizes(spec.partSizes, faults); },
     [](const SpacingSpec &a, const SpacingSpec &b) { return a.partSizes == b.partSizes; }, addPartSizes},
    {"segmentSizes", [](const SpacingSpec &spec) { return !spec.placed.segments.empty(); },
     [](const SpacingSpec &spec, Diagnostics &faults) { checkSegmentSizes(spec.placed.segments, faults); },
     [](const SpacingSpec &a, const SpacingSpec &b) { return a.placed.segments == b.placed.segments; },
     addSegmentSizes},
    {"nodeSizes", [](const SpacingSpec &spec) { return !spec.placed.nodes.empty(); },
     [](const SpacingSpec &spec, Diagnostics &faults) { checkNodeSizes(spec.placed.nodes, faults); },
     [](const SpacingSpec &a, const SpacingSpec &b) { return a.placed.nodes == b.placed.nodes; }, addNodeSizes},
    {"fromBoundary", [](const SpacingSpec &spec) { return spec.fromBoundary; }, neverFaulty,
     [](const SpacingSpec &a, const SpacingSpec &b) { return a.fromBoundary == b.fromBoundary; }, addBoundary},
    {"segmentsPerTurn", [](const SpacingSpec &spec) { return spec.segmentsPerTurn.value_or(0.0) > 0.0; },
     [](const SpacingSpec &spec, Diagnostics &faults) { checkSegmentsPerTurn(spec.segmentsPerTurn, faults); },
     [](const SpacingSpec &a, const SpacingSpec &b) { return a.segmentsPerTurn == b.segmentsPerTurn; }, addBends},
    {"elementsAcross", [](const SpacingSpec &spec) { return spec.elementsAcross.value_or(0.0) > 0.0; },
     [](const SpacingSpec &spec, Diagnostics &faults) { checkElementsAcross(spec.elementsAcross, faults); },
     [](const SpacingSpec &a, const SpacingSpec &b) { return a.elementsAcross == b.elementsAcross; }, addGaps},
    {"regionSizes", [](const SpacingSpec &spec) { return !spec.placed.regions.empty(); },
     [](const SpacingSpec &spec, Diagnostics &faults) { checkRegions(spec.placed.regions, faults); },
     [](const SpacingSpec &a, const SpacingSpec &b) { return a.placed.regions == b.placed.regions; }, addRegions},
});

/// Checks that a list that is addressed by segment, such as "numbers of elements", has as many entries as there are
/// segments, or none.
void checkSegmentList(std::size_t count, const char *what, const char *code, const Domain &domain,
                      Diagnostics &faults) {
    if (count != 0 && count != domain.segments.size()) {
        faults.push_back(error(code,
                               std::string(what) + " are given for " + std::to_string(count) +
                                   " segments; expected one for each of the " + std::to_string(domain.segments.size()) +
                                   " segments of the domain, or none",
                               "give 0 where the spacing decides; after a repair, call carryElements()")
                             .front());
    }
}

} // namespace

std::span<const SpacingPartKind> spacingPartKinds() {
    return kKinds;
}

Diagnostics checkSpacing(const SpacingSpec &spec, const Domain &domain) {
    Diagnostics faults;
    checkLimits(spec, faults);
    for (const SpacingPartKind &kind : kKinds) {
        kind.check(spec, faults);
    }
    // Numbers of elements are no part of the field: they say how curves and lines are divided whatever it asks for.
    checkSegmentList(spec.placed.elements.size(), "numbers of elements", "bad-element-counts", domain, faults);
    checkSegmentList(spec.placed.biases.size(), "biases of elements", "bad-element-counts", domain, faults);
    checkBiases(spec.placed.biases, faults);
    checkSegmentList(spec.placed.segments.size(), "sizes along segments", "bad-segment-sizes", domain, faults);
    return faults;
}

bool sameContent(const SpacingSpec &a, const SpacingSpec &b) {
    return sameRasters(a.rasters, b.rasters) && a.minimum == b.minimum && a.maximum == b.maximum &&
           a.gradation == b.gradation && a.placed.elements == b.placed.elements && a.placed.biases == b.placed.biases &&
           std::all_of(kKinds.begin(), kKinds.end(), [&](const SpacingPartKind &kind) { return kind.same(a, b); });
}

} // namespace forefront
