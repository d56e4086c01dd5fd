#include "core/engine/mapped/mapped_faces.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/curve_chains.hpp"
#include "core/engine/domain/unmarked_region.hpp"

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

constexpr double kCornerBelow = 150.0;   ///< degrees
constexpr double kClearlySharper = 10.0; ///< degrees
constexpr double kCornerAt = 1e-6;       ///< distance of a given corner from its node, relative to the diagonal

Diagnostics mappedFault(const char *code, const std::string &region, std::string what, const char *advice,
                        std::optional<Vec2> at) {
    Diagnostics faults = error(code, "mapped region " + region + ": " + std::move(what), advice);
    faults.front().at = at;
    return faults;
}

/// The outline of a face, counter-clockwise.
struct FaceOutline {
    std::vector<std::uint32_t> nodes;    ///< of the domain
    std::vector<std::uint32_t> segments; ///< from each node to the next
};

/// What bounds and lies in each face of a domain.
struct PartsOfFaces {
    PartsOfFaces(const Domain &domain, const DomainFaces &faces) : segments(faces.faces.count) {
        for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
            const std::uint32_t left = faces.faces.left[s], right = faces.faces.right[s];
            segments[left].push_back(s);
            if (right != left) {
                segments[right].push_back(s);
            }
        }
        for (const ConstraintPoint &point : domain.points) {
            points.emplace(faces.faces.ofPoint[point.node], point.node);
        }
    }

    std::vector<std::vector<std::uint32_t>> segments; ///< ascending
    std::map<std::uint32_t, std::uint32_t> points;    ///< by face: the first point in it
};

/// Finds the outline and the corners of one face.
class MappedSearch {
  public:
    MappedSearch(const Domain &domain, const DomainFaces &faces, const PartsOfFaces &parts,
                 const std::vector<bool> &insideCurves, const MappedSpec &spec)
        : domain_(domain), faces_(faces), parts_(parts), insideCurves_(insideCurves), spec_(spec),
          name_(regionName(domain.regionNames, spec.region)) {}

    /// `used` receives the given corners that are nodes of the face.
    Result<TransfiniteFace> run(std::uint32_t face, std::set<std::size_t> &used) {
        FaceOutline outline;
        if (Status faults = findOutline(face, outline); !faults.empty()) {
            return faults;
        }
        std::vector<std::size_t> corners; // places in the outline, ascending
        Status faults = spec_.corners.empty() ? sharpest(outline, corners) : given(outline, corners, used);
        if (!faults.empty()) {
            return faults;
        }
        for (const std::size_t corner : corners) {
            if (insideCurves_[outline.nodes[corner]]) {
                return fault("mapped-corners", "the corner " + placeText(at(outline, corner)) + " lies inside a curve",
                             "put a point there, which divides the curve", at(outline, corner));
            }
        }
        return divided(outline, corners);
    }

    /// Returns the outline of one face; none if it has holes, or lines or points inside.
    std::optional<MappedOutline> outlineOf(std::uint32_t face) const {
        FaceOutline outline;
        if (!findOutline(face, outline).empty()) {
            return std::nullopt;
        }
        MappedOutline result;
        for (std::uint32_t k = 0; k < outline.nodes.size(); ++k) {
            result.nodes.push_back(at(outline, k));
            if (!insideCurves_[outline.nodes[k]]) {
                result.able.push_back(k);
                result.angles.push_back(angleAt(outline, k));
            }
        }
        std::vector<std::size_t> corners;
        std::set<std::size_t> used;
        const Status faults = spec_.corners.empty() ? sharpest(outline, corners) : given(outline, corners, used);
        const bool isInside =
            std::ranges::any_of(corners, [&](std::size_t corner) { return insideCurves_[outline.nodes[corner]]; });
        if (faults.empty() && !isInside) {
            result.corners.assign(corners.begin(), corners.end());
        }
        return result;
    }

  private:
    Diagnostics fault(const char *code, std::string what, const char *advice, std::optional<Vec2> where) const {
        return mappedFault(code, name_, std::move(what), advice, where);
    }
    Vec2 at(const FaceOutline &outline, std::size_t k) const {
        return domain_.nodes[outline.nodes[k % outline.nodes.size()]];
    }
    Vec2 middleOf(std::uint32_t s) const {
        return midpoint(domain_.nodes[domain_.segments[s].a], domain_.nodes[domain_.segments[s].b]);
    }

