#include "core/engine/domain/part_names.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/unused_tag.hpp"
#include "core/engine/domain/validate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>

namespace forefront {

namespace {

/// The boundary of a domain as steps from node to node with the domain on the left.
class BoundaryWalk {
  public:
    struct Step {
        std::uint32_t from, to; ///< points of the graph; nodes at one place are one point
        std::uint32_t segment;
    };

    BoundaryWalk(const Domain &domain, const DomainFaces &found) : points_(found.graph.points) {
        for (std::uint32_t e = 0; e < found.graph.edges.size(); ++e) {
            const std::uint32_t segment = found.graph.segment[e];
            const bool left = found.labels.inside[found.faces.left[e]] != 0;
            const bool right = found.labels.inside[found.faces.right[e]] != 0;
            if (domain.segments[segment].role == SegmentRole::Boundary && left != right) {
                const std::uint32_t a = found.sweep.canonical[found.graph.edges[e].a];
                const std::uint32_t b = found.sweep.canonical[found.graph.edges[e].b];
                steps_.push_back(left ? Step{a, b, segment} : Step{b, a, segment});
            }
        }
        std::sort(steps_.begin(), steps_.end(), [](const Step &one, const Step &other) {
            return one.from != other.from ? one.from < other.from : one.segment < other.segment;
        });
    }

    Vec2 place(std::uint32_t point) const { return points_[point]; }

    /// Returns the point of the boundary nearest to a place; of several, the first. kNoIndex: there is no boundary.
    std::uint32_t nearest(Vec2 place) const {
        std::uint32_t best = kNoIndex;
        double least = std::numeric_limits<double>::infinity();
        for (const Step &step : steps_) {
            if (const double d = distanceSquared(points_[step.from], place); d < least) {
                least = d;
                best = step.from;
            }
        }
        return best;
    }

    /// Returns the steps from one point to another, the shortest of the ways that leave the first; empty if none leads
    /// there.
    std::vector<Step> between(std::uint32_t from, std::uint32_t to) const {
        std::vector<Step> best;
        for (auto first = leaving(from); first != steps_.end() && first->from == from; ++first) {
            std::vector<Step> way{*first};
            while (way.back().to != to && way.size() <= steps_.size()) {
                const Step next = after(way.back());
                if (next.segment == first->segment) {
                    break; // once around the loop
                }
                way.push_back(next);
            }
            if (way.back().to == to && (best.empty() || lengthOf(way) < lengthOf(best))) {
                best = std::move(way);
            }
        }
        return best;
    }

    double lengthOf(const std::vector<Step> &way) const {
        double sum = 0.0;
        for (const Step &step : way) {
            sum += distance(points_[step.from], points_[step.to]);
        }
        return sum;
    }

  private:
    std::vector<Step>::const_iterator leaving(std::uint32_t point) const {
        return std::lower_bound(steps_.begin(), steps_.end(), point,
                                [](const Step &step, std::uint32_t value) { return step.from < value; });
    }

    /// Returns the next step around the face on the left: where loops touch, the first one clockwise from where the
    /// given step comes from.
    Step after(const Step &step) const {
        const auto clockwise = [&](const Step &next) {
            const Vec2 back = points_[step.from] - points_[step.to], on = points_[next.to] - points_[next.from];
            const double turn = std::atan2(back.y, back.x) - std::atan2(on.y, on.x);
            return turn > 0.0 ? turn : turn + 2.0 * std::numbers::pi;
        };
        auto best = leaving(step.to);
        for (auto next = best; next != steps_.end() && next->from == step.to; ++next) {
            best = clockwise(*next) < clockwise(*best) ? next : best;
        }
        return *best; // every point that a step enters is left by one: the boundary has no ends
    }

