#include "core/engine/spacing/kept_field.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/lazy_faces.hpp"
#include "core/engine/spacing/parts/automatic/boundary_spacing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace forefront {
namespace {

// Measured on squares with sides of 1 to 10 segments, 10 to 50 times as long as the size: with these, the minimum angle
// after improvement is 29 degrees, without them 4 to 18. A fall of 1.5 brings 22 degrees, one of 0.5 hardly reaches the
// size asked for.
constexpr double kAtSegment = 0.7; ///< the size at a segment, relative to its length
constexpr double kFall = 1.0;      ///< of the size, per unit of distance
/// The size at a crowded segment: that of the sides of a triangle over it with angles of 30 degrees.
constexpr double kAtCrowded = 0.577;
/// The minimum fall of the size beside crowded segments; it is steeper where the domain is narrower.
constexpr double kCrowdedFall = 1.15;
/// Length of a segment relative to the size asked for from which on the size is raised. Below, the front and the
/// improvement find shapes that are as good.
constexpr double kTooLong = 4.5;
constexpr SpreadOptions kLengthSpread{.many = 2048};

/// A segment that is too long for the size asked for.
struct LongSegment {
    PlacedSegment segment;
    double ratio = 0.0; ///< of its length to that size
};

std::vector<LongSegment> longSegments(const std::vector<PlacedSegment> &segments, const SpacingField &asked) {
    std::vector<LongSegment> result;
    for (const PlacedSegment &segment : segments) {
        const double rho =
            std::min({asked.at(segment.a), asked.at(midpoint(segment.a, segment.b)), asked.at(segment.b)});
        if (segment.length() > kTooLong * rho) {
            result.push_back({segment, segment.length() / rho});
        }
    }
    return result;
}

} // namespace

Result<std::shared_ptr<const SpacingField>> KeptField::raise(std::shared_ptr<const SpacingField> asked,
                                                             const Domain &domain, const Progress &progress) {
    const std::vector<PlacedSegment> segments = placedSegments(domain);
    const std::vector<LongSegment> tooLong = longSegments(segments, *asked);
    if (tooLong.empty()) {
        return asked;
    }
    std::shared_ptr<KeptField> field(new KeptField(std::move(asked)));
    field->describeAs(*field->asked_);
    const double least = field->asked_->minimum();
    std::vector<Box2> boxes;
    const LongSegment *worst = &tooLong.front();
    for (const LongSegment &item : tooLong) {
        const auto &[a, b, index, whole, beside] = item.segment;
        const double size = kAtSegment * item.segment.length();
        field->long_.push_back(SizeSite::segment(a, b, size, -kFall));
        field->source_.push_back(index);
        boxes.push_back(boxOf(a, b).grown(std::max(0.0, (size - least) / kFall)));
        worst = item.ratio > worst->ratio ? &item : worst;
    }
    field->reach_ = BoxTree(boxes);
    std::vector<SizeSite> lengths;
    lengths.reserve(segments.size());
    for (const PlacedSegment &segment : segments) {
        lengths.push_back(SizeSite::segment(segment.a, segment.b, segment.length(), kFall));
    }
    field->lengths_ = SiteTree::build(std::move(lengths), spacingBox(domain), progress, kLengthSpread);
    if (!field->lengths_) {
        return cancelled("preparing the spacing");
    }
    field->findCrowded(domain, progress);
    field->words_.boundaryNames = domain.boundaryNames;
    for (const DomainSegment &segment : domain.segments) {
        field->words_.segmentTags.push_back(segment.tag);
    }
    const bool crowded = std::ranges::find(field->crowded_, worst->segment.index) != field->crowded_.end();
    const double share = crowded ? kAtCrowded : kAtSegment, fall = crowded ? kCrowdedFall : kFall;
    field->note(worst->ratio, midpoint(worst->segment.a, worst->segment.b),
                (share - 1.0 / worst->ratio) * worst->segment.length() / fall);
    return std::shared_ptr<const SpacingField>(std::move(field));
}

/// Returns true if the size asked for is reached nowhere around a long segment, in the parts of the domain beside it.
bool KeptField::isCrowded(std::size_t item, const InsideTest &inside) const {
    constexpr int kCells = 24;       ///< in each direction
    constexpr double kAround = 3.0;  ///< lengths of the segment
    constexpr double kBeside = 0.05; ///< the same
    constexpr double kReached = 1.5; ///< times the size asked for
    const SizeSite &site = long_[item];
    const Vec2 middle = site.a + 0.5 * site.ab, normal = leftNormal(site.ab); // as long as the segment
    const Box2 box = boxAround(middle, kAround * length(site.ab));
    bool any = false;
    for (const double side : {-kBeside, kBeside}) {
        const Vec2 from = middle + side * normal;
        if (!inside.contains(from)) {
            continue;
        }
        any = true;
        for (int k = 0; k < kCells * kCells; ++k) {
            const int column = k % kCells, row = k / kCells;
            const Vec2 cell{(column + 0.5) / kCells, (row + 0.5) / kCells};
            const Vec2 p{std::lerp(box.min.x, box.max.x, cell.x), std::lerp(box.min.y, box.max.y, cell.y)};
            if (!inside.contains(p)) {
                continue;
            }
            const double size = asked_->at(p);
            if (raised(p, size) <= kReached * size && !inside.boundaryCrosses(from, p)) {
                return false;
            }
        }
    }
    return any;
}

