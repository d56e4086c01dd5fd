#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/crack_lines.hpp"
#include "core/engine/domain/unmarked_region.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/pipeline/stages.hpp"
#include "core/engine/refine/least_angle.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace forefront {

namespace {

Status validateLeastAngle(const MeshingJob &job) {
    const MeshingOptions &options = job.options;
    if (!options.leastAngle) {
        return {};
    }
    if (options.elements != Elements::Triangles) {
        return error("least-angle", "a least angle can be asked for triangles only",
                     "leave out the least angle, or choose triangles");
    }
    if (!job.layers.empty()) {
        return error("least-angle",
                     "a least angle cannot be had beside boundary layers, whose elements are long and thin",
                     "leave out the least angle, or the layers");
    }
    if (!(*options.leastAngle > 0.0 && *options.leastAngle <= kMaxLeastAngle)) {
        return error("least-angle", "the least angle is " + numberText(*options.leastAngle, 6) +
                                        "°; expected above 0 and at most " + numberText(kMaxLeastAngle, 6));
    }
    return {};
}

/// Refuses mapped faces together with what would divide their sides on one side alone.
Status validateMapped(const MeshingJob &job) {
    if (job.mapped.empty()) {
        return {};
    }
    if (!job.layers.empty()) {
        return error("mapped-layers", "boundary layers cannot be had beside mapped faces",
                     "leave out the boundary layers, or the mapped faces");
    }
    if (job.options.leastAngle) {
        return error("least-angle", "a least angle cannot be had beside mapped faces, whose rows stay",
                     "leave out the least angle, or the mapped faces");
    }
    return {};
}

/// Refuses strips together with what would divide their sides on one side alone.
Status validateStrips(const MeshingJob &job) {
    if (job.strips.empty()) {
        return {};
    }
    if (!job.layers.empty()) {
        return error("strip-layers", "boundary layers cannot be had beside strips",
                     "leave out the boundary layers, or the strips");
    }
    if (job.options.leastAngle) {
        return error("least-angle", "a least angle cannot be had beside strips, whose rows stay",
                     "leave out the least angle, or the strips");
    }
    if (job.options.keepBoundary) {
        return error("strip-boundary",
                     "strips cannot be had where every given segment stays as it is: their ends are divided by rows",
                     "let the boundary be divided, or leave out the strips");
    }
    return {};
}

/// Refuses wrong regions with elements of their own.
Status checkRegionElements(const MeshingJob &job, const DomainFaces &faces) {
    std::set<std::int32_t> known, seen;
    for (std::size_t face = 0; face < faces.labels.tag.size(); ++face) {
        if (faces.labels.inside[face] != 0) {
            known.insert(faces.labels.tag[face]);
        }
    }
    for (const RegionElements &own : job.regionElements) {
        const std::string name = "elements of the region " + regionName(job.domain.regionNames, own.region);
        if (!known.contains(own.region) && own.region != kUnmarkedRegion) {
            return error("unknown-region", name + ": no face of the domain belongs to it",
                         "choose a region of the domain");
        }
        if (!seen.insert(own.region).second) {
            return error("repeated-region", name + " are given twice", "keep one of them");
        }
    }
    if (!job.regionElements.empty() && job.options.leastAngle) {
        return error("least-angle", "a least angle cannot be had beside regions with elements of their own",
                     "leave out the least angle, or the elements of regions");
    }
    return {};
}

/// Ties the segments of periodic parts. Layers on them would have to be images of each other.
Status findPeriodic(MeshingState &state) {
    const MeshingJob &job = state.job;
    for (const LayerSpec &layer : job.layers) {
        if (std::ranges::any_of(job.periodic, [&](const PeriodicSpec &spec) {
                return spec.from == layer.tag || spec.to == layer.tag;
            })) {
            return error("periodic-layers",
                         "boundary layers on " + boundaryName(job.domain.boundaryNames, layer.tag) +
                             ": the part is periodic, so that the flow or field goes on across it",
                         "leave out the layers on this part, or its periodicity");
        }
    }
    Result<PeriodicSides> sides = findPeriodicSides(job.periodic, job.domain, state.faces, job.spacing.placed.counts());
    if (!sides) {
        return sides.faults();
    }
    state.periodic = std::move(*sides);
    return {};
}

} // namespace

Status validateStage(MeshingState &state, const Progress &progress) {
    progress("validating", 0.0);
    if (hasErrors(state.job.findings)) { // which the faults of the domain may follow from
        return state.job.findings;
    }
    if (Status faults = validateLeastAngle(state.job); !faults.empty()) {
        return faults;
    }
    if (Status faults = validateMapped(state.job); !faults.empty()) {
        return faults;
    }
    if (Status faults = validateStrips(state.job); !faults.empty()) {
        return faults;
    }
    Diagnostics faults = validate(state.job.domain, kMaxListedFaults, &state.faces);
    if (!hasErrors(faults)) {
        Diagnostics ofLayers = checkLayers(state.job.layers, state.job.domain);
        faults.insert(faults.end(), ofLayers.begin(), ofLayers.end());
    }
    if (!hasErrors(faults) && !state.job.regionElements.empty()) {
        Status ofRegions = checkRegionElements(state.job, state.faces);
        faults.insert(faults.end(), ofRegions.begin(), ofRegions.end());
    }
    if (!hasErrors(faults) && !state.job.periodic.empty()) {
        Status ofPeriodic = findPeriodic(state);
        faults.insert(faults.end(), ofPeriodic.begin(), ofPeriodic.end());
    }
    if (!hasErrors(faults) && !state.job.cracks.empty()) {
        Status ofCracks = checkCrackLines(state.job.cracks, state.job.periodic, state.job.domain, state.faces);
        faults.insert(faults.end(), ofCracks.begin(), ofCracks.end());
    }
    if (!hasErrors(faults) && !state.job.strips.empty()) {
        const MeshingJob &job = state.job;
        Status ofStrips = checkStrips(job.strips, job.domain, state.faces, job.cracks, job.periodic);
        faults.insert(faults.end(), ofStrips.begin(), ofStrips.end());
    }
    return faults;
}

} // namespace forefront