    Status findOutline(std::uint32_t face, FaceOutline &outline) const {
        std::map<std::uint32_t, std::uint32_t> leaving; // segment by the node that it leaves
        for (const std::uint32_t s : parts_.segments[face]) {
            const bool left = faces_.faces.left[s] == face, right = faces_.faces.right[s] == face;
            if (left && right) {
                return fault("mapped-outline", "a line lies inside; expected an empty face",
                             "end the face at the line, or remove the line", middleOf(s));
            }
            if (!leaving.emplace(left ? domain_.segments[s].a : domain_.segments[s].b, s).second) {
                return fault("mapped-outline", "its outline touches itself", "move the parts of the outline apart",
                             middleOf(s));
            }
        }
        if (const auto point = parts_.points.find(face); point != parts_.points.end()) {
            return fault("mapped-outline", "a point lies inside; expected an empty face", "remove the point",
                         domain_.nodes[point->second]);
        }
        std::uint32_t node = leaving.begin()->first;
        do {
            const std::uint32_t s = leaving.at(node);
            outline.nodes.push_back(node);
            outline.segments.push_back(s);
            node = domain_.segments[s].a == node ? domain_.segments[s].b : domain_.segments[s].a;
        } while (node != outline.nodes.front());
        if (outline.nodes.size() == leaving.size()) {
            return {};
        }
        const std::set<std::uint32_t> around(outline.segments.begin(), outline.segments.end());
        for (const auto &[start, s] : leaving) {
            if (!around.contains(s)) {
                return fault("mapped-outline", "it has a hole; expected one outline",
                             "divide the region into faces without holes", middleOf(s));
            }
        }
        return {};
    }

    /// Returns the interior angle at a place of the outline, degrees.
    double angleAt(const FaceOutline &outline, std::size_t k) const {
        const std::size_t n = outline.nodes.size();
        const Vec2 in = at(outline, k) - at(outline, k + n - 1), out = at(outline, k + 1) - at(outline, k);
        return 180.0 - std::atan2(cross(in, out), dot(in, out)) * 180.0 / std::numbers::pi;
    }

    Status sharpest(const FaceOutline &outline, std::vector<std::size_t> &corners) const {
        std::vector<std::pair<double, std::size_t>> found;
        for (std::size_t k = 0; k < outline.nodes.size(); ++k) {
            if (insideCurves_[outline.nodes[k]]) {
                continue; // the angle between chords is none of the outline
            }
            if (const double angle = angleAt(outline, k); angle < kCornerBelow) {
                found.emplace_back(angle, k);
            }
        }
        std::sort(found.begin(), found.end());
        if (found.size() > 4 && found[4].first - found[3].first >= kClearlySharper) {
            found.resize(4);
        }
        if (found.size() != 3 && found.size() != 4) {
            return fault("mapped-corners",
                         "its outline has " + countText(found.size(), "corner") + " below 150 degrees; expected 3 or 4",
                         "give the places of its corners", at(outline, found.empty() ? 0 : found.back().second));
        }
        for (const auto &[angle, k] : found) {
            corners.push_back(k);
        }
        std::sort(corners.begin(), corners.end());
        if (corners.size() == 3) { // the rows meet at the sharpest one
            std::rotate(corners.begin(), std::find(corners.begin(), corners.end(), found.front().second),
                        corners.end());
        }
        return {};
    }

    Status given(const FaceOutline &outline, std::vector<std::size_t> &corners, std::set<std::size_t> &used) const {
        const double tolerance = kCornerAt * domain_.bounds().diagonal();
        std::optional<std::size_t> first;
        for (std::size_t c = 0; c < spec_.corners.size(); ++c) {
            std::size_t nearest = 0;
            for (std::size_t k = 1; k < outline.nodes.size(); ++k) {
                if (distance(at(outline, k), spec_.corners[c]) < distance(at(outline, nearest), spec_.corners[c])) {
                    nearest = k;
                }
            }
            if (distance(at(outline, nearest), spec_.corners[c]) <= tolerance) {
                first = first ? first : std::optional(nearest);
                corners.push_back(nearest);
                used.insert(c);
            }
        }
        std::sort(corners.begin(), corners.end());
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        if (corners.size() != 3 && corners.size() != 4) {
            return fault("mapped-corners",
                         countText(corners.size(), "given corner") + " of " + std::to_string(spec_.corners.size()) +
                             (corners.size() == 1 ? " is a node" : " are nodes") + " of a face; expected 3 or 4",
                         "give the places of 3 or 4 nodes of its outline", at(outline, 0));
        }
        std::rotate(corners.begin(), std::find(corners.begin(), corners.end(), *first), corners.end());
        return {};
    }