    std::vector<Vec2> points_;
    std::vector<Step> steps_; ///< by point that they leave
};

std::string spanText(const Box2 &box) {
    return placeText(box.min) + " to " + placeText(box.max);
}

/// Returns the tag of a boundary part by its name or default name, or a new tag with this name.
std::int32_t tagNamed(const std::string &name, Domain &domain) {
    std::set<std::int32_t> tags;
    for (const DomainSegment &segment : domain.segments) {
        tags.insert(segment.tag);
    }
    for (const ConstraintPoint &point : domain.points) {
        tags.insert(point.tag);
    }
    for (const std::int32_t tag : tags) {
        if (boundaryName(domain.boundaryNames, tag) == name) {
            return tag;
        }
    }
    const std::int32_t tag = unusedTag(tags, domain.boundaryNames, TagKind::Boundary);
    domain.boundaryNames[tag] = name;
    return tag;
}

/// Returns ", and joins the 3 segments that have this name" if other segments than those of a stretch have it.
std::string joinText(const Domain &domain, std::int32_t tag, const std::vector<BoundaryWalk::Step> &way) {
    const auto has = [&](const DomainSegment &segment) { return segment.tag == tag; };
    const auto all = std::count_if(domain.segments.begin(), domain.segments.end(), has);
    const auto own = std::count_if(way.begin(), way.end(),
                                   [&](const BoundaryWalk::Step &step) { return has(domain.segments[step.segment]); });
    const auto others = static_cast<std::size_t>(all - own);
    return others == 0 ? std::string()
                       : ", and joins the " +
                             (others == 1 ? std::string("other segment that has")
                                          : std::to_string(others) + " other segments that have") +
                             " this name";
}

Diagnostics misplaced(const PartName &part, const std::string &why, const std::string &advice) {
    Diagnostics fault = error("part-place", "the ends of the boundary part '" + part.name + "' are " + why, advice);
    fault.front().at = part.from;
    return fault;
}

/// Returns the steps of a stretch. Fault: part-place.
Result<std::vector<BoundaryWalk::Step>> stretchOf(const PartName &part, const BoundaryWalk &walk) {
    const std::uint32_t from = walk.nearest(part.from), to = walk.nearest(part.to);
    if (from == kNoIndex) {
        return misplaced(part, "on no boundary: the domain has none", {});
    }
    if (from == to && part.from != part.to) {
        return misplaced(part, "both nearest to the node " + placeText(walk.place(from)),
                         "a part is named from node to node: put a node into the outline where it is to end, or give "
                         "the same place twice to name the whole loop");
    }
    std::vector<BoundaryWalk::Step> way = walk.between(from, to);
    if (way.empty()) {
        return misplaced(part,
                         "nearest to nodes of different loops, " + placeText(walk.place(from)) + " and " +
                             placeText(walk.place(to)),
                         "give two places at one loop");
    }
    return way;
}

} // namespace

Diagnostics checkPlaces(std::span<const PartName> parts, const Box2 &box) {
    constexpr double kNear = 0.1; // of the diagonal
    for (const PartName &part : parts) {
        for (const Vec2 place : {part.from, part.to}) {
            if (!box.grown(kNear * box.diagonal()).contains(place)) {
                Diagnostics fault = error("part-place",
                                          "the end " + placeText(place) + " of the boundary part '" + part.name +
                                              "' is far outside the domain, which reaches from " + spanText(box),
                                          "give the coordinates as they are in the file, x (or longitude) first");
                return fault;
            }
        }
    }
    return {};
}

Diagnostics nameParts(std::span<const PartName> parts, Domain &domain) {
    if (parts.empty()) {
        return {};
    }
    if (Diagnostics wrong = checkPlaces(parts, domain.bounds()); !wrong.empty()) {
        return wrong;
    }
    DomainFaces faces;
    if (Diagnostics wrong = validate(domain, kMaxListedFaults, &faces); hasErrors(wrong)) {
        return wrong;
    }
    const BoundaryWalk walk(domain, faces);
    std::string named;
    for (const PartName &part : parts) {
        const Result<std::vector<BoundaryWalk::Step>> way = stretchOf(part, walk);
        if (!way) {
            return way.faults();
        }
        const std::int32_t tag = tagNamed(part.name, domain);
        const std::string joins = joinText(domain, tag, *way);
        for (const BoundaryWalk::Step &step : *way) {
            domain.segments[step.segment].tag = tag;
        }
        named += (named.empty() ? "'" : "; '") + part.name + "' is named: " + countText(way->size(), "segment") + ", " +
                 numberText(walk.lengthOf(*way), 6) + " long, from " + placeText(walk.place(way->front().from)) +
                 " to " + placeText(walk.place(way->back().to)) + joins;
    }
    Diagnostics note = error("named-part", "the boundary part " + named);
    note.front().severity = Severity::Note;
    return note;
}

} // namespace forefront
