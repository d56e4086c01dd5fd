#include "core/engine/spacing/parts/steep_note.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/spacing/parts/sources/graded_sources.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace forefront {
namespace {

/// Returns the maximum change of the size along the line of a source per unit of length.
double slopeAlong(const SizeSource &source) {
    const double end = source.endSize.value_or(source.size), length = distance(source.a, source.b);
    return source.geometric && source.plane
               ? std::max(source.size, end) * std::fabs(std::log(end / source.size)) / length
               : std::fabs(end - source.size) / length;
}

Diagnostic remark(std::string message, std::string advice, std::optional<Vec2> at) {
    Diagnostic note;
    note.severity = Severity::Note;
    note.code = "steep-spacing";
    note.message = std::move(message);
    note.advice = std::move(advice);
    note.at = at;
    return note;
}

void noteGrowth(const PartInput &input, const std::string &owner, double growth, std::optional<Vec2> at,
                Diagnostics &notes) {
    if (!input.spec.gradation && growth > kSteepestGradation) {
        notes.push_back(remark(owner + " grows by " + numberText(growth, 4) +
                                   " per unit of distance, which elements cannot follow; expected at most " +
                                   numberText(kSteepestGradation, 4),
                               "set a gradation to limit it", at));
    }
}

} // namespace

Diagnostic steepNote(const std::string &what, Vec2 at) {
    const std::string limit = numberText(kSteepestGradation, 4);
    return remark(what + " changes by more than " + limit +
                      " per unit of distance, which elements cannot follow; limited to " + limit,
                  "set a gradation for another limit", at);
}

void noteSteepSources(const PartInput &input, Diagnostics &notes) {
    for (std::size_t i = 0; i < input.spec.sources.size(); ++i) {
        const SizeSource &source = input.spec.sources[i];
        const double slope = isGraded(source) ? slopeAlong(source) : 0.0;
        noteGrowth(input, "size source " + (source.name.empty() ? std::to_string(i) : "'" + source.name + "'"),
                   source.plane ? slope : std::hypot(slope, source.growth), source.a, notes);
    }
}

void noteSteepParts(const PartInput &input, Diagnostics &notes) {
    for (const auto &[tag, part] : input.spec.partSizes) {
        noteGrowth(input, "the size of '" + boundaryName(input.domain.boundaryNames, tag) + "'", part.growth, {},
                   notes);
    }
}

void noteSteepSegments(const PartInput &input, Diagnostics &notes) {
    const std::vector<PartSize> &sizes = input.spec.placed.segments;
    const std::vector<DomainSegment> &segments = input.domain.segments;
    for (std::size_t s = 0; s < sizes.size(); ++s) {
        const bool noted = s > 0 && sizes[s - 1] == sizes[s] && segments[s - 1].tag == segments[s].tag; // next chord
        if (sizes[s].size != 0.0 && !noted) {
            noteGrowth(input,
                       "the size of a segment of '" + boundaryName(input.domain.boundaryNames, segments[s].tag) + "'",
                       sizes[s].growth, input.domain.nodes[segments[s].a], notes);
        }
    }
}

void noteSteepNodes(const PartInput &input, Diagnostics &notes) {
    for (const NodeSize &node : input.spec.placed.nodes) {
        noteGrowth(input, "the size at " + (node.name.empty() ? "a node" : node.name), node.growth, node.at, notes);
    }
}

void noteSteepRegions(const PartInput &input, std::span<const std::string> names, Diagnostics &notes) {
    const std::vector<RegionSize> &regions = input.spec.placed.regions;
    for (std::size_t k = 0; k < regions.size(); ++k) {
        if (regions[k].size > 0.0) {
            noteGrowth(input, "the size of region '" + names[k] + "'", regions[k].growth, regions[k].at, notes);
        }
    }
}

void noteSteepMesh(const BackgroundMesh &gentle, const PartInput &input, Diagnostics &notes) {
    const BackgroundMesh &given = *input.spec.background;
    const InsideTest *const inside = input.faces.inside();
    for (std::size_t n = 0; n < gentle.nodes.size(); ++n) {
        if (gentle.values[n] < given.values[n] && inside != nullptr && inside->contains(gentle.nodes[n])) {
            notes.push_back(steepNote("the background mesh", gentle.nodes[n]));
            return;
        }
    }
}

} // namespace forefront