/// Returns the fall with which the size beside a crowded segment reaches that asked for where the domain is widest.
double KeptField::crowdedFall(std::size_t item, const InsideTest &inside) const {
    constexpr int kSteps = 64;
    constexpr double kEarly = 0.95; // relative to that place
    const SizeSite &site = long_[item];
    const Vec2 middle = site.a + 0.5 * site.ab, normal = leftNormal(site.ab);
    double farthest = 0.0, asked = 0.0;
    for (const double side : {-1.0, 1.0}) {
        for (int step = 1; step <= kSteps; ++step) {
            const Vec2 p = middle + (side * step / kSteps) * normal;
            if (!inside.contains(p)) {
                break;
            }
            double clearance = std::numeric_limits<double>::infinity();
            for (const SizeSite &other : long_) {
                clearance = std::min(clearance, other.distanceTo(p));
            }
            if (clearance > farthest) {
                farthest = clearance;
                asked = asked_->at(p);
            }
        }
    }
    const double fall = (kAtCrowded * length(site.ab) - asked) / (kEarly * farthest);
    return std::clamp(fall, kCrowdedFall, kSteepestFall);
}

/// Lets the size fall faster beside segments between which it would not reach that asked for. Between many, there is
/// enough room for elements beside them, and looking for such places would take long.
void KeptField::findCrowded(const Domain &domain, const Progress &progress) {
    constexpr std::size_t kFewLong = 200;
    if (long_.size() > kFewLong) {
        return;
    }
    const LazyFaces faces(domain, progress.stop);
    const InsideTest *const inside = faces.inside();
    if (inside == nullptr) {
        return;
    }
    std::vector<std::pair<std::size_t, double>> items; // with their falls
    for (std::size_t k = 0; k < long_.size() && !progress.cancelled(); ++k) {
        if (isCrowded(k, *inside)) {
            items.emplace_back(k, crowdedFall(k, *inside));
        }
    }
    for (const auto &[k, fall] : items) {
        const Vec2 a = long_[k].a, b = a + long_[k].ab;
        long_[k] = SizeSite::segment(a, b, kAtCrowded * distance(a, b), -fall);
        crowded_.push_back(source_[k]);
    }
}

/// Notes the segment that is longest in relation to the size asked for.
void KeptField::note(double ratio, Vec2 at, double reach) {
    Diagnostic note;
    note.severity = Severity::Warning;
    note.code = "long-segments";
    note.message = "given segments are up to " + numberText(ratio, 2) +
                   " times longer than the size asked for, and are kept; elements closer to them than " +
                   numberText(reach, 2) + " are larger";
    note.advice = "let segments be divided, or divide them in the drawing";
    note.at = at;
    addNotes({note});
}

double KeptField::raised(Vec2 p, double asked) const {
    double rho = asked;
    reach_.query({p, p}, [&](std::uint32_t item) { rho = std::max(rho, long_[item].at(p)); });
    return rho > asked ? std::max(asked, std::min(rho, lengths_->at(p))) : asked;
}

void KeptField::atMany(std::span<const Vec2> points, std::span<double> rho) const {
    FOREFRONT_ASSERT(points.size() == rho.size());
    asked_->atMany(points, rho);
    for (std::size_t i = 0; i < points.size(); ++i) {
        rho[i] = raised(points[i], rho[i]);
    }
}

SpacingSample KeptField::sample(Vec2 p) const {
    SpacingSample sample = asked_->sample(p);
    const double rho = raised(p, sample.rho);
    if (!(rho > sample.rho)) {
        return sample;
    }
    std::uint32_t best = kNoIndex;
    reach_.query({p, p}, [&](std::uint32_t item) {
        if (best == kNoIndex || long_[item].at(p) > long_[best].at(p)) {
            best = item;
        }
    });
    const SiteLabel label{SpacingOrigin::Boundary, SiteReason::KeptSegment, source_[best]};
    SpacingSample raisedSample = sampleSite(long_[best], label, words_, p);
    raisedSample.rho = rho;
    return raisedSample; // no other rule sets a size that is at least as large
}

double KeptField::maximum() const {
    double largest = asked_->maximum();
    for (const SizeSite &site : long_) {
        largest = std::max(largest, site.size);
    }
    return largest;
}

} // namespace forefront
