#include "core/engine/pipeline/optional_periodic.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <string>

namespace forefront {

namespace {

/// Returns the tags of the segments that meet lines with some tags.
std::set<std::int32_t> tagsAt(const Domain &domain, const std::set<std::int32_t> &lines) {
    std::set<std::int32_t> tags;
    std::set<std::uint32_t> nodes;
    for (const DomainSegment &segment : domain.segments) {
        if (lines.contains(segment.tag)) {
            nodes.insert({segment.a, segment.b});
        }
    }
    for (const DomainSegment &segment : domain.segments) {
        if (nodes.contains(segment.a) || nodes.contains(segment.b)) {
            tags.insert(segment.tag);
        }
    }
    return tags;
}

/// Returns the tags of the parts that cannot be periodic, with the reason.
std::map<std::int32_t, std::string> excludedTags(const MeshingJob &job) {
    std::map<std::int32_t, std::string> excluded;
    for (const LayerSpec &layer : job.layers) {
        excluded.emplace(layer.tag, "boundary layers on them");
    }
    for (const std::int32_t tag : tagsAt(job.domain, {job.cracks.begin(), job.cracks.end()})) {
        excluded.emplace(tag, "a crack");
    }
    std::set<std::int32_t> strips;
    std::ranges::transform(job.strips, std::inserter(strips, strips.end()), &StripSpec::tag);
    for (const std::int32_t tag : tagsAt(job.domain, strips)) {
        excluded.emplace(tag, "a strip");
    }
    return excluded;
}

} // namespace

Diagnostics leaveOutExcludedPeriodic(MeshingJob &job, std::span<const PeriodicSpec> ofMesh) {
    if (ofMesh.empty()) {
        return {};
    }
    const std::map<std::int32_t, std::string> excluded = excludedTags(job);
    Diagnostics notes;
    std::erase_if(job.periodic, [&](const PeriodicSpec &spec) {
        auto reason = excluded.find(spec.from);
        reason = reason == excluded.end() ? excluded.find(spec.to) : reason;
        if (reason == excluded.end() || std::find(ofMesh.begin(), ofMesh.end(), spec) == ofMesh.end()) {
            return false;
        }
        Diagnostic &note = notes.emplace_back();
        note.severity = Severity::Note;
        note.code = "periodic";
        note.message = "the parts " + boundaryName(job.domain.boundaryNames, spec.from) + " and " +
                       boundaryName(job.domain.boundaryNames, spec.to) +
                       " are periodic in the mesh that was read, which is not kept beside " + reason->second;
        return true;
    });
    return notes;
}

} // namespace forefront
