#include "core/engine/refine/least_angle.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/boundary/changed_boundary.hpp"
#include "core/engine/geometry/half_length.hpp"
#include "core/engine/refine/acute_lines.hpp"
#include "core/engine/refine/guarded_nodes.hpp"
#include "core/engine/refine/insertion_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <queue>
#include <string>
#include <utility>

namespace forefront {

namespace {

constexpr double kRadians = std::numbers::pi / 180.0;
constexpr double kTolerance = 1e-10; ///< relative, for cosines; checks of limits tolerate more
// Beyond this number of elements, refinement would not come to an end.
constexpr std::size_t kMaxGrowth = 30, kMaxGrowthOfSmall = 50'000;
constexpr double kNoAngle = 360.0;  ///< of no element
constexpr std::size_t kListed = 20; ///< faults
constexpr unsigned kTries = 12;     ///< for one element, each of which divides an edge near it

/// The sides of an element, the shortest first, counter-clockwise.
struct Corners {
    std::array<NodeId, 3> nodes; ///< the shortest side joins the first two
    Vec2 p, q, r;
    double cosine = 0.0; ///< of the least angle, which is at r
};

Corners cornersOf(const TriMesh &mesh, const Element &e) {
    const auto place = [&](unsigned k) { return mesh.nodes[index(e[k % 3])]; };
    unsigned k = 0;
    for (unsigned j = 1; j < 3; ++j) {
        if (distanceSquared(place(j), place(j + 1)) < distanceSquared(place(k), place(k + 1))) {
            k = j;
        }
    }
    Corners c{{e[k], e[(k + 1) % 3], e[(k + 2) % 3]}, place(k), place(k + 1), place(k + 2)};
    const Vec2 u = c.p - c.r, v = c.q - c.r;
    c.cosine = dot(u, v) / std::sqrt(lengthSquared(u) * lengthSquared(v));
    return c;
}

/// Returns the place for a node in a sharp element; see refineToLeastAngle(). `height`: the distance from a side of
/// length 1 at which it is seen at the least angle.
Vec2 offCentre(const Corners &c, double height) {
    const Vec2 u = c.q - c.p, v = c.r - c.p;
    const double twice = 2.0 * cross(u, v);
    const Vec2 middle = 0.5 * u;
    const Vec2 centre{(lengthSquared(u) * v.y - lengthSquared(v) * u.y) / twice,
                      (lengthSquared(v) * u.x - lengthSquared(u) * v.x) / twice};
    const Vec2 near = middle + height * leftNormal(u);
    return c.p + (dot(centre - middle, leftNormal(u)) <= height * lengthSquared(u) ? centre : near);
}

/// Returns the parameter of a point on a part of a curve at a distance from one end of the part.
double atDistance(const Curve &curve, const CurveStretch &stretch, const AcuteLines::Division &division, Vec2 end) {
    double near = division.fromA ? stretch.t0 : stretch.t1, far = division.fromA ? stretch.t1 : stretch.t0;
    constexpr int kHalvings = 60;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = std::midpoint(near, far);
        (distance(curve.point(middle), end) < division.distance ? near : far) = middle;
    }
    return std::midpoint(near, far);
}

/// The state of a refinement.
class Refinement {
  public:
    Refinement(TriMesh &mesh, DiscreteDomain &boundary, const LeastAngleRules &rules, GuardedNodes &guarded)
        : mesh_(mesh), boundary_(boundary), rules_(rules), guarded_(guarded), work_(mesh), lines_(mesh),
          cosine_(std::cos(rules.angle * kRadians)), height_(0.95 * 0.5 / std::tan(0.5 * rules.angle * kRadians)) {
        origin_.resize(mesh.edges.size());
        for (std::uint32_t i = 0; i < origin_.size(); ++i) {
            origin_[i] = i;
        }
    }

