#include "core/engine/boundary/discretise.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/boundary/changed_boundary.hpp"
#include "core/engine/boundary/clearly_apart.hpp"
#include "core/engine/boundary/curve_cuts.hpp"
#include "core/engine/boundary/meeting_parts.hpp"
#include "core/engine/boundary/narrow_tips.hpp"
#include "core/engine/boundary/periodic_division.hpp"
#include "core/engine/boundary/spacing_integral.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/element_places.hpp"
#include "core/engine/geometry/polygon.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>

namespace forefront {

namespace {

/// About 44 bytes each, 1 GB in total.
constexpr double kMaxPieces = 2e7;

/// Maximum interval between samples of the spacing, as a fraction of the domain's size.
constexpr double kLongestStep = 1.0 / 64.0;

Diagnostics located(std::string code, std::string message, std::string advice, Vec2 at) {
    Diagnostics faults = error(std::move(code), std::move(message), std::move(advice));
    faults[0].at = at;
    return faults;
}

Diagnostics notValid() {
    return error("invalid-domain", "the domain has faults and cannot be discretised", "validate or repair it first");
}

Diagnostics tooMany(double estimate, Vec2 at) {
    return located("too-many-nodes",
                   "the spacing is too fine: it requires about " + numberText(estimate, 3) +
                       " boundary segments; expected at most " + numberText(kMaxPieces, 3),
                   "make the spacing larger, or keep the boundary segments undivided", at);
}

class Discretiser {
  public:
    Discretiser(const Domain &domain, const SpacingField &spacing, bool keepBoundary, NarrowTips narrowTips,
                SegmentElements elements, const PeriodicSides *periodic, const Progress &progress)
        : domain_(domain), spacing_(spacing), progress_(progress), keepBoundary_(keepBoundary), narrowTips_(narrowTips),
          elements_(elements), periodic_(domain, spacing, periodic),
          longest_(domain.bounds().diagonal() * kLongestStep) {
        if (periodic != nullptr) {
            result_.periodic = periodic->links;
        }
    }

    /// `known`: the faces of the domain, or null to find them.
    Result<DiscreteDomain> run(const DomainFaces *known) {
        if (known != nullptr) {
            if (Status faults = takeRegions(*known); !faults.empty()) {
                return faults;
            }
        } else if (Status faults = findRegions(); !faults.empty()) {
            return faults;
        }
        result_.curves = domain_.curves;
        most_.assign(domain_.segments.size(), keepBoundary_ ? 1U : kNoIndex);
        if (!keepBoundary_) {
            if (!domain_.curves.empty()) {
                curves_.emplace(domain_, elements_);
            }
            if (!sampleNodes()) {
                return cancelled("discretising the boundary");
            }
            if (Status faults = refuseAbsurd(); !faults.empty()) {
                return faults;
            }
            if (narrowTips_ == NarrowTips::Whole) {
                narrowEnds_ = findNarrowEnds(domain_, spacing_, left_, right_, curves_ ? &*curves_ : nullptr);
            }
        }
        // Rounding may push an inserted node across a part that is closer than the last digits: such segments are cut
        // into fewer pieces until nothing meets. Pieces of curves are halved, or replaced by the chords of the domain,
        // where they meet others or have them on the wrong side. The segments of the input do not meet, so this ends.
        for (;;) {
            if (Status faults = cutSegments(); !faults.empty()) {
                return faults;
            }
            progress_("checking the boundary", 0.0);
            const bool curved = curves_ && curves_->any();
            MeetingParts meetings;
            if (curved || (result_.segments.size() > domain_.segments.size() && !areClearlyApart(domain_, result_))) {
                meetings = findMeetingParts({result_, curved ? &*curves_ : nullptr, pieces_, pointRegion_, pointBelow_},
                                            progress_.stop);
            }
            if (progress_.cancelled()) {
                return cancelled("discretising the boundary");
            }
            if (meetings.none()) {
                break;
            }
            const bool relaxed = relax(meetings.segments);
            if (!meetings.pieces.empty()) {
                periodic_.addMirrored(*curves_, meetings.pieces);
                curves_->refine(meetings.pieces);
            } else if (!relaxed) {
                return notValid();
            }
        }
        finish();
        return std::move(result_);
    }

