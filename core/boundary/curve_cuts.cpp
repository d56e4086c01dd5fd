#include "core/boundary/curve_cuts.hpp"

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

/// Removes cuts beside pieces far shorter than the spacing where the joined piece is close to the curve, but leaves
/// `minimum` pieces. A bend too small to be seen, such as the hook that a control point beyond its end makes, would
/// otherwise become a separate piece with sharp elements beside it.
void joinShortPieces(std::vector<double> &fractions, const CurvePath &path, const SpacingField &spacing,
                     std::size_t minimum) {
    constexpr double kShort = 0.25;  // of the spacing, and of the longer piece
    constexpr double kVisible = 0.4; // of the tolerance: 1/5000 of the diagonal by default
    for (std::size_t i = 1; i + 1 < fractions.size() && fractions.size() > minimum + 1;) {
        const double from = fractions[i - 1], to = fractions[i + 1];
        const Vec2 at = path.at(fractions[i]);
        const auto [shorter, longer] = std::minmax({distance(path.at(from), at), distance(at, path.at(to))});
        if (shorter < kShort * std::min(spacing.at(at), longer) &&
            (path.allows(from, to) || path.deviation(from, to) < kVisible * path.tolerance)) {
            fractions.erase(fractions.begin() + static_cast<std::ptrdiff_t>(i));
        } else {
            ++i;
        }
    }
}

} // namespace

CurveCuts::CurveCuts(const Domain &domain)
    : domain_(domain), tolerance_(chordTolerance(domain)), straight_(domain.segments.size(), 0) {
    findChains();
}

void CurveCuts::findChains() {
    chains_ = curveChains(domain_, straight_);
    cuts_.assign(chains_.list.size(), {});
    first_.clear();
    inner_.clear();
    if (!any()) {
        return;
    }
    inner_.assign(domain_.nodes.size(), 0);
    for (const CurveChain &chain : chains_.list) {
        first_.push_back(*std::min_element(chain.segments.begin(), chain.segments.end()));
        for (const std::uint32_t s : chain.segments) {
            const DomainSegment &segment = domain_.segments[s];
            inner_[segment.a] = inner_[segment.b] = 1;
        }
    }
    for (const CurveChain &chain : chains_.list) {
        inner_[chain.start] = inner_[chain.end] = 0;
    }
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
    const double minimum = about.start == about.end ? 3.0 : 1.0; // a loop needs three
    const auto cutInto = [&](double count) {
        std::vector<double> fractions;
        integral.cut(static_cast<std::uint32_t>(std::max(minimum, count)), fractions);
        fractions.insert(fractions.begin(), 0.0);
        fractions.push_back(1.0);
        return fractions;
    };
    const auto allowed = [&](const std::vector<double> &fractions) {
        for (std::size_t i = 1; i < fractions.size(); ++i) {
            if (!path.allows(fractions[i - 1], fractions[i])) {
                return false;
            }
        }
        return true;
    };
    std::vector<double> fractions = cutInto(integral.pieces());
    if (!allowed(fractions)) {
        fractions = cutInto(std::ceil(integral.total()));
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
    joinShortPieces(fractions, path, spacing, static_cast<std::size_t>(minimum));
    cuts_[chain].clear();
    for (const double fraction : fractions) {
        cuts_[chain].push_back(std::lerp(about.t0, about.t1, fraction));
    }
    return outcome;
}

bool CurveCuts::isFine(const ChainPiece &piece) const {
    const std::vector<double> &cuts = cuts_[piece.chain];
    const CurveStretch &chord = domain_.segments[source(piece)].stretch;
    return cuts[piece.index + 1] - cuts[piece.index] < kFinest * (upper(chord) - lower(chord));
}

/// Replaces a piece by the chords along it, as straight segments.
void CurveCuts::straighten(const ChainPiece &piece) {
    const double from = cuts_[piece.chain][piece.index], to = cuts_[piece.chain][piece.index + 1];
    for (const std::uint32_t s : chains_.list[piece.chain].segments) {
        const CurveStretch &stretch = domain_.segments[s].stretch;
        if (lower(stretch) <= to && upper(stretch) >= from) {
            straight_[s] = 1;
        }
    }
}

void CurveCuts::refine(std::vector<ChainPiece> pieces) {
    std::sort(pieces.begin(), pieces.end());
    pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
    bool straightened = false;
    for (const ChainPiece &piece : pieces) {
        if (isFine(piece)) {
            straighten(piece);
            straightened = true;
        }
    }
    if (straightened) {
        findChains();
        return;
    }
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
