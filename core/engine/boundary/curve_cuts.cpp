#include "core/engine/boundary/curve_cuts.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/domain/element_places.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace forefront {

namespace {

/// Pieces this much finer than the chords of the domain that still meet others show that the curves themselves do.
constexpr double kFinest = 1.0 / 8.0;

double lower(const CurveStretch &stretch) {
    return std::min(stretch.t0, stretch.t1);
}
double upper(const CurveStretch &stretch) {
    return std::max(stretch.t0, stretch.t1);
}

/// Returns true if one piece between two fractions is close enough to the curve.
bool canJoin(const CurvePath &path, double from, double to) {
    constexpr double kVisible = 0.4; // relative to the tolerance: 1/5000 of the diagonal by default
    return path.allows(from, to) || path.deviation(from, to) < kVisible * path.tolerance;
}

/// Removes cuts beside pieces far shorter than the spacing where the joined piece is close to the curve, but leaves
/// `minimum` pieces. A bend too small to be seen, such as the hook that a control point beyond its end makes, would
/// otherwise become a separate piece with sharp elements beside it.
void joinShortPieces(std::vector<double> &fractions, const CurvePath &path, const SpacingField &spacing,
                     std::size_t minimum) {
    constexpr double kShort = 0.25; // relative to the spacing
    constexpr double kUneven = 0.5; // relative to the longer piece
    for (std::size_t i = 1; i + 1 < fractions.size() && fractions.size() > minimum + 1;) {
        const double from = fractions[i - 1], to = fractions[i + 1];
        const Vec2 at = path.at(fractions[i]);
        const auto [shorter, longer] = std::minmax({distance(path.at(from), at), distance(at, path.at(to))});
        if (shorter < kUneven * longer && shorter < kShort * spacing.at(at) && canJoin(path, from, to)) {
            fractions.erase(fractions.begin() + static_cast<std::ptrdiff_t>(i));
            i -= i > 1 ? 1 : 0; // the previous piece now has a longer neighbour
        } else {
            ++i;
        }
    }
}

std::vector<double> cutInto(const SpacingIntegral &integral, std::uint32_t count) {
    std::vector<double> fractions;
    integral.cut(count, fractions);
    fractions.insert(fractions.begin(), 0.0);
    fractions.push_back(1.0);
    return fractions;
}

/// Cuts a curve into the pieces that the spacing asks for, at least `minimum`, and so many that all are close to it.
std::vector<double> cutClosely(const SpacingIntegral &integral, const CurvePath &path, const SpacingField &spacing,
                               std::uint32_t minimum) {
    const auto pieces = [&](double count) { return std::max(minimum, static_cast<std::uint32_t>(count)); };
    const auto allowed = [&](const std::vector<double> &fractions) {
        for (std::size_t i = 1; i < fractions.size(); ++i) {
            if (!path.allows(fractions[i - 1], fractions[i])) {
                return false;
            }
        }
        return true;
    };
    std::vector<double> fractions = cutInto(integral, pieces(integral.pieces()));
    if (!allowed(fractions)) {
        fractions = cutInto(integral, pieces(std::ceil(integral.total())));
    }
    constexpr int kMaxRounds = 12; // the integral already calls for nearly enough
    for (int round = 0; round < kMaxRounds && !allowed(fractions); ++round) {
        std::vector<double> finer = {0.0};
        for (std::size_t i = 1; i < fractions.size(); ++i) {
            if (!path.allows(fractions[i - 1], fractions[i])) {
                finer.push_back(std::midpoint(fractions[i - 1], fractions[i]));
            }
            finer.push_back(fractions[i]);
        }
        fractions = std::move(finer);
    }
    joinShortPieces(fractions, path, spacing, minimum);
    return fractions;
}

} // namespace

CurveCuts::CurveCuts(const Domain &domain, SegmentElements elements)
    : domain_(domain), elements_(elements), tolerance_(chordTolerance(domain)), straight_(domain.segments.size(), 0),
      chains_(curveChains(domain)), inner_(chains_.list.empty() ? 0 : domain.nodes.size(), 0) {
    std::vector<CurveChain> chains;
    chains.swap(chains_.list);
    for (CurveChain &chain : chains) {
        addChain(std::move(chain));
    }
}

