#include "core/engine/spacing/kept_field.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/parts/automatic/boundary_spacing.hpp"

#include <algorithm>
#include <utility>

namespace forefront {
namespace {

// Measured on squares with sides of 1 to 10 segments, 10 to 50 times as long as the size: with these, the minimum angle
// after improvement is 29 degrees, without them 4 to 18. A fall of 1.5 brings 22 degrees, one of 0.5 hardly reaches the
// size asked for.
constexpr double kAtSegment = 0.7; ///< the size at a segment, relative to its length
constexpr double kFall = 1.0;      ///< of the size, per unit of distance
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
    field->addNotes(field->asked_->notes());
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
    for (const PlacedSegment &segment : segments) {
        lengths.push_back(SizeSite::segment(segment.a, segment.b, segment.length(), kFall));
    }
    field->lengths_ = SiteTree::build(std::move(lengths), spacingBox(domain), progress, kLengthSpread);
    if (!field->lengths_) {
        return cancelled("preparing the spacing");
    }
    field->words_.boundaryNames = domain.boundaryNames;
    for (const DomainSegment &segment : domain.segments) {
        field->words_.segmentTags.push_back(segment.tag);
    }
    field->note(worst->ratio, midpoint(worst->segment.a, worst->segment.b),
                (kAtSegment - 1.0 / worst->ratio) * worst->segment.length() / kFall);
    return std::shared_ptr<const SpacingField>(std::move(field));
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
