#include "core/drawing/domain/side_choice.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace forefront {
namespace {

class SideChooser {
  public:
    SideChooser(const Document &document, const Domain &domain, const DomainSources &sources, const NeighbourSide &side)
        : document_(document), domain_(domain), side_(side), kept_(sources.segments[side.kept.first]),
          dropped_(sources.segments[side.dropped.first]) {}

    SideChoice run() {
        chooseTag();
        if (!choice_.conflict) {
            chooseSizes();
        }
        return std::move(choice_);
    }

  private:
    void chooseTag() {
        const DomainSegment &kept = domain_.segments[side_.kept.first];
        const std::int32_t other = domain_.segments[side_.dropped.first].tag;
        choice_.tag = kept.tag;
        const std::string role = roleOf(other);
        if (other == kept.tag || role.empty()) {
            return;
        }
        const std::string keptRole = roleOf(kept.tag);
        if (keptRole.empty() && (side_.within || kept.role == SegmentRole::Constraint)) {
            choice_.tag = other; // a line within the domain, which the tag of either shape names as well
            return;
        }
        const auto named = [](std::int32_t tag, const std::string &of) {
            return "tag " + std::to_string(tag) + (of.empty() ? " on the boundary" : " with " + of);
        };
        refuse(named(kept.tag, keptRole), named(other, role), "give their common side one tag in both shapes");
    }

    /// Returns what a tag makes of its lines beyond their sizes; empty for nothing.
    std::string roleOf(std::int32_t tag) const {
        const auto hasTag = [tag](const auto &specs) {
            return std::any_of(specs.begin(), specs.end(), [tag](const auto &spec) { return spec.tag == tag; });
        };
        const auto &cracks = document_.cracks;
        const auto isPartner = [tag](const PeriodicSpec &spec) { return spec.from == tag || spec.to == tag; };
        return hasTag(document_.layers)                                                       ? "boundary layers"
               : hasTag(document_.strips)                                                     ? "a strip"
               : std::find(cracks.begin(), cracks.end(), tag) != cracks.end()                 ? "a crack"
               : std::any_of(document_.periodic.begin(), document_.periodic.end(), isPartner) ? "a periodic partner"
                                                                                              : "";
    }

    void chooseSizes() {
        const bool counted = kept_.elements > 0, otherCounted = dropped_.elements > 0;
        if (counted != otherCounted) {
            choice_.dropped = otherCounted;
            return;
        }
        const std::string advice = "give both the same, or remove it from one of them";
        if (counted && !hasSameElements()) {
            refuse(elementsText(side_.kept, kept_), elementsText(side_.dropped, dropped_), advice);
        } else if (kept_.size.size > 0.0 && dropped_.size.size > 0.0 && kept_.size != dropped_.size) {
            refuse(sizeText(kept_.size), sizeText(dropped_.size), advice);
        } else {
            choice_.dropped = !(kept_.size.size > 0.0) && dropped_.size.size > 0.0;
        }
    }

    /// Returns true if two numbers of elements are the same. Those of parts of curves are shares, which depend on the
    /// rest of each curve.
    bool hasSameElements() const {
        constexpr double kInverse = 1e-12; // of a ratio and its inverse
        const bool sameWay = domain_.segments[side_.kept.first].a == domain_.segments[side_.dropped.first].a;
        const ElementBias seen = sameWay ? dropped_.bias : dropped_.bias.reversed();
        return kept_.elements == dropped_.elements && isWhole(side_.kept) && isWhole(side_.dropped) &&
               kept_.bias.any() == seen.any() && (!seen.any() || kept_.bias.bothEnds == seen.bothEnds) &&
               std::fabs(kept_.bias.ratio - seen.ratio) <= kInverse * seen.ratio;
    }

    bool isWhole(SegmentRun run) const {
        const CurveStretch &start = domain_.segments[run.first].stretch;
        const CurveStretch &end = domain_.segments[run.end - 1].stretch;
        return !start.follows() || (start.t0 == 0.0 && end.t1 == 1.0);
    }

    std::string elementsText(SegmentRun run, const SegmentSource &source) const {
        return countText(source.elements, "element") +
               (source.bias.any() ? " with a bias of " + numberText(source.bias.ratio, 6) : "") +
               (isWhole(run) ? "" : " along a curve of which the side is a part");
    }
    static std::string sizeText(const PartSize &size) {
        return "the size " + numberText(size.size, 6) + " with the growth " + numberText(size.growth, 6);
    }

    void refuse(const std::string &kept, const std::string &dropped, std::string advice) {
        Diagnostic conflict;
        conflict.code = "side-conflict";
        conflict.message = "'" + displayName(*document_.shapes[kept_.shape]) + "' and '" +
                           displayName(*document_.shapes[dropped_.shape]) + "' share a side, but one has " + kept +
                           " there and the other " + dropped;
        conflict.advice = std::move(advice);
        const DomainSegment &first = domain_.segments[side_.kept.first], &last = domain_.segments[side_.kept.end - 1];
        conflict.at = 0.5 * (domain_.nodes[first.a] + domain_.nodes[last.b]);
        choice_.conflict = std::move(conflict);
    }

    const Document &document_;
    const Domain &domain_;
    const NeighbourSide &side_;
    const SegmentSource &kept_, &dropped_;
    SideChoice choice_;
};

} // namespace

SideChoice chooseSide(const Document &document, const Domain &domain, const DomainSources &sources,
                      const NeighbourSide &side) {
    return SideChooser(document, domain, sources, side).run();
}

} // namespace forefront