bool CurveCuts::any() const {
    return std::any_of(chains_.list.begin(), chains_.list.end(),
                       [](const CurveChain &chain) { return !chain.segments.empty(); });
}

/// Adds a chain, not divided yet.
void CurveCuts::addChain(CurveChain chain) {
    first_.push_back(*std::min_element(chain.segments.begin(), chain.segments.end()));
    for (const std::uint32_t s : chain.segments) {
        chains_.ofSegment[s] = static_cast<std::uint32_t>(chains_.list.size());
        inner_[domain_.segments[s].a] = inner_[domain_.segments[s].b] = 1;
    }
    inner_[chain.start] = inner_[chain.end] = 0;
    chains_.list.push_back(std::move(chain));
    cuts_.emplace_back();
}

std::uint32_t CurveCuts::source(const ChainPiece &piece) const {
    const std::vector<double> &cuts = cuts_[piece.chain];
    const double middle = 0.5 * (cuts[piece.index] + cuts[piece.index + 1]);
    const std::vector<std::uint32_t> &segments = chains_.list[piece.chain].segments;
    const auto after = std::partition_point(segments.begin(), segments.end() - 1, [&](std::uint32_t s) {
        return upper(domain_.segments[s].stretch) < middle;
    });
    return *after;
}

SpacingIntegral::Outcome CurveCuts::divide(std::uint32_t chain, const SpacingField &spacing, double longest,
                                           double limit, const Progress &progress, SpacingIntegral &integral) {
    const CurveChain &about = chains_.list[chain];
    const CurvePath path{&curve(chain), about.t0, about.t1, tolerance_};
    const SpacingIntegral::Outcome outcome = integral.integrate(spacing, path, longest, limit, progress);
    if (outcome != SpacingIntegral::Outcome::Done) {
        return outcome;
    }
    const std::uint32_t asked = elementsAlong(domain_, about, elements_);
    if (asked > limit) {
        return SpacingIntegral::Outcome::TooMany;
    }
    const std::uint32_t minimum = about.start == about.end ? 3 : 1; // a loop needs three
    cuts_[chain].clear();
    if (asked > 0 && biasAlong(domain_, about, elements_).any()) {
        cutWithBias(chain, asked);
        return outcome;
    }
    for (const double fraction : asked > 0 ? cutInto(integral, asked) : cutClosely(integral, path, spacing, minimum)) {
        cuts_[chain].push_back(std::lerp(about.t0, about.t1, fraction));
    }
    return outcome;
}

/// Divides a chain into the elements of a bias. Those of a part of a curve are as long as along the whole.
void CurveCuts::cutWithBias(std::uint32_t chain, std::uint32_t count) {
    const CurveChain &about = chains_.list[chain];
    const std::uint32_t whole = elements_[about.segments.front()];
    const std::vector<double> places = elementPlaces(whole, biasAlong(domain_, about, elements_));
    const auto [first, last] = elementsOfChain(domain_, about, places);
    cuts_[chain].push_back(about.t0);
    for (std::uint32_t k = 1; k < count; ++k) {
        const double before = std::lerp(first, last, static_cast<double>(k) / count);
        cuts_[chain].push_back(parameterAtLength(curve(chain), placeOfElement(places, before)));
    }
    cuts_[chain].push_back(about.t1);
}

bool CurveCuts::allowsPiece(std::uint32_t chain, double from, double to) const {
    return canJoin({&curve(chain), 0.0, 1.0, tolerance_}, std::min(from, to), std::max(from, to));
}

void CurveCuts::joinEnd(std::uint32_t chain, bool atStart, double length) {
    const CurveChain &about = chains_.list[chain];
    if (about.start == about.end || elementsAlong(domain_, about, elements_) > 0) {
        return;
    }
    std::vector<double> &cuts = cuts_[chain];
    const Curve &along = curve(chain);
    const std::size_t last = cuts.size() - 1;
    const auto cut = [&](std::size_t k) { return cuts[atStart ? k : last - k]; };
    const Vec2 end = along.point(cut(0));
    std::size_t joined = 0;
    while (joined + 1 < last && distance(along.point(cut(joined + 1)), end) < length &&
           allowsPiece(chain, cut(0), cut(joined + 2))) {
        ++joined;
    }
    const auto begin = atStart ? cuts.begin() + 1 : cuts.end() - 1 - static_cast<std::ptrdiff_t>(joined);
    cuts.erase(begin, begin + static_cast<std::ptrdiff_t>(joined));
}

