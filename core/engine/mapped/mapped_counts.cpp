#include "core/engine/mapped/mapped_counts.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/curve_chains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace forefront {

namespace {

constexpr double kMaxOfCurve = 10'000'000; ///< elements

/// Lines and parts of curves that are divided as one, with the numbers of their elements.
class DividedLines {
  public:
    DividedLines(const MappedDivision &division, const DiscreteDomain &boundary)
        : division_(division), chains_(curveChains(division.domain)), first_(division.domain.segments.size()),
          count_(first_.size(), 0), asked_(first_.size(), 0) {
        for (std::uint32_t s = 0; s < first_.size(); ++s) {
            const std::uint32_t own = lineOf(s);
            const bool tied = division.periodic.ties(own) && division.periodic.mates[own].follows;
            first_[s] = tied ? lineOf(division.periodic.mates[own].segment) : own;
        }
        for (const DiscreteSegment &segment : boundary.segments) {
            const std::uint32_t line = lineOf(segment.source);
            if (first_[line] == line) {
                ++count_[line];
            }
        }
        asked_ = count_;
    }

    /// Returns the line of a segment, as its first segment; periodic images have the line that they follow.
    std::uint32_t operator[](std::uint32_t segment) const { return first_[segment]; }
    std::uint32_t countOf(std::uint32_t line) const { return count_[line]; }
    bool changed() const { return count_ != asked_; }
    const CurveChains &chains() const { return chains_; }

    /// Gives one of some lines one more element. Returns false if none may have more.
    bool raiseOne(std::span<const std::uint32_t> lines) {
        std::uint32_t best = kNoIndex;
        for (const std::uint32_t line : lines) {
            if (!isFixed(line) && (best == kNoIndex || isCoarser(line, best))) {
                best = line;
            }
        }
        if (best == kNoIndex) {
            return false;
        }
        ++count_[best];
        return true;
    }

  private:
    std::uint32_t lineOf(std::uint32_t s) const {
        const std::uint32_t chain = chains_.ofSegment[s];
        return chain == kNoIndex || division_.keepBoundary ? s : chains_.list[chain].segments.front();
    }
    bool isFixed(std::uint32_t line) const { return division_.keepBoundary || division_.given[line] > 0; }
    /// Returns true if the elements of a line are longer relative to the spacing than those of another.
    bool isCoarser(std::uint32_t line, std::uint32_t other) const {
        return std::uint64_t{asked_[line]} * count_[other] > std::uint64_t{asked_[other]} * count_[line];
    }

    const MappedDivision &division_;
    CurveChains chains_;
    std::vector<std::uint32_t> first_;         ///< per segment: its line
    std::vector<std::uint32_t> count_, asked_; ///< per line, at its first segment
};

/// A side of a face as the lines that it consists of.
struct CountedSide {
    std::vector<std::uint32_t> lines; ///< each once; a side may be longer than one line of it
    std::uint32_t firstSegment = 0;
};

CountedSide countedSide(const DividedLines &lines, const std::vector<std::uint32_t> &segments) {
    CountedSide side;
    side.firstSegment = segments.front();
    for (const std::uint32_t s : segments) {
        if (side.lines.empty() || side.lines.back() != lines[s]) {
            side.lines.push_back(lines[s]);
        }
    }
    return side;
}

std::uint64_t sumOf(const DividedLines &lines, const CountedSide &side) {
    std::uint64_t sum = 0;
    for (const std::uint32_t line : side.lines) {
        sum += lines.countOf(line);
    }
    return sum;
}

/// Pairs of sides that must have equal numbers.
std::vector<std::array<CountedSide, 2>> oppositeSides(const DividedLines &lines, const MappedDivision &division) {
    std::vector<std::array<CountedSide, 2>> pairs;
    for (const TransfiniteFace &face : division.faces) {
        const auto side = [&](std::size_t k) { return countedSide(lines, face.sides[k]); };
        if (face.sides.size() == 3) {
            pairs.push_back({side(0), side(2)});
        } else {
            pairs.push_back({side(0), side(2)});
            pairs.push_back({side(1), side(3)});
        }
    }
    for (const StripFace &strip : division.strips) {
        for (const StripPiece &piece : strip.pieces) {
            pairs.push_back({countedSide(lines, piece.left), countedSide(lines, piece.right)});
        }
    }
    return pairs;
}

Diagnostics unequal(const Domain &domain, const CountedSide &fewer, std::uint64_t has, std::uint64_t opposite,
                    const char *why, const char *advice) {
    const DomainSegment &segment = domain.segments[fewer.firstSegment];
    Diagnostics faults = error("mapped-sides",
                               "a side of a mapped face or strip has " + countText(has, "element") +
                                   ", the opposite one has " + std::to_string(opposite) + ", and " + why,
                               advice);
    faults.front().at = midpoint(domain.nodes[segment.a], domain.nodes[segment.b]);
    faults.front().parts = {aSegment(fewer.firstSegment)};
    return faults;
}

/// Raises numbers until opposite sides are equal, or one of them has more than the limit.
Status equalise(const MappedDivision &division, DividedLines &lines, const Progress &progress) {
    const Domain &domain = division.domain;
    const std::vector<std::array<CountedSide, 2>> pairs = oppositeSides(lines, division);
    std::uint64_t total = 0, raised = 0;
    for (const auto &pair : pairs) {
        total += sumOf(lines, pair[0]) + sumOf(lines, pair[1]);
    }
    // Where sides are parts of each other's opposite sides, no numbers are equal.
    const std::uint64_t limit = 64 * total * (pairs.size() + 1);
    for (bool again = true; again;) {
        again = false;
        for (const auto &pair : pairs) {
            for (;;) {
                const std::uint64_t p = sumOf(lines, pair[0]), q = sumOf(lines, pair[1]);
                if (p == q) {
                    break;
                }
                if (static_cast<double>(std::max(p, q)) > division.maxElements) {
                    return {};
                }
                if (progress.cancelled()) {
                    return cancelled("filling mapped faces");
                }
                again = true;
                const CountedSide &fewer = pair[p < q ? 0 : 1];
                if (!lines.raiseOne(fewer.lines)) {
                    return unequal(domain, fewer, std::min(p, q), std::max(p, q), "its lines must keep their numbers",
                                   "give both the same number of elements, or none");
                }
                if (++raised > limit) {
                    return unequal(domain, fewer, std::min(p, q), std::max(p, q), "no numbers make both equal",
                                   "divide the faces so that whole sides meet");
                }
            }
        }
    }
    return {};
}

} // namespace

