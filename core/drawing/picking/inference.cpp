#include "core/drawing/picking/inference.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace forefront {
namespace {

constexpr double kInDegrees = std::numbers::pi / 180.0;
constexpr double kLevelAngle = 3.0 * kInDegrees;   ///< of horizontal and vertical lines
constexpr double kTangentAngle = 4.0 * kInDegrees; ///< of a line after an arc
constexpr double kOtherAngle = 2.0 * kInDegrees;   ///< of parallel and perpendicular lines
constexpr double kEqualShare = 0.02;               ///< of a length, up to which another counts as equal
constexpr double kNear = 2.0 / 3.0;                ///< of the tolerance, for all of these
constexpr std::size_t kMaxLines = 12, kMaxNodes = 40;
constexpr std::size_t kOwnLines = 2; ///< segments of the path being drawn whose direction counts

/// The points that fulfil a relation: a line, or a circle where `radius` > 0.
struct Locus {
    Inference relation;
    Vec2 at;    ///< a point of the line, or the centre
    Vec2 along; ///< of the line, of length 1
    double radius = 0.0;

    Vec2 nearest(Vec2 p) const {
        if (radius == 0.0) {
            return at + dot(p - at, along) * along;
        }
        const Vec2 arm = p - at;
        return at + (radius / length(arm)) * arm;
    }
};

/// A straight line that others can be parallel, perpendicular or equal to.
struct OtherLine {
    Vec2 a, b;
    std::optional<SketchPart> part;
    std::optional<std::uint32_t> own;
};

/// Returns the crossing of two loci nearest to a place.
std::optional<Vec2> crossing(const Locus &first, const Locus &second, Vec2 near) {
    if (first.radius > 0.0 && second.radius > 0.0) {
        return std::nullopt; // two equal lengths say little about a place
    }
    const Locus &line = first.radius > 0.0 ? second : first, &other = first.radius > 0.0 ? first : second;
    if (other.radius == 0.0) {
        const double sine = cross(line.along, other.along);
        constexpr double kParallel = 1e-3;
        return std::fabs(sine) < kParallel
                   ? std::nullopt
                   : std::optional(line.at + (cross(other.at - line.at, other.along) / sine) * line.along);
    }
    const Vec2 foot = line.nearest(other.at);
    const double half = other.radius * other.radius - dot(foot - other.at, foot - other.at);
    if (half < 0.0) {
        return std::nullopt;
    }
    const double reach = std::copysign(std::sqrt(half), dot(near - foot, line.along));
    return foot + reach * line.along;
}

/// Collects the loci near a place in the order of their precedence.
class LocusFinder {
  public:
    LocusFinder(const PickIndex &index, const PickIndex::Filter &filter, const InferenceQuery &query, Vec2 at,
                double tolerance)
        : index_(index), filter_(filter), query_(query), at_(at), near_(kNear * tolerance) {}

    std::vector<Locus> run() {
        findLines();
        for (const Vec2 start : query_.starts) {
            if (distance(start, at_) > 2.0 * near_) {
                offerDirections(start);
            }
        }
        for (const Vec2 start : query_.starts) {
            if (distance(start, at_) > 2.0 * near_) {
                offerLengths(start);
            }
        }
        offerRadii();
        if (!query_.round || !query_.starts.empty()) { // a point on a circle is level with nothing
            offerNodes();
        }
        return std::move(loci_);
    }

  private:
    void findLines() {
        const std::size_t count = query_.path.size();
        for (std::size_t k = 0; k < kOwnLines && k + 1 < count; ++k) { // the last segment first
            const std::size_t segment = count - 2 - k;
            if (query_.straight.empty() || query_.straight[segment]) {
                lines_.push_back({query_.path[segment], query_.path[segment + 1], std::nullopt,
                                  static_cast<std::uint32_t>(segment)});
            }
        }
        for (const SegmentHit &hit : index_.linesNear(at_, query_.reach, kMaxLines, filter_)) {
            const SketchPart part{hit.ref.shape, SketchPartKind::Segment, hit.ref.segment};
            lines_.push_back({hit.a, hit.b, part, std::nullopt});
        }
    }

    /// Adds the line through `start` in a direction if the pointer is near it.
    void offer(ConstraintKind kind, Vec2 start, Vec2 way, double angle, const OtherLine *other = nullptr) {
        const double size = length(way);
        const Vec2 arm = at_ - start;
        if (!(size > 0.0)) {
            return;
        }
        const Vec2 along = (1.0 / size) * way;
        const double aside = std::fabs(cross(along, arm));
        if (aside > near_ || aside > std::sin(angle) * length(arm)) {
            return;
        }
        Inference relation{kind, true, start};
        if (other != nullptr) {
            relation.with = other->part;
            relation.withOwn = other->own;
        }
        loci_.push_back({std::move(relation), start, along});
    }

    void offerDirections(Vec2 start) {
        if (query_.arrival && dot(*query_.arrival, at_ - start) > 0.0) {
            offer(ConstraintKind::Tangent, start, *query_.arrival, kTangentAngle);
        }
        offer(ConstraintKind::Horizontal, start, {1.0, 0.0}, kLevelAngle);
        offer(ConstraintKind::Vertical, start, {0.0, 1.0}, kLevelAngle);
        for (const OtherLine &line : lines_) {
            offer(ConstraintKind::Perpendicular, start, leftNormal(line.b - line.a), kOtherAngle, &line);
        }
        for (const OtherLine &line : lines_) {
            if (!line.part || distance(line.b, start) > 0.0) { // else it continues that line
                offer(ConstraintKind::Parallel, start, line.b - line.a, kOtherAngle, &line);
            }
        }
    }

