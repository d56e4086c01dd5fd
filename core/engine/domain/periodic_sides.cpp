#include "core/engine/domain/periodic_sides.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/image_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace forefront {

namespace {

Diagnostics periodicFault(const char *code, std::string message, std::string advice, std::optional<Vec2> at = {}) {
    Diagnostics faults = error(code, std::move(message), std::move(advice));
    faults.front().at = at;
    return faults;
}

/// A part of the boundary.
struct PeriodicPart {
    std::string name;
    std::vector<std::uint32_t> segments;
    std::vector<std::uint32_t> nodes; ///< by place
    Vec2 centre;                      ///< of its length

    PeriodicPart(const Domain &domain, std::int32_t tag) : name(boundaryName(domain.boundaryNames, tag)) {
        double sum = 0.0;
        for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
            const DomainSegment &segment = domain.segments[s];
            if (segment.tag != tag) {
                continue;
            }
            const Vec2 a = domain.nodes[segment.a], b = domain.nodes[segment.b];
            segments.push_back(s);
            nodes.insert(nodes.end(), {segment.a, segment.b});
            centre += distance(a, b) * midpoint(a, b);
            sum += distance(a, b);
        }
        centre = sum > 0.0 ? (1.0 / sum) * centre : Vec2{};
        std::sort(nodes.begin(), nodes.end(), [&](std::uint32_t m, std::uint32_t n) {
            const Vec2 p = domain.nodes[m], q = domain.nodes[n];
            return p != q ? comesBefore(p, q) : m < n;
        });
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    }
};

/// Finds the motion between two parts and ties their segments.
class PeriodicSearch {
  public:
    PeriodicSearch(const Domain &domain, const DomainFaces &faces, std::int32_t from, std::int32_t to)
        : domain_(domain), faces_(faces), from_(domain, from), to_(domain, to),
          tolerance_(std::max(kPeriodicTolerance * domain.bounds().diagonal(), 1e-300)),
          images_(domain.nodes, to_.nodes, tolerance_) {
        for (const std::uint32_t s : to_.segments) {
            ends_.emplace(std::minmax(domain.segments[s].a, domain.segments[s].b), s);
        }
    }

    /// Ties the segments of both parts in `sides`, whose last link gets the map.
    Status run(PeriodicSides &sides) {
        if (Status faults = checkInside(); !faults.empty()) {
            return faults;
        }
        const RigidMap moved{1.0, 0.0, to_.centre - from_.centre};
        if (tries(moved)) {
            return tie(exact(moved), sides);
        }
        for (const RigidMap &turned : rotations()) {
            if (tries(turned)) {
                return tie(turned, sides);
            }
        }
        return notImages();
    }

  private:
    bool insideLeft(std::uint32_t s) const { return faces_.labels.inside[faces_.faces.left[s]] != 0; }
    bool insideRight(std::uint32_t s) const { return faces_.labels.inside[faces_.faces.right[s]] != 0; }

    Status checkInside() const {
        for (const PeriodicPart *part : {&from_, &to_}) {
            for (const std::uint32_t s : part->segments) {
                if (insideLeft(s) == insideRight(s)) {
                    const Vec2 at =
                        midpoint(domain_.nodes[domain_.segments[s].a], domain_.nodes[domain_.segments[s].b]);
                    return periodicFault("periodic-inside",
                                         "periodic part " + part->name + " has the domain on both sides at " +
                                             placeText(at) + "; expected a part of the outer boundary",
                                         "name only lines at the outside of the domain as periodic parts", at);
                }
            }
        }
        return {};
    }

    /// Returns the rotations that take the centre of the first part to that of the second, and its farthest node to a
    /// node, by the place of that node.
    std::vector<RigidMap> rotations() const {
        const auto away = [&](std::uint32_t n, const PeriodicPart &part) {
            return distance(domain_.nodes[n], part.centre);
        };
        const std::uint32_t farthest = *std::max_element(
            from_.nodes.begin(), from_.nodes.end(), [&](auto m, auto n) { return away(m, from_) < away(n, from_); });
        const Vec2 arm = domain_.nodes[farthest] - from_.centre;
        std::vector<RigidMap> maps;
        for (const std::uint32_t node : to_.nodes) {
            const Vec2 turned = domain_.nodes[node] - to_.centre;
            const double c = dot(arm, turned), s = cross(arm, turned), norm = std::hypot(c, s);
            if (std::abs(length(turned) - length(arm)) <= tolerance_ && norm > 0.0) {
                RigidMap map{c / norm, s / norm, {}};
                map.shift = domain_.nodes[node] - map(domain_.nodes[farthest]);
                maps.push_back(map);
            }
        }
        return maps;
    }