  private:
    /// Finds the faces of the domain, and sets the regions by them.
    Status findRegions() {
        DomainFaces found;
        found.graph = graphOf(domain_);
        found.sweep = sweepPlane(found.graph.points, found.graph.edges, progress_.stop);
        if (progress_.cancelled()) {
            return cancelled("discretising the boundary");
        }
        if (found.sweep.droppedCount == 0) {
            found.faces = findFaces(found.graph.points, found.graph.edges, found.sweep);
            found.labels = labelFaces(domain_, found.graph, found.faces);
        }
        return takeRegions(found);
    }

    /// Sets the regions by face, and the sides of the segments as given.
    Status takeRegions(const DomainFaces &found) {
        const auto &[graph, sweep, faces, labels] = found;
        if (sweep.droppedCount != 0 || faces.left.size() != graph.edges.size()) {
            return notValid(); // edges meet, so that there are no faces
        }
        if (graph.edges.size() != domain_.segments.size() || graph.node.size() != domain_.nodes.size()) {
            return notValid();
        }
        std::vector<std::uint32_t> region(faces.count, kOutside);
        for (std::uint32_t face = 0; face < faces.count; ++face) {
            if (labels.inside[face] != 0) {
                region[face] = static_cast<std::uint32_t>(result_.regions.size());
                result_.regions.push_back({labels.tag[face], 0.0});
            }
        }
        left_.resize(domain_.segments.size());
        right_.resize(domain_.segments.size());
        std::vector<std::uint8_t> hasSegments(domain_.nodes.size(), 0);
        for (std::size_t s = 0; s < domain_.segments.size(); ++s) { // all of them are edges, in the same order
            left_[s] = region[faces.left[s]];
            right_[s] = region[faces.right[s]];
            if (left_[s] == kOutside && right_[s] == kOutside) {
                return notValid();
            }
            hasSegments[domain_.segments[s].a] = hasSegments[domain_.segments[s].b] = 1;
        }
        std::vector<std::uint8_t> listed(domain_.nodes.size(), 0);
        for (const ConstraintPoint &point : domain_.points) {
            if (hasSegments[point.node] == 0 && listed[point.node] == 0) {
                const std::uint32_t face = faces.ofPoint[point.node];
                if (face == kNoIndex || region[face] == kOutside) {
                    return notValid();
                }
                listed[point.node] = 1;
                points_.push_back(point);
                pointRegion_.push_back(region[face]);
                pointBelow_.push_back(sweep.below[sweep.canonical[point.node]]);
            }
        }
        return {};
    }

    /// Returns false when cancelled.
    bool sampleNodes() {
        constexpr std::size_t kBatch = 4096;
        rho_.resize(domain_.nodes.size());
        const std::span<const Vec2> nodes = domain_.nodes;
        const std::span<double> rho = rho_;
        for (std::size_t first = 0; first < nodes.size(); first += kBatch) {
            if (progress_.cancelled()) {
                return false;
            }
            const std::size_t count = std::min(kBatch, nodes.size() - first);
            spacing_.atMany(nodes.subspan(first, count), rho.subspan(first, count));
        }
        return true;
    }

    /// Estimates ∫ds/ρ roughly, to refuse an absurdly fine spacing before anything is built.
    Status refuseAbsurd() const {
        constexpr double kMargin = 1.2; // near the limit, the accurate integral decides
        double sum = 0.0, worst = 0.0;
        Vec2 worstPlace;
        for (std::size_t s = 0; s < domain_.segments.size(); ++s) {
            if (s % 256 == 0 && progress_.cancelled()) {
                return cancelled("discretising the boundary");
            }
            const std::uint32_t nodeA = domain_.segments[s].a, nodeB = domain_.segments[s].b;
            const Vec2 a = domain_.nodes[nodeA], b = domain_.nodes[nodeB];
            double pieces = 0.5 * distance(a, b) / rho_[nodeA] + 0.5 * distance(a, b) / rho_[nodeB];
            if (pieces > 64.0) {
                pieces = roughSpacingIntegral(spacing_, a, b, rho_[nodeA], rho_[nodeB]);
            }
            if (pieces > worst) {
                worst = pieces;
                worstPlace = midpoint(a, b);
            }
            sum += pieces;
        }
        return sum > kMargin * kMaxPieces ? tooMany(sum, worstPlace) : Status{};
    }