    void offerLengths(Vec2 start) {
        const double reach = distance(start, at_);
        const OtherLine *best = nullptr;
        double limit = std::min(near_, kEqualShare * reach);
        for (const OtherLine &line : lines_) {
            const double away = std::fabs(distance(line.a, line.b) - reach);
            if (away < limit) {
                limit = away;
                best = &line;
            }
        }
        if (best != nullptr) {
            Inference relation{ConstraintKind::Equal, true, start, best->part, best->own};
            loci_.push_back({std::move(relation), start, {}, distance(best->a, best->b)});
        }
    }

    /// Adds the circle of the radius of another one that is nearest to that of the circle being drawn.
    void offerRadii() {
        if (!query_.round || distance(*query_.round, at_) <= 2.0 * near_) {
            return;
        }
        const double reach = distance(*query_.round, at_);
        std::optional<PickIndex::CircleHit> best;
        double limit = std::min(near_, kEqualShare * reach);
        for (const PickIndex::CircleHit &hit : index_.circlesNear(at_, query_.reach + reach, kMaxLines, filter_)) {
            const double away = std::fabs(hit.radius - reach);
            if (away < limit) {
                limit = away;
                best = hit;
            }
        }
        if (best) {
            Inference relation{ConstraintKind::Equal, true, *query_.round};
            relation.with = SketchPart{best->ref.shape, SketchPartKind::Segment, best->ref.segment};
            relation.ofRadius = true;
            loci_.push_back({std::move(relation), *query_.round, {}, best->radius});
        }
    }

    /// Adds the nearest node that the place is level with, and the nearest above or below it.
    void offerNodes() {
        struct Other {
            Vec2 at;
            std::optional<SketchPart> part;
            std::optional<std::uint32_t> own;
        };
        std::vector<Other> others;
        for (std::size_t k = 0; k < query_.path.size(); ++k) {
            others.push_back({query_.path[k], std::nullopt, static_cast<std::uint32_t>(k)});
        }
        for (const NodeHit &hit : index_.nodesNear(at_, query_.reach, kMaxNodes, filter_)) {
            others.push_back({hit.at, SketchPart{hit.ref.shape, SketchPartKind::Node, hit.ref.node}, std::nullopt});
        }
        for (const bool upright : {false, true}) {
            const Other *best = nullptr;
            double limit = near_;
            for (const Other &other : others) {
                const Vec2 arm = other.at - at_;
                const double aside = std::fabs(upright ? arm.x : arm.y), away = std::fabs(upright ? arm.y : arm.x);
                const bool starts =
                    std::find(query_.starts.begin(), query_.starts.end(), other.at) != query_.starts.end();
                if (!starts && aside < limit && away > near_) {
                    limit = aside;
                    best = &other;
                }
            }
            if (best != nullptr) {
                Inference relation{upright ? ConstraintKind::Vertical : ConstraintKind::Horizontal, false, best->at,
                                   best->part, best->own};
                loci_.push_back({std::move(relation), best->at, upright ? Vec2{0.0, 1.0} : Vec2{1.0, 0.0}});
            }
        }
    }

    const PickIndex &index_;
    const PickIndex::Filter &filter_;
    const InferenceQuery &query_;
    Vec2 at_;
    double near_;
    std::vector<OtherLine> lines_;
    std::vector<Locus> loci_;
};

} // namespace

std::optional<InferredPlace> inferRelations(const PickIndex &index, const PickIndex::Filter &filter,
                                            const InferenceQuery &query, Vec2 at, double tolerance) {
    const std::vector<Locus> loci = LocusFinder(index, filter, query, at, tolerance).run();
    if (loci.empty()) {
        return std::nullopt;
    }
    const Locus &first = loci.front();
    for (std::size_t k = 1; k < loci.size(); ++k) {
        const std::optional<Vec2> both = crossing(first, loci[k], at);
        if (both && distance(*both, at) <= tolerance) {
            return InferredPlace{*both, {first.relation, loci[k].relation}};
        }
    }
    const Vec2 place = first.nearest(at);
    return InferredPlace{place, {first.relation}};
}

std::vector<Inference> relationsAt(const InferenceQuery &query, Vec2 at) {
    constexpr double kRounding = 1e-9;
    std::vector<Inference> relations;
    for (const Vec2 start : query.starts) {
        const Vec2 arm = at - start;
        const double slack = kRounding * length(arm);
        if (arm == Vec2{}) {
            continue;
        }
        if (std::fabs(arm.y) <= slack || std::fabs(arm.x) <= slack) {
            const bool level = std::fabs(arm.y) <= slack;
            relations.push_back({level ? ConstraintKind::Horizontal : ConstraintKind::Vertical, true, start});
        }
    }
    return relations;
}

std::string wordsOf(const Inference &inference) {
    switch (inference.kind) {
    case ConstraintKind::Horizontal:
        return inference.ofLine ? "horizontal" : "level with a node";
    case ConstraintKind::Vertical:
        return inference.ofLine ? "vertical" : "above or below a node";
    case ConstraintKind::Parallel:
        return "parallel";
    case ConstraintKind::Perpendicular:
        return "perpendicular";
    case ConstraintKind::Tangent:
        return "tangent";
    default:
        return inference.ofRadius ? "equal radius" : "equal length";
    }
}

} // namespace forefront
