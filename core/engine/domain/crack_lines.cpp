#include "core/engine/domain/crack_lines.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

Diagnostics crackFault(const char *code, std::string what, const char *advice, Vec2 at) {
    Diagnostics faults = error(code, std::move(what), advice);
    faults.front().at = at;
    return faults;
}

std::set<std::uint32_t> nodesOfPeriodic(std::span<const PeriodicSpec> periodic, const Domain &domain) {
    std::set<std::uint32_t> nodes;
    for (const DomainSegment &segment : domain.segments) {
        if (std::any_of(periodic.begin(), periodic.end(),
                        [&](const PeriodicSpec &spec) { return segment.tag == spec.from || segment.tag == spec.to; })) {
            nodes.insert({segment.a, segment.b});
        }
    }
    return nodes;
}

} // namespace

Diagnostics checkCrackLines(std::span<const std::int32_t> cracks, std::span<const PeriodicSpec> periodic,
                            const Domain &domain, const DomainFaces &faces) {
    const std::set<std::uint32_t> paired = nodesOfPeriodic(periodic, domain);
    std::map<std::int32_t, std::vector<std::uint32_t>> lines;
    for (const std::int32_t tag : cracks) {
        lines[tag];
    }
    for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
        if (const auto line = lines.find(domain.segments[s].tag); line != lines.end()) {
            line->second.push_back(s);
        }
    }
    std::set<std::int32_t> seen;
    for (const std::int32_t tag : cracks) {
        const std::string name = "crack " + boundaryName(domain.boundaryNames, tag);
        if (!seen.insert(tag).second) {
            return error("repeated-crack", name + " is given twice", "keep one of them");
        }
        for (const std::uint32_t s : lines[tag]) {
            const DomainSegment &segment = domain.segments[s];
            if (faces.labels.inside[faces.faces.left[s]] == 0 || faces.labels.inside[faces.faces.right[s]] == 0) {
                return crackFault(
                    "crack-outside", name + " has the domain on one side alone; expected a line inside the domain",
                    "name only inner lines as cracks", midpoint(domain.nodes[segment.a], domain.nodes[segment.b]));
            }
            for (const std::uint32_t node : {segment.a, segment.b}) {
                if (paired.contains(node)) {
                    return crackFault(
                        "crack-periodic", name + " ends on a periodic part, whose nodes are paired one to one",
                        "end the crack inside the domain, or leave out the periodic parts", domain.nodes[node]);
                }
            }
        }
        if (lines[tag].empty()) {
            return error("unknown-boundary", name + ": boundary part not found", "choose a line of the domain");
        }
    }
    return {};
}

} // namespace forefront