    Status cutSegments() {
        takeNodes();
        result_.segments.clear();
        result_.segments.reserve(domain_.segments.size());
        result_.stretches.clear();
        pieces_.clear();
        count_.assign(domain_.segments.size(), 1U);
        for (std::uint32_t s = 0; s < domain_.segments.size(); ++s) {
            if (s % 4096 == 0) {
                progress_("discretising", static_cast<double>(s) / static_cast<double>(domain_.segments.size()));
            }
            if (s % 256 == 0 && progress_.cancelled()) {
                return cancelled("discretising the boundary");
            }
            const std::uint32_t chain = curves_ ? curves_->chainOf(s) : kNoIndex;
            if (chain != kNoIndex && curves_->firstSegment(chain) != s) {
                continue; // the chain is processed at its first segment
            }
            if (Status faults = chain == kNoIndex ? cutSegment(s) : cutChain(chain); !faults.empty()) {
                return faults;
            }
        }
        return {};
    }

    /// Adds the nodes of the domain, except those that only divide curves into chords.
    void takeNodes() {
        result_.points = points_;
        number_.clear();
        if (!curves_ || !curves_->any()) {
            result_.nodes = domain_.nodes;
            return;
        }
        result_.nodes.clear();
        number_.assign(domain_.nodes.size(), kNoIndex);
        for (std::uint32_t n = 0; n < domain_.nodes.size(); ++n) {
            if (!curves_->vanishes(n)) {
                number_[n] = static_cast<std::uint32_t>(result_.nodes.size());
                result_.nodes.push_back(domain_.nodes[n]);
            }
        }
        for (ConstraintPoint &point : result_.points) {
            point.node = number_[point.node];
        }
    }

    std::uint32_t number(std::uint32_t node) const { return number_.empty() ? node : number_[node]; }

    /// Returns the fault of an integral that was not completed.
    Status faultOf(SpacingIntegral::Outcome outcome, Vec2 middle) const {
        switch (outcome) {
        case SpacingIntegral::Outcome::Done:
            break;
        case SpacingIntegral::Outcome::BadSpacing:
            return located("expression-value", "the spacing is not a positive number",
                           "make it finite and positive everywhere in the domain", integral_.badPlace());
        case SpacingIntegral::Outcome::TooMany:
            return tooMany(static_cast<double>(result_.segments.size()) + integral_.total(), middle);
        case SpacingIntegral::Outcome::Cancelled:
            return cancelled("discretising the boundary");
        }
        return {};
    }

    Status divideChain(std::uint32_t c) {
        if (!curves_->cuts(c).empty()) {
            return {};
        }
        const CurveChain &chain = curves_->chain(c);
        const SpacingField &spacing = periodic_.spacing(chain.segments.front());
        const double room = kMaxPieces - static_cast<double>(result_.segments.size());
        const auto outcome = curves_->divide(c, spacing, longest_, room, progress_, integral_);
        if (outcome != SpacingIntegral::Outcome::Done) {
            return faultOf(outcome, curves_->curve(c).point(std::midpoint(chain.t0, chain.t1)));
        }
        joinPiecesInTips(c);
        return {};
    }

    Status cutChain(std::uint32_t c) {
        const CurveChain &chain = curves_->chain(c);
        const std::uint32_t lead = periodic_.leadingChain(*curves_, c);
        if (lead == kNoIndex) {
            return PeriodicDivision::crossedElsewhere(curves_->curve(c).point(std::midpoint(chain.t0, chain.t1)));
        }
        if (Status faults = divideChain(lead); !faults.empty()) {
            return faults;
        }
        const bool backwards = lead != c && periodic_.chainReversed(*curves_, c);
        if (lead != c) {
            curves_->setCuts(c, periodic_.mirroredCuts(*curves_, lead, c));
        }
        const Curve &curve = curves_->curve(lead);
        const std::vector<double> &places = curves_->cuts(lead);
        const std::vector<double> &cuts = curves_->cuts(c);
        std::uint32_t from = number(chain.start);
        for (std::uint32_t i = 0; i + 1 < cuts.size(); ++i) {
            std::uint32_t to = number(chain.end);
            if (i + 2 < cuts.size()) {
                to = static_cast<std::uint32_t>(result_.nodes.size());
                const double at = places[backwards ? places.size() - 2 - i : i + 1];
                result_.nodes.push_back(periodic_.image(chain.segments.front(), curve.point(at)));
            }
            const std::uint32_t source = curves_->source({c, i});
            const bool forward = domain_.segments[source].stretch.t0 < domain_.segments[source].stretch.t1;
            result_.segments.push_back({from, to, domain_.segments[source].tag,
                                        forward ? left_[source] : right_[source],
                                        forward ? right_[source] : left_[source], source});
            recordPiece({chain.curve, cuts[i], cuts[i + 1]}, {c, i});
            from = to;
        }
        return {};
    }