    Status run(const Progress &progress) {
        const std::size_t nodesBefore = mesh_.nodes.size(), edgesBefore = mesh_.edges.size();
        const std::size_t growthLimit = kMaxGrowth * mesh_.elements.size() + kMaxGrowthOfSmall;
        for (std::uint32_t e = 0; e < work_.elementCount(); ++e) {
            push(e, 0);
        }
        for (std::size_t steps = 0; !sharp_.empty(); ++steps) {
            const Sharp next = sharp_.top();
            sharp_.pop();
            if (mesh_.elements[next.element] == next.nodes) {
                refine(next);
            }
            if (steps % 1024 == 0) {
                if (progress.cancelled()) {
                    return cancelled("meshing");
                }
                const double rest = static_cast<double>(sharp_.size());
                progress("raising the least angle", 1.0 - rest / (rest + static_cast<double>(steps) + 1.0));
            }
            const std::uint64_t most = std::min<std::uint64_t>(growthLimit, rules_.maxElements);
            if (mesh_.elements.size() > most) {
                return tooMany(next, most);
            }
        }
        added_ = mesh_.nodes.size() - nodesBefore;
        divided_ = mesh_.edges.size() - edgesBefore;
        return {};
    }

    /// Fills in what the mesh has reached. Returns the faults of angles that nothing forces.
    Status judge(LeastAngleReport &report) {
        report.addedNodes = added_;
        report.dividedEdges = divided_;
        report.reached = kNoAngle;
        std::vector<std::pair<NodeId, ForcedAngle>> forced;
        std::vector<std::pair<double, Diagnostic>> faults;
        std::sort(kept_.begin(), kept_.end());
        for (std::uint32_t e = 0; e < work_.elementCount(); ++e) {
            const Element &nodes = mesh_.elements[e];
            const Corners c = cornersOf(mesh_, nodes);
            const double angle = std::acos(std::min(1.0, c.cosine)) / kRadians;
            if (!isSharp(c.cosine)) {
                report.reached = std::min(report.reached, angle);
                continue;
            }
            const Vec2 centre = (1.0 / 3.0) * (c.p + c.q + c.r);
            NodeId corner = forcingCorner(e);
            if (corner == kNoNode) {
                corner = lines_.enclosingCorner(mesh_, nodes, cosine_);
            }
            if (corner != kNoNode) {
                const Vec2 tip = mesh_.nodes[index(corner)];
                forced.push_back({corner, {ForcedBy::Corner, tip, angle, 1, distance(tip, centre)}});
            } else if (std::binary_search(kept_.begin(), kept_.end(), nodes)) {
                forced.push_back({kNoNode, {ForcedBy::KeptEdge, centre, angle, 1, 0.0}});
                if (guarded_.any() && c.cosine > guarded_.given(nodes) * (1.0 + kTolerance)) {
                    guarded_.blame(nodes);
                }
            } else {
                report.reached = std::min(report.reached, angle);
                faults.emplace_back(angle, faultOf(e, angle, centre));
            }
        }
        gather(forced, report.forced);
        std::stable_sort(faults.begin(), faults.end(), [](const auto &p, const auto &q) { return p.first < q.first; });
        report.reached = report.reached == kNoAngle ? 0.0 : report.reached;
        Status status;
        for (std::size_t i = 0; i < std::min(faults.size(), kListed); ++i) {
            status.push_back(std::move(faults[i].second));
        }
        return status;
    }

  private:
    struct Sharp {
        double cosine = 0.0;
        std::uint64_t age = 0; ///< equal ones in the order in which they were found
        std::uint32_t element = 0;
        unsigned tries = 0;
        Element nodes{};
        bool operator<(const Sharp &o) const { return cosine != o.cosine ? cosine < o.cosine : age > o.age; }
    };