namespace {

/// Makes a chain a curve of its own, and returns the number of the whole curve that gives the chain `count` elements; 0
/// if it would be above kMaxOfCurve.
std::uint32_t numberOfOwnCurve(Domain &domain, const CurveChain &chain, std::uint32_t count) {
    const auto own = static_cast<std::uint32_t>(domain.curves.size());
    domain.curves.push_back(Curve(domain.curves[chain.curve]));
    for (const std::uint32_t s : chain.segments) {
        domain.segments[s].stretch.curve = own;
    }
    CurveChain alone = chain;
    alone.curve = own;
    // The share of the chain is the difference of two rounded numbers: it is less than one above the exact share, and
    // changes by one at most from number to number, so that no count is passed over.
    const Curve &curve = domain.curves[own];
    const double part = curve.length(chain.t0, chain.t1) / curve.length(0.0, 1.0);
    const double first = std::max<double>(count, std::floor((count - 1.0) / part)), last = first + 3.0 / part + 3.0;
    if (!(last <= kMaxOfCurve)) {
        return 0;
    }
    std::vector<std::uint32_t> elements(domain.segments.size(), 0);
    for (auto whole = static_cast<std::uint32_t>(first); whole <= last; ++whole) {
        elements[chain.segments.front()] = whole;
        if (elementsAlong(domain, alone, elements) >= count) {
            return whole;
        }
    }
    return 0;
}

/// Counts the elements of all faces and strips.
void countCells(const DividedLines &lines, const MappedDivision &division, MappedNumbers &numbers) {
    for (const TransfiniteFace &face : division.faces) {
        const auto sum = [&](std::size_t k) {
            return static_cast<double>(sumOf(lines, countedSide(lines, face.sides[k])));
        };
        const double across = sum(1);
        const bool three = face.sides.size() == 3; // the cells about the first corner are triangles
        const double cells = std::max(sum(0), sum(2)) * (three ? across : std::max(across, sum(3)));
        numbers.inFaces += face.quads ? cells : 2.0 * cells - (three ? across : 0.0);
    }
    for (const StripFace &strip : division.strips) {
        for (const StripPiece &piece : strip.pieces) {
            const auto along = static_cast<double>(sumOf(lines, countedSide(lines, piece.left)));
            numbers.inStrips += along * strip.rows * (strip.cells == LayerCells::Quads ? 1.0 : 2.0);
        }
    }
}

} // namespace

Result<MappedNumbers> equalNumbers(const MappedDivision &division, const DiscreteDomain &boundary,
                                   const Progress &progress) {
    DividedLines lines(division, boundary);
    if (Status faults = equalise(division, lines, progress); !faults.empty()) {
        return faults;
    }
    MappedNumbers numbers{division.domain, {}, {}, lines.changed()};
    countCells(lines, division, numbers);
    if (numbers.inFaces + numbers.inStrips > division.maxElements) {
        return numbers;
    }
    numbers.elements.resize(division.domain.segments.size());
    for (std::uint32_t s = 0; s < numbers.elements.size(); ++s) {
        numbers.elements[s] = division.given[s];
        numbers.biases.push_back(division.given[s] > 0 ? division.given.bias(s) : ElementBias{});
    }
    std::vector<bool> mapped(numbers.elements.size(), false);
    for (const TransfiniteFace &face : division.faces) {
        for (const std::vector<std::uint32_t> &side : face.sides) {
            for (const std::uint32_t s : side) {
                mapped[lines[s]] = true;
            }
        }
    }
    for (const StripFace &strip : division.strips) {
        for (const StripPiece &piece : strip.pieces) {
            mapped[lines[piece.left.front()]] = mapped[lines[piece.right.front()]] = true;
        }
    }
    for (std::uint32_t s = 0; s < numbers.elements.size(); ++s) {
        if (mapped[lines[s]] && division.given[lines[s]] == 0) {
            numbers.elements[s] = lines.countOf(lines[s]);
        }
    }
    // The number of a curve is shared by all its parts: each part becomes a curve of its own.
    for (const CurveChain &chain : lines.chains().list) {
        if (numbers.elements[chain.segments.front()] == 0 || division.given[chain.segments.front()] > 0) {
            continue;
        }
        const std::uint32_t count = numbers.elements[chain.segments.front()];
        const std::uint32_t whole = numberOfOwnCurve(numbers.domain, chain, count);
        if (whole == 0) {
            Diagnostics faults = error("mapped-sides",
                                       "a side of a mapped face is a part of a curve so short that the whole curve "
                                       "would have more than " +
                                           numberText(kMaxOfCurve, 9) + " elements",
                                       "make the part a curve of its own");
            faults.front().at = division.domain.nodes[chain.start];
            return faults;
        }
        for (const std::uint32_t s : chain.segments) {
            numbers.elements[s] = whole;
        }
    }
    return numbers;
}

} // namespace forefront