    void recordPiece(const CurveStretch &stretch, const ChainPiece &piece) {
        if (!domain_.curves.empty()) {
            result_.stretches.push_back(stretch);
            pieces_.push_back(piece);
        }
    }

    Status cutSegment(std::uint32_t of) {
        const std::uint32_t s = periodic_.leader(of);
        if (curves_ && curves_->chainOf(s) != kNoIndex) {
            return PeriodicDivision::crossedElsewhere(
                midpoint(domain_.nodes[domain_.segments[s].a], domain_.nodes[domain_.segments[s].b]));
        }
        const DomainSegment &segment = domain_.segments[s];
        fractions_.clear();
        // The same nodes for either direction: fractions count from the lower end by x, then y.
        const Vec2 a = domain_.nodes[segment.a], b = domain_.nodes[segment.b];
        const bool forward = comesBefore(a, b);
        const Vec2 low = forward ? a : b, high = forward ? b : a;
        if (most_[s] > 1) {
            const SpacingField &spacing = periodic_.spacing(s);
            const bool tied = periodic_.ties(s);
            const double rhoLow = tied ? spacing.at(low) : rho_[forward ? segment.a : segment.b],
                         rhoHigh = tied ? spacing.at(high) : rho_[forward ? segment.b : segment.a];
            const double room = kMaxPieces - static_cast<double>(result_.segments.size());
            const auto outcome = integral_.integrate(spacing, low, high, rhoLow, rhoHigh, longest_, room, progress_);
            if (outcome != SpacingIntegral::Outcome::Done) {
                return faultOf(outcome, midpoint(a, b));
            }
            const std::uint32_t asked = elements_[s];
            if (asked > room) {
                return faultOf(SpacingIntegral::Outcome::TooMany, midpoint(a, b));
            }
            count_[s] = count_[of] =
                std::min(most_[s], asked > 0 ? asked : static_cast<std::uint32_t>(integral_.pieces()));
            if (const ElementBias bias = elements_.bias(s); asked > 0 && bias.any()) {
                const std::vector<double> places = elementPlaces(count_[s], forward ? bias : bias.reversed());
                fractions_.assign(places.begin() + 1, places.end() - 1);
            } else {
                integral_.cut(count_[s], fractions_);
            }
            if (asked == 0) {
                dropCutsInTips(s, forward);
            }
        }
        const bool ascending = forward != (of != s && periodic_.reversed(of));
        std::uint32_t from = number(domain_.segments[of].a);
        for (std::size_t i = 0; i < fractions_.size(); ++i) {
            const auto to = static_cast<std::uint32_t>(result_.nodes.size());
            const Vec2 place = lerp(low, high, fractions_[ascending ? i : fractions_.size() - 1 - i]);
            result_.nodes.push_back(periodic_.image(of, place));
            addPiece(from, to, of);
            from = to;
        }
        addPiece(from, number(domain_.segments[of].b), of);
        return {};
    }

    std::span<const NarrowEnd> narrowEndsOf(std::uint32_t segment) const {
        const auto before = [](const NarrowEnd &end, std::uint32_t s) { return end.segment < s; };
        const auto after = [](std::uint32_t s, const NarrowEnd &end) { return s < end.segment; };
        return {std::lower_bound(narrowEnds_.begin(), narrowEnds_.end(), segment, before),
                std::upper_bound(narrowEnds_.begin(), narrowEnds_.end(), segment, after)};
    }