    /// Returns true if a motion takes the first part to the second; otherwise keeps what comes nearest.
    bool tries(const RigidMap &map) {
        std::size_t found = 0;
        std::optional<std::uint32_t> first;
        for (const std::uint32_t n : from_.nodes) {
            const bool has = images_.find(map(domain_.nodes[n])) != kNoIndex;
            found += has ? 1U : 0U;
            first = has || first ? first : std::optional(n);
        }
        if (!first && from_.nodes.size() == to_.nodes.size() && !missingSegment(map)) {
            return true;
        }
        if (!nearest_ || found > found_) {
            nearest_ = map;
            found_ = found;
            missing_ = first;
        }
        return false;
    }

    /// Returns the segment that the image of a segment is, with its direction; nothing if there is none.
    std::optional<PeriodicMate> mateOf(std::uint32_t s, const RigidMap &map) const {
        const DomainSegment &segment = domain_.segments[s];
        const std::uint32_t a = images_.find(map(domain_.nodes[segment.a])),
                            b = images_.find(map(domain_.nodes[segment.b]));
        if (a == kNoIndex || b == kNoIndex) {
            return std::nullopt;
        }
        const auto found = ends_.find(std::minmax(a, b));
        if (found == ends_.end()) {
            return std::nullopt;
        }
        const std::uint32_t other = found->second;
        const DomainSegment &image = domain_.segments[other];
        const bool reversed = image.a != a;
        // A copy with the domain on the same side would lie over it.
        if (insideLeft(s) == (reversed ? insideRight(other) : insideLeft(other))) {
            return std::nullopt;
        }
        if (segment.stretch.follows() != image.stretch.follows() || segment.role != image.role) {
            return std::nullopt;
        }
        if (segment.stretch.follows()) {
            for (const double part : {0.25, 0.5, 0.75}) {
                const Vec2 p = onCurve(segment.stretch, part), q = onCurve(image.stretch, reversed ? 1.0 - part : part);
                if (!(distance(map(p), q) <= tolerance_)) {
                    return std::nullopt;
                }
            }
        }
        return PeriodicMate{other, 0, false, reversed};
    }
    Vec2 onCurve(const CurveStretch &stretch, double part) const {
        return domain_.curves[stretch.curve].point(std::lerp(stretch.t0, stretch.t1, part));
    }

    std::optional<std::uint32_t> missingSegment(const RigidMap &map) const {
        for (const std::uint32_t s : from_.segments) {
            if (!mateOf(s, map)) {
                return s;
            }
        }
        return std::nullopt;
    }

    /// Returns a translation by the difference of two nodes that takes as many nodes as possible to their images to
    /// the bit; 0 where the difference is within the tolerance.
    RigidMap exact(const RigidMap &moved) const {
        std::vector<std::pair<Vec2, Vec2>> pairs;
        for (const std::uint32_t n : from_.nodes) {
            pairs.emplace_back(domain_.nodes[n], domain_.nodes[images_.find(moved(domain_.nodes[n]))]);
        }
        const auto component = [&](double Vec2::*axis) {
            const double difference = pairs.front().second.*axis - pairs.front().first.*axis;
            if (std::abs(difference) <= tolerance_) {
                return 0.0;
            }
            double best = difference;
            std::ptrdiff_t most = -1;
            for (const double shift :
                 {difference, std::nextafter(difference, -HUGE_VAL), std::nextafter(difference, HUGE_VAL)}) {
                const auto count = std::count_if(pairs.begin(), pairs.end(), [&](const auto &pair) {
                    return pair.first.*axis + shift == pair.second.*axis;
                });
                if (count > most) {
                    most = count;
                    best = shift;
                }
            }
            return best;
        };
        return {1.0, 0.0, {component(&Vec2::x), component(&Vec2::y)}};
    }

    Status tie(const RigidMap &map, PeriodicSides &sides) const {
        sides.links.back().map = map;
        for (const std::uint32_t s : from_.segments) {
            std::optional<PeriodicMate> mate = mateOf(s, map);
            if (!mate) {
                return notImages(); // at the limit of the tolerance
            }
            mate->link = static_cast<std::uint32_t>(sides.links.size() - 1);
            sides.mates[s] = *mate;
            sides.mates[mate->segment] = {s, mate->link, true, mate->reversed};
        }
        return {};
    }

