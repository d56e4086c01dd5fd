#include "core/engine/pipeline/optional_periodic.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>

namespace forefront {

namespace {

/// Returns the tags of the segments that meet a crack of a job.
std::set<std::int32_t> tagsAtCracks(const MeshingJob &job) {
    std::set<std::int32_t> tags;
    if (job.cracks.empty()) {
        return tags;
    }
    std::set<std::uint32_t> nodes;
    for (const DomainSegment &segment : job.domain.segments) {
        if (std::find(job.cracks.begin(), job.cracks.end(), segment.tag) != job.cracks.end()) {
            nodes.insert({segment.a, segment.b});
        }
    }
    for (const DomainSegment &segment : job.domain.segments) {
        if (nodes.contains(segment.a) || nodes.contains(segment.b)) {
            tags.insert(segment.tag);
        }
    }
    return tags;
}

} // namespace

Diagnostics leaveOutExcludedPeriodic(MeshingJob &job, std::span<const PeriodicSpec> ofMesh) {
    if (ofMesh.empty()) {
        return {};
    }
    const std::string all = job.options.leastAngle ? "a least angle" : !job.layers.empty() ? "boundary layers" : "";
    const std::set<std::int32_t> cracked = tagsAtCracks(job);
    Diagnostics notes;
    std::erase_if(job.periodic, [&](const PeriodicSpec &spec) {
        const bool meets = cracked.contains(spec.from) || cracked.contains(spec.to);
        if (std::find(ofMesh.begin(), ofMesh.end(), spec) == ofMesh.end() || (all.empty() && !meets)) {
            return false;
        }
        Diagnostic &note = notes.emplace_back();
        note.severity = Severity::Note;
        note.code = "periodic";
        note.message = "the parts " + boundaryName(job.domain.boundaryNames, spec.from) + " and " +
                       boundaryName(job.domain.boundaryNames, spec.to) + " are periodic in the mesh that was read, " +
                       "which is not kept beside " + (all.empty() ? std::string("a crack") : all);
        return true;
    });
    return notes;
}

} // namespace forefront