    /// Removes the cuts of a chain that lie in narrow tips.
    void joinPiecesInTips(std::uint32_t c) {
        const CurveChain &chain = curves_->chain(c);
        for (const bool atStart : {true, false}) {
            const std::uint32_t s = atStart ? chain.segments.front() : chain.segments.back();
            for (const NarrowEnd &end : narrowEndsOf(s)) {
                const DomainSegment &segment = domain_.segments[s];
                if ((end.atA ? segment.a : segment.b) == (atStart ? chain.start : chain.end)) {
                    curves_->joinEnd(c, atStart, end.length);
                }
            }
        }
    }

    /// Removes the cuts of a segment that lie in narrow tips. `forward`: fractions count from its first node.
    void dropCutsInTips(std::uint32_t s, bool forward) {
        const double span = distance(domain_.nodes[domain_.segments[s].a], domain_.nodes[domain_.segments[s].b]);
        for (const NarrowEnd &end : narrowEndsOf(s)) {
            const double part = end.length / span;
            std::erase_if(fractions_, [&](double t) { return end.atA == forward ? t < part : t > 1.0 - part; });
        }
    }

    void addPiece(std::uint32_t a, std::uint32_t b, std::uint32_t source) {
        result_.segments.push_back({a, b, domain_.segments[source].tag, left_[source], right_[source], source});
        recordPiece(fractions_.empty() ? domain_.segments[source].stretch : CurveStretch{}, {kNoIndex, 0});
    }

    /// Halves the numbers of pieces. Returns false if none of these segments is divided.
    bool relax(const std::vector<std::uint32_t> &sources) {
        bool changed = false;
        for (const std::uint32_t s : sources) {
            if (count_[s] > 1) {
                most_[s] = count_[s] / 2;
                if (periodic_.ties(s)) {
                    most_[periodic_.mate(s)] = most_[s];
                }
                changed = true;
            }
        }
        return changed;
    }

    void finish() {
        sumAreas(result_);
        if (curves_) {
            result_.straightened = curves_->straightened();
        }
        result_.boundaryNames = domain_.boundaryNames;
        result_.regionNames = domain_.regionNames;
        progress_("discretising", 1.0);
    }

    const Domain &domain_;
    const SpacingField &spacing_;
    const Progress &progress_;
    bool keepBoundary_;
    NarrowTips narrowTips_;
    SegmentElements elements_;
    PeriodicDivision periodic_;
    double longest_; // without evaluating the spacing
    DiscreteDomain result_;
    std::optional<CurveCuts> curves_;         // unless the boundary is kept
    std::vector<std::uint32_t> number_;       // per node of the domain: its index in the result; empty if the same
    std::vector<ConstraintPoint> points_;     // isolated ones, by nodes of the domain
    std::vector<ChainPiece> pieces_;          // per result_.segments; without a chain for straight ones
    std::vector<std::uint32_t> left_, right_; // per domain segment: regions
    std::vector<std::uint32_t> pointRegion_;  // per points_
    std::vector<std::uint32_t> pointBelow_;   // likewise: the domain segment directly below
    std::vector<std::uint32_t> most_, count_; // per domain segment: pieces allowed and made
    std::vector<double> rho_;                 // at the nodes of the domain
    std::vector<NarrowEnd> narrowEnds_;       // by segment
    std::vector<double> fractions_;
    SpacingIntegral integral_;
};

} // namespace

double DiscreteDomain::area() const {
    CompensatedSum sum;
    for (const DiscreteRegion &region : regions) {
        sum.add(region.area);
    }
    return sum.value();
}

Box2 DiscreteDomain::bounds() const {
    Box2 box;
    for (const Vec2 node : nodes) {
        box.add(node);
    }
    return box;
}

Result<DiscreteDomain> discretise(const Domain &domain, const SpacingField &spacing, bool keepBoundary,
                                  const Progress &progress, const DomainFaces *faces, NarrowTips narrowTips,
                                  SegmentElements elements, const PeriodicSides *periodic) {
    return Discretiser(domain, spacing, keepBoundary, narrowTips, elements, periodic, progress).run(faces);
}

} // namespace forefront