    Status notImages() const {
        const char *advice = "make the second part a moved or turned copy of the first, node by node, with the domain "
                             "on the other side";
        const std::string parts = "periodic parts " + from_.name + " and " + to_.name;
        if (missing_) {
            const Vec2 at = domain_.nodes[*missing_], image = (*nearest_)(at);
            double away = HUGE_VAL;
            for (const std::uint32_t n : to_.nodes) {
                away = std::min(away, distance(domain_.nodes[n], image));
            }
            return periodicFault("periodic-sides",
                                 parts + " are not images of each other: node " + placeText(at) + " of " + from_.name +
                                     " would be at " + placeText(image) + ", but the nearest node of " + to_.name +
                                     " is " + numberText(away, 3) + " away; expected at most " +
                                     numberText(tolerance_, 3),
                                 advice, at);
        }
        if (from_.nodes.size() != to_.nodes.size()) {
            return periodicFault("periodic-sides",
                                 parts + " are not images of each other: they have " +
                                     std::to_string(from_.nodes.size()) + " and " + std::to_string(to_.nodes.size()) +
                                     " nodes",
                                 advice, domain_.nodes[from_.nodes.front()]);
        }
        const std::uint32_t s = missingSegment(*nearest_).value_or(from_.segments.front());
        const Vec2 at = midpoint(domain_.nodes[domain_.segments[s].a], domain_.nodes[domain_.segments[s].b]);
        return periodicFault("periodic-sides",
                             parts + " are not images of each other: the segment of " + from_.name + " at " +
                                 placeText(at) + " has no image with the domain on its other side",
                             advice, at);
    }

    const Domain &domain_;
    const DomainFaces &faces_;
    PeriodicPart from_, to_;
    double tolerance_; ///< domain units
    ImageNodes images_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> ends_; ///< segments of the second part by nodes
    std::optional<RigidMap> nearest_;        ///< the motion that takes most nodes to nodes
    std::size_t found_ = 0;                  ///< nodes that it takes to nodes
    std::optional<std::uint32_t> missing_{}; ///< the first node that it does not take to one
};

Status checkSpec(const PeriodicSpec &spec, const Domain &domain, std::set<std::int32_t> &seen) {
    std::set<std::int32_t> present;
    for (const DomainSegment &segment : domain.segments) {
        present.insert(segment.tag);
    }
    for (const std::int32_t tag : {spec.from, spec.to}) {
        const std::string name = boundaryName(domain.boundaryNames, tag);
        if (!present.contains(tag)) {
            std::string parts;
            for (const std::int32_t other : present) {
                parts += (parts.empty() ? "" : ", ") + boundaryName(domain.boundaryNames, other);
            }
            return periodicFault("unknown-boundary",
                                 "periodic part " + name + ": boundary part not found; expected one of " + parts,
                                 "choose two of these parts");
        }
        if (!seen.insert(tag).second) {
            return periodicFault("repeated-periodic", "periodic part " + name + " is given twice",
                                 "tie each part to one other part");
        }
    }
    return {};
}

/// Returns the fault of numbers of elements that differ from those of the other part.
Status checkElements(const PeriodicSides &sides, const Domain &domain, SegmentElements elements) {
    for (std::uint32_t s = 0; s < sides.mates.size(); ++s) {
        const PeriodicMate &mate = sides.mates[s];
        if (mate.segment == kNoIndex || !mate.follows || elements[s] == 0) {
            continue;
        }
        const ElementBias bias = mate.reversed ? elements.bias(s).reversed() : elements.bias(s);
        if (elements[mate.segment] != elements[s] || !(elements.bias(mate.segment) == bias)) {
            const Vec2 at = midpoint(domain.nodes[domain.segments[s].a], domain.nodes[domain.segments[s].b]);
            return periodicFault("periodic-elements",
                                 "the segment of periodic part " +
                                     boundaryName(domain.boundaryNames, domain.segments[s].tag) + " at " +
                                     placeText(at) + " has its own number of elements or bias",
                                 "set the numbers of elements on the first of the two parts only, or equally", at);
        }
    }
    return {};
}

} // namespace

Result<PeriodicSides> findPeriodicSides(std::span<const PeriodicSpec> specs, const Domain &domain,
                                        const DomainFaces &faces, SegmentElements elements) {
    PeriodicSides sides;
    std::set<std::int32_t> seen;
    for (const PeriodicSpec &spec : specs) {
        if (Status faults = checkSpec(spec, domain, seen); !faults.empty()) {
            return faults;
        }
        sides.mates.resize(domain.segments.size());
        sides.links.push_back({spec.from, spec.to, {}});
        if (Status faults = PeriodicSearch(domain, faces, spec.from, spec.to).run(sides); !faults.empty()) {
            return faults;
        }
    }
    if (Status faults = checkElements(sides, domain, elements); !faults.empty()) {
        return faults;
    }
    return sides;
}

} // namespace forefront