    Diagnostic faultOf(std::uint32_t element, double angle, Vec2 at) const {
        Diagnostic fault = error("least-angle",
                                 "an angle of " + numberText(angle, 3) + "° remains below the least angle " +
                                     numberText(rules_.angle, 6) + "°",
                                 "choose a smaller least angle")
                               .front();
        fault.at = at;
        fault.ids = {element};
        return fault;
    }
    Diagnostics tooMany(const Sharp &at, std::uint64_t most) const {
        Diagnostics faults = error("least-angle",
                                   "a least angle of " + numberText(rules_.angle, 6) + "° needs more than " +
                                       std::to_string(most) + " elements",
                                   "choose a smaller least angle, or make the domain less narrow there");
        faults.front().at = mesh_.nodes[index(at.nodes[0])];
        return faults;
    }
    /// Joins the elements at one corner.
    static void gather(std::vector<std::pair<NodeId, ForcedAngle>> &found, std::vector<ForcedAngle> &forced) {
        std::stable_sort(found.begin(), found.end(), [](const auto &p, const auto &q) { return p.first < q.first; });
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (i > 0 && found[i].first != kNoNode && found[i].first == found[i - 1].first) {
                forced.back().angle = std::min(forced.back().angle, found[i].second.angle);
                ++forced.back().elements;
                forced.back().reach = std::max(forced.back().reach, found[i].second.reach);
            } else {
                forced.push_back(found[i].second);
            }
        }
        std::stable_sort(forced.begin(), forced.end(), [](const ForcedAngle &p, const ForcedAngle &q) {
            return p.reason != q.reason ? p.reason < q.reason : p.angle < q.angle;
        });
    }

    /// Returns the corner of the domain that forces the least angle of an element, or kNoNode.
    NodeId forcingCorner(std::uint32_t element) const {
        const Corners c = cornersOf(mesh_, mesh_.elements[element]);
        unsigned tagged = 0;
        for (unsigned k = 0; k < 3; ++k) { // sides at the corner with the least angle
            const auto h = static_cast<HalfEdge>(3 * element + k);
            const bool atCorner = work_.startOf(h) == c.nodes[2] || work_.endOf(h) == c.nodes[2];
            tagged += atCorner && work_.taggedEdge(h) != kNoIndex ? 1 : 0;
        }
        return tagged == 2 ? c.nodes[2] : lines_.spannedCorner(mesh_, mesh_.elements[element], cosine_);
    }

    bool isSharp(double cosine) const { return cosine > cosine_ * (1.0 + kTolerance); }
    void push(std::uint32_t element, unsigned tries) {
        const Element &nodes = mesh_.elements[element];
        const Corners c = cornersOf(mesh_, nodes);
        if (isSharp(c.cosine) && tries < kTries && forcingCorner(element) == kNoNode) {
            sharp_.push({c.cosine, age_++, element, tries, nodes});
        }
    }
    void pushChanged() {
        for (const std::uint32_t e : work_.changed()) {
            push(e, 0);
        }
    }

    void refine(const Sharp &sharp) {
        work_.swapAround(sharp.element);
        if (!work_.changed().empty()) {
            pushChanged();
            if (mesh_.elements[sharp.element] != sharp.nodes) {
                return;
            }
        }
        const Vec2 place = offCentre(cornersOf(mesh_, sharp.nodes), height_);
        const InsertionMesh::Walk walk = work_.walk(sharp.element, place);
        const std::size_t heldBefore = held_;
        bool done = true;
        if (walk.end == InsertionMesh::Walk::End::Blocked) {
            done = divide(work_.taggedEdge(walk.side));
        } else if (walk.end == InsertionMesh::Walk::End::Inside) {
            if (!divideAround(elementOf(walk.side), place)) {
                const Element around = mesh_.elements[elementOf(walk.side)];
                if (attempt([&] { return work_.insert(elementOf(walk.side), place); }, around, 3)) {
                    pushChanged();
                }
                done = false;
            }
        }
        if (mesh_.elements[sharp.element] != sharp.nodes) {
            return;
        }
        if (done) { // edges near it
            push(sharp.element, sharp.tries + 1);
        } else if (held_ > heldBefore) {
            kept_.push_back(sharp.nodes);
        }
    }

    /// Divides the tagged edges around a place in whose diametral circles it lies. Returns false if none is divided.
    bool divideAround(std::size_t element, Vec2 place) {
        around_.clear();
        work_.tagsAround(element, place, around_);
        std::sort(around_.begin(), around_.end());
        around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
        bool any = false;
        for (const std::uint32_t edge : around_) {
            const Vec2 a = mesh_.nodes[index(mesh_.edges[edge].a)], b = mesh_.nodes[index(mesh_.edges[edge].b)];
            if (dot(a - place, b - place) < 0.0) {
                any = divide(edge) || any;
            }
        }
        return any;
    }