    static TransfiniteFace divided(const FaceOutline &outline, const std::vector<std::size_t> &corners) {
        TransfiniteFace face;
        const std::size_t n = outline.nodes.size();
        for (std::size_t c = 0; c < corners.size(); ++c) {
            face.corners.push_back(outline.nodes[corners[c]]);
            std::vector<std::uint32_t> &side = face.sides.emplace_back();
            for (std::size_t k = corners[c]; k != corners[(c + 1) % corners.size()]; k = (k + 1) % n) {
                side.push_back(outline.segments[k]);
            }
        }
        return face;
    }

    const Domain &domain_;
    const DomainFaces &faces_;
    const PartsOfFaces &parts_;
    const std::vector<bool> &insideCurves_;
    const MappedSpec &spec_;
    std::string name_;
};

/// Returns per node whether it only divides a curve into chords.
std::vector<bool> nodesInsideCurves(const Domain &domain) {
    std::vector<bool> inside(domain.nodes.size(), false);
    for (const CurveChain &chain : curveChains(domain).list) {
        for (const std::uint32_t s : chain.segments) {
            for (const std::uint32_t node : {domain.segments[s].a, domain.segments[s].b}) {
                inside[node] = node != chain.start && node != chain.end;
            }
        }
    }
    return inside;
}

} // namespace

Result<std::vector<TransfiniteFace>> findMappedFaces(std::span<const MappedSpec> specs, const Domain &domain,
                                                     const DomainFaces &faces) {
    const std::vector<bool> insideCurves = nodesInsideCurves(domain);
    const PartsOfFaces parts(domain, faces);
    std::vector<TransfiniteFace> found;
    std::set<std::int32_t> seen;
    for (const MappedSpec &spec : specs) {
        const std::string name = regionName(domain.regionNames, spec.region);
        if (!seen.insert(spec.region).second) {
            return mappedFault("repeated-mapped", name, "it is given twice", "keep one of them", {});
        }
        const std::size_t before = found.size();
        std::set<std::size_t> used;
        MappedSearch search(domain, faces, parts, insideCurves, spec);
        std::uint32_t region = 0;
        for (std::uint32_t face = 0; face < faces.faces.count; ++face) {
            if (faces.labels.inside[face] == 0) {
                continue;
            }
            if (faces.labels.tag[face] == spec.region) {
                Result<TransfiniteFace> mapped = search.run(face, used);
                if (!mapped) {
                    return mapped.faults();
                }
                mapped->region = region;
                mapped->face = face;
                found.push_back(std::move(*mapped));
            }
            ++region;
        }
        if (found.size() == before && spec.region == kUnmarkedRegion) {
            continue;
        }
        if (found.size() == before) {
            return mappedFault("unknown-region", name, "no face of the domain belongs to it",
                               "choose a region of the domain", {});
        }
        for (std::size_t c = 0; c < spec.corners.size(); ++c) {
            if (!used.contains(c)) {
                return mappedFault("mapped-corners", name,
                                   "the corner " + placeText(spec.corners[c]) + " is not a node of its outline",
                                   "give the places of nodes", spec.corners[c]);
            }
        }
    }
    return found;
}

std::vector<MappedOutline> mappedOutlines(const MappedSpec &spec, const Domain &domain, const DomainFaces &faces) {
    const std::vector<bool> insideCurves = nodesInsideCurves(domain);
    const PartsOfFaces parts(domain, faces);
    const MappedSearch search(domain, faces, parts, insideCurves, spec);
    std::vector<MappedOutline> outlines;
    for (std::uint32_t face = 0; face < faces.faces.count; ++face) {
        if (faces.labels.inside[face] != 0 && faces.labels.tag[face] == spec.region) {
            if (std::optional<MappedOutline> outline = search.outlineOf(face)) {
                outlines.push_back(*std::move(outline));
            }
        }
    }
    return outlines;
}

} // namespace forefront
