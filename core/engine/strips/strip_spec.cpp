#include "core/engine/strips/strip_spec.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/domain_graph.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

std::optional<Diagnostic> stripFault(const StripSpec &spec, std::string_view owner) {
    const auto fault = [&](const std::string &what, const char *advice) {
        return error("bad-strip", "strip " + std::string(owner) + ": " + what, advice).front();
    };
    if (!(spec.width > 0.0 && std::isfinite(spec.width))) {
        return fault("expected a width above 0, got " + numberText(spec.width, 6), "set the width of the strip");
    }
    if (spec.rows < 1 || spec.rows > kMaxStripRows) {
        return fault("expected 1 to " + std::to_string(kMaxStripRows) + " rows, got " + std::to_string(spec.rows),
                     "choose a number of rows within this range");
    }
    if (spec.region < 0) {
        return fault("expected a region tag of 1 or more, got " + std::to_string(spec.region),
                     "choose another tag, or leave it out");
    }
    return std::nullopt;
}

namespace {

/// Checks each line against the domain that it lies in.
class StripCheck {
  public:
    StripCheck(const Domain &domain, const DomainFaces &faces, std::span<const std::int32_t> cracks,
               std::span<const PeriodicSpec> periodic)
        : domain_(domain), faces_(faces), cracks_(cracks.begin(), cracks.end()) {
        for (const PeriodicSpec &spec : periodic) {
            periodic_.insert({spec.from, spec.to});
        }
        for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
            const DomainSegment &segment = domain.segments[s];
            segments_[segment.tag].push_back(s);
            if (periodic_.contains(segment.tag)) {
                paired_.insert({segment.a, segment.b});
            }
        }
    }

    Diagnostics check(const StripSpec &spec) {
        const std::string name = boundaryName(domain_.boundaryNames, spec.tag);
        const auto line = segments_.find(spec.tag);
        if (line == segments_.end()) {
            return error("unknown-boundary", "strip " + name + ": line not found",
                         "choose an inner line of the domain");
        }
        if (!seen_.insert(spec.tag).second) {
            return error("repeated-strip", "strip " + name + " is given twice", "keep one of them");
        }
        if (std::optional<Diagnostic> fault = stripFault(spec, name)) {
            return {std::move(*fault)};
        }
        if (cracks_.contains(spec.tag)) {
            return error("strip-line", "strip " + name + " is a crack, too; expected one of both",
                         "leave out the crack, or the strip");
        }
        for (const std::uint32_t s : line->second) {
            if (Diagnostics faults = checkSegment(name, s); !faults.empty()) {
                return faults;
            }
        }
        return {};
    }

  private:
    Diagnostics checkSegment(const std::string &name, std::uint32_t s) const {
        const DomainSegment &segment = domain_.segments[s];
        if (faces_.labels.inside[faces_.faces.left[s]] == 0 || faces_.labels.inside[faces_.faces.right[s]] == 0) {
            Diagnostics faults =
                error("strip-outside",
                      "strip " + name + " has the domain on one side alone; expected a line inside the domain",
                      "name only inner lines as strips");
            faults.front().at = midpoint(domain_.nodes[segment.a], domain_.nodes[segment.b]);
            return faults;
        }
        for (const std::uint32_t node : {segment.a, segment.b}) {
            if (paired_.contains(node)) {
                Diagnostics faults =
                    error("strip-line", "strip " + name + " meets a periodic part, whose nodes are paired one to one",
                          "end the strip inside the domain, or leave out the periodic parts");
                faults.front().at = domain_.nodes[node];
                return faults;
            }
        }
        return {};
    }

    const Domain &domain_;
    const DomainFaces &faces_;
    std::set<std::int32_t> cracks_, periodic_, seen_; ///< tags
    std::set<std::uint32_t> paired_;                  ///< nodes of periodic parts
    std::map<std::int32_t, std::vector<std::uint32_t>> segments_;
};

} // namespace

Diagnostics checkStrips(std::span<const StripSpec> specs, const Domain &domain, const DomainFaces &faces,
                        std::span<const std::int32_t> cracks, std::span<const PeriodicSpec> periodic) {
    if (specs.empty()) {
        return {};
    }
    StripCheck check(domain, faces, cracks, periodic);
    for (const StripSpec &spec : specs) {
        if (Diagnostics faults = check.check(spec); !faults.empty()) {
            return faults;
        }
    }
    return {};
}

} // namespace forefront