bool CurveCuts::isFine(const ChainPiece &piece) const {
    const std::vector<double> &cuts = cuts_[piece.chain];
    const CurveStretch &chord = domain_.segments[source(piece)].stretch;
    return cuts[piece.index + 1] - cuts[piece.index] < kFinest * (upper(chord) - lower(chord));
}

/// Marks the chords along a piece as straight segments.
void CurveCuts::straighten(const ChainPiece &piece) {
    const double from = cuts_[piece.chain][piece.index], to = cuts_[piece.chain][piece.index + 1];
    for (const std::uint32_t s : chains_.list[piece.chain].segments) {
        const CurveStretch &stretch = domain_.segments[s].stretch;
        if (lower(stretch) <= to && upper(stretch) >= from) {
            straight_[s] = 1;
        }
    }
}

/// Replaces a chain by those between its straightened segments. It stays in the list, without segments.
void CurveCuts::cutOut(std::uint32_t chain) {
    const CurveChain whole = std::exchange(chains_.list[chain], {});
    cuts_[chain].clear();
    const auto endNode = [&](std::uint32_t s, bool upperEnd) {
        const DomainSegment &segment = domain_.segments[s];
        return (segment.stretch.t0 < segment.stretch.t1) == upperEnd ? segment.b : segment.a;
    };
    const auto isStraight = [&](std::uint32_t s) { return straight_[s] != 0; };
    for (auto from = whole.segments.begin(); from != whole.segments.end();) {
        if (isStraight(*from)) {
            chains_.ofSegment[*from] = kNoIndex;
            inner_[domain_.segments[*from].a] = inner_[domain_.segments[*from].b] = 0;
            ++from;
            continue;
        }
        const auto to = std::find_if(from, whole.segments.end(), isStraight);
        const std::uint32_t first = *from, last = *(to - 1);
        addChain({whole.curve,
                  endNode(first, false),
                  endNode(last, true),
                  lower(domain_.segments[first].stretch),
                  upper(domain_.segments[last].stretch),
                  {from, to}});
        from = to;
    }
}

void CurveCuts::refine(std::vector<ChainPiece> pieces) {
    std::sort(pieces.begin(), pieces.end());
    pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
    std::vector<std::uint32_t> straightened; // chains
    for (const ChainPiece &piece : pieces) {
        if (isFine(piece)) {
            straighten(piece);
            straightened.push_back(piece.chain);
        }
    }
    straightened.erase(std::unique(straightened.begin(), straightened.end()), straightened.end());
    for (const std::uint32_t chain : straightened) {
        cutOut(chain);
    }
    if (straightened.empty()) {
        halve(pieces);
    }
}

std::vector<std::uint32_t> CurveCuts::straightened() const {
    std::vector<std::uint32_t> segments;
    for (std::uint32_t s = 0; s < straight_.size(); ++s) {
        if (straight_[s] != 0) {
            segments.push_back(s);
        }
    }
    return segments;
}

/// Halves pieces, given in order.
void CurveCuts::halve(std::span<const ChainPiece> pieces) {
    for (std::size_t i = 0; i < pieces.size();) {
        const std::uint32_t chain = pieces[i].chain;
        std::vector<double> finer;
        const std::vector<double> &cuts = cuts_[chain];
        for (std::uint32_t index = 0; index < cuts.size(); ++index) {
            finer.push_back(cuts[index]);
            if (i < pieces.size() && pieces[i] == ChainPiece{chain, index}) {
                finer.push_back(std::midpoint(cuts[index], cuts[index + 1]));
                ++i;
            }
        }
        cuts_[chain] = std::move(finer);
    }
}

} // namespace forefront