    /// Makes a change that inserts a node in an element, or on the edge of its first two nodes. At guarded nodes, takes
    /// it back if an element becomes sharper than the sharpest of those that it replaces: nothing may mend it. Returns
    /// whether the change stays.
    template <class Change>
    bool attempt(const Change &change, const Element &around, unsigned corners) {
        if (!guarded_.any()) {
            return change();
        }
        work_.beginTrial();
        if (!change()) {
            work_.keepTrial();
            return false;
        }
        guarded_.add(around, corners);
        if (keepsAngles()) {
            work_.keepTrial();
            return true;
        }
        work_.undoTrial();
        guarded_.removeLast();
        ++held_;
        return false;
    }
    /// Returns true if the last change touches no guarded node, or leaves no element sharper than it found.
    bool keepsAngles() const {
        double before = cosine_;
        bool guards = false;
        for (const auto &[element, nodes] : work_.replaced()) {
            before = std::max(before, leastAngleCosine(mesh_, nodes));
            guards = guards || guarded_.guards(nodes);
        }
        return !guards || std::all_of(work_.changed().begin(), work_.changed().end(), [&](std::uint32_t e) {
            return leastAngleCosine(mesh_, mesh_.elements[e]) <= before * (1.0 + kTolerance) ||
                   forcingCorner(e) != kNoNode;
        });
    }

    bool isKept(std::uint32_t edge) const {
        return edge == kNoIndex || (rules_.mayDivide && !rules_.mayDivide(origin_[edge]));
    }
    /// Divides a tagged edge and the segment of the boundary that it is.
    bool divide(std::uint32_t edge) {
        if (isKept(edge)) {
            ++held_;
            return false;
        }
        const Vec2 a = mesh_.nodes[index(mesh_.edges[edge].a)], b = mesh_.nodes[index(mesh_.edges[edge].b)];
        const CurveStretch stretch = mesh_.edgeStretches.empty() ? CurveStretch{} : mesh_.edgeStretches[edge];
        const std::optional<AcuteLines::Division> division = lines_.division(mesh_, edge);
        Vec2 place = midpoint(a, b);
        double t = 0.0;
        if (stretch.follows()) {
            const Curve &curve = mesh_.curves[stretch.curve];
            t = division ? atDistance(curve, stretch, *division, division->fromA ? a : b)
                         : halfLength(curve, stretch.t0, stretch.t1);
            place = curve.point(t);
        } else if (division) {
            const double share = division->distance / distance(a, b);
            place = division->fromA ? lerp(a, b, share) : lerp(b, a, share);
        }
        if (place == a || place == b ||
            !attempt([&] { return work_.divide(edge, place); }, {mesh_.edges[edge].a, mesh_.edges[edge].b, kNoNode},
                     2)) {
            return false;
        }
        lines_.divided(edge, NodeId{static_cast<std::uint32_t>(mesh_.nodes.size() - 1)});
        origin_.push_back(origin_[edge]);
        divideSegment(edge, place, t);
        pushChanged();
        return true;
    }

    void divideSegment(std::uint32_t edge, Vec2 place, double t) {
        const auto node = static_cast<std::uint32_t>(boundary_.nodes.size());
        boundary_.nodes.push_back(place);
        DiscreteSegment half = boundary_.segments[edge];
        const bool reversed = half.leftRegion == kOutside; // as the edges of boundaries are turned
        (reversed ? half.b : half.a) = node;
        (reversed ? boundary_.segments[edge].a : boundary_.segments[edge].b) = node;
        boundary_.segments.push_back(half);
        const auto split = [&](std::vector<CurveStretch> &stretches, bool atStart) {
            if (stretches.empty()) {
                return;
            }
            CurveStretch other = stretches[edge];
            (atStart ? other.t1 : other.t0) = t;
            (atStart ? stretches[edge].t0 : stretches[edge].t1) = t;
            stretches.push_back(other);
        };
        split(mesh_.edgeStretches, false);
        split(boundary_.stretches, reversed);
    }

    TriMesh &mesh_;
    DiscreteDomain &boundary_;
    const LeastAngleRules &rules_;
    GuardedNodes &guarded_;
    InsertionMesh work_;
    AcuteLines lines_;
    double cosine_, height_;
    std::priority_queue<Sharp> sharp_;
    std::uint64_t age_ = 0;
    std::vector<std::uint32_t> origin_, around_;
    std::vector<Element> kept_;                      ///< sharp elements beside edges that may not be divided
    std::size_t added_ = 0, divided_ = 0, held_ = 0; ///< held_: changes that such edges did not allow
};

Status refineOnce(TriMesh &mesh, DiscreteDomain &boundary, const LeastAngleRules &rules, GuardedNodes &guarded,
                  LeastAngleReport &report, const Progress &progress) {
    report = {};
    Refinement refinement(mesh, boundary, rules, guarded);
    if (Status faults = refinement.run(progress); !faults.empty()) {
        return faults;
    }
    sumAreas(boundary);
    return refinement.judge(report);
}

/// Refines. Where elements at edges that may not be divided become sharper than the given ones, begins again with more
/// nodes guarded around them; with all of them, no element can.
Status refine(TriMesh &mesh, DiscreteDomain &boundary, const LeastAngleRules &rules, LeastAngleReport &report,
              const Progress &progress) {
    GuardedNodes guarded(mesh, [&](std::uint32_t edge) { return rules.mayDivide && !rules.mayDivide(edge); });
    if (!guarded.any()) {
        return refineOnce(mesh, boundary, rules, guarded, report, progress);
    }
    const TriMesh given = mesh;
    const DiscreteDomain givenBoundary = boundary;
    constexpr unsigned kFirstRings = 2, kMostRings = 16;
    for (unsigned rings = kFirstRings;; rings *= 2) {
        Status faults = refineOnce(mesh, boundary, rules, guarded, report, progress);
        if (progress.cancelled() || !guarded.anyBlamed() || rings > 2 * kMostRings) {
            return faults;
        }
        mesh = given;
        boundary = givenBoundary;
        rings <= kMostRings ? guarded.extend(given, rings) : guarded.guardAll(given);
    }
}

} // namespace

Status refineToLeastAngle(TriMesh &mesh, DiscreteDomain &boundary, const LeastAngleRules &rules,
                          LeastAngleReport &report, const Progress &progress) {
    if (mesh.curves.empty()) {
        return refine(mesh, boundary, rules, report, progress);
    }
    const TriMesh given = mesh;
    const DiscreteDomain givenBoundary = boundary;
    Status faults = refine(mesh, boundary, rules, report, progress);
    if (progress.cancelled() || isProper(boundary)) {
        return faults;
    }
    // Parts of curves met others, which is very rare: their chords stay.
    mesh = given;
    boundary = givenBoundary;
    report = {};
    LeastAngleRules keeping = rules;
    keeping.mayDivide = [&](std::uint32_t edge) {
        return !given.edgeStretches[edge].follows() && (!rules.mayDivide || rules.mayDivide(edge));
    };
    return refine(mesh, boundary, keeping, report, progress);
}

std::string toString(const ForcedAngle &place) {
    std::string text =
        numberText(place.angle, 3) + "° " +
        (place.reason == ForcedBy::Corner ? "at a sharp corner" : "beside a segment that may not be divided") + " (" +
        std::to_string(place.elements) + (place.elements == 1 ? " element" : " elements");
    if (place.elements > 1) {
        text += " between its lines, up to " + numberText(place.reach, 3) + " away";
    }
    return text + ')';
}

Diagnostics forcedAngles(const LeastAngleReport &report) {
    Diagnostics notes;
    for (const ForcedAngle &place : report.forced) {
        Diagnostic note = error("forced-angle", "an angle of " + toString(place)).front();
        note.severity = Severity::Note;
        note.at = place.at;
        notes.push_back(std::move(note));
    }
    return notes;
}

} // namespace forefront
