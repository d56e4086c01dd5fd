#include "core/teaching/trace/trace_compare.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/session/mesh_stepper.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

std::string baseText(Vec2 a, Vec2 b) {
    return placeText(a) + "-" + placeText(b) + ", " + numberText(distance(a, b), 6) + " long";
}

/// The verdicts that agree: whichever test rejects a candidate, it is rejected.
bool sameVerdict(Verdict a, Verdict b) {
    const auto rejected = [](Verdict v) { return v >= Verdict::NotLeft; };
    return a == b || (rejected(a) && rejected(b));
}

/// Compares one advance with what another program says of it.
class AdvanceComparison {
  public:
    AdvanceComparison(const AdvanceExplanation &ours, std::size_t front, const TracedAdvance &theirs,
                      const FrontRules &rules, double tolerance)
        : ours_(ours), front_(front), theirs_(theirs), rules_(rules), tolerance_(tolerance) {}

    /// Returns the first difference; empty if there is none.
    std::string difference() const {
        for (const auto part :
             {&AdvanceComparison::base, &AdvanceComparison::spacing, &AdvanceComparison::ideal,
              &AdvanceComparison::candidates, &AdvanceComparison::elements, &AdvanceComparison::front}) {
            if (std::string found = (this->*part)(); !found.empty()) {
                return found;
            }
        }
        return {};
    }

    /// Returns which test rejects each candidate that another one rejects there, provided that there is no difference.
    std::vector<std::string> otherTests() const {
        std::vector<std::string> found;
        for (std::size_t k = 0; theirs_.candidates && k < theirs_.candidates->size(); ++k) {
            const TracedCandidate &there = (*theirs_.candidates)[k];
            const auto isHere = [&](const CandidateTrace &here) { return same(there.at, here.position); };
            const auto here = std::find_if(ours_.candidates.begin(), ours_.candidates.end(), isHere);
            const bool known = std::any_of(ours_.candidates.begin(), ours_.candidates.end(), [&](const auto &one) {
                return isHere(one) && one.verdict == there.verdict;
            });
            if (there.verdict && !known && here != ours_.candidates.end()) {
                found.push_back(verdictsText(*here, *there.verdict));
            }
        }
        return found;
    }

  private:
    bool same(Vec2 p, Vec2 q) const { return distance(p, q) <= tolerance_; }
    static bool same(double p, double q) {
        return std::abs(p - q) <= kTraceTolerance * std::max(std::abs(p), std::abs(q));
    }

    std::string base() const {
        const TracedAdvance &t = theirs_;
        if (same(t.a, ours_.a) && same(t.b, ours_.b)) {
            return {};
        }
        if (same(t.a, ours_.b) && same(t.b, ours_.a)) {
            return "the base " + baseText(t.a, t.b) + " has its ends exchanged: the unmeshed part is on the left of AB";
        }
        return "the base is " + baseText(ours_.a, ours_.b) + "; yours is " + baseText(t.a, t.b) + baseReason();
    }
    std::string baseReason() const {
        const double here = distance(ours_.a, ours_.b), there = distance(theirs_.a, theirs_.b);
        const bool classic = !ours_.events.empty() && ours_.events.front().equal > 0;
        if (!classic || rules_.base == BaseRule::Random) {
            return {};
        }
        const bool longest = rules_.base == BaseRule::Longest;
        const std::string deferred = ", but those that were deferred come after all others";
        if (rules_.base == BaseRule::Oldest) {
            return ". The oldest is taken first" + deferred +
                   ": those of the boundary come first, in their order, and of "
                   "two new ones AC is older than CB";
        }
        if (std::abs(here - there) <= tolerance_) {
            return std::string(". Of segments that are equally ") + (longest ? "long" : "short") +
                   " the oldest is taken: those of the boundary come first, in "
                   "their order, and of two new ones AC is older than CB";
        }
        return longest == (here > there)
                   ? std::string(". The ") + (longest ? "longest" : "shortest") + " is taken first" + deferred
                   : "";
    }
    std::string spacing() const {
        if (!theirs_.rho || same(*theirs_.rho, ours_.rho)) {
            return {};
        }
        return "rho is " + numberText(ours_.rho, 6) + "; yours is " + numberText(*theirs_.rho, 6) +
               (same(*theirs_.rho, ours_.fieldRho)
                    ? ", which is rho before it is clamped to [" + numberText(rules_.minRho, 6) + ", " +
                          numberText(rules_.maxRho, 6) + "] times |AB|"
                    : "");
    }
    std::string ideal() const {
        if (!theirs_.ideal || same(*theirs_.ideal, ours_.ideal)) {
            return {};
        }
        return "C is " + placeText(ours_.ideal) + "; yours is " + placeText(*theirs_.ideal);
    }

    std::string candidates() const {
        if (!theirs_.candidates) {
            return {};
        }
        for (const CandidateTrace &here : ours_.candidates) {
            if (here.verdict != Verdict::Withdrawn && !anyAt(here.position)) {
                return nameOf(here) + " is a candidate, with score " + numberText(here.score, 6) + "; yours lacks it";
            }
        }
        for (const TracedCandidate &there : *theirs_.candidates) {
            if (std::string found = candidate(there); !found.empty()) {
                return found;
            }
        }
        return {};
    }
    bool anyAt(Vec2 place) const {
        return std::any_of(theirs_.candidates->begin(), theirs_.candidates->end(),
                           [&](const TracedCandidate &there) { return same(there.at, place); });
    }
    /// A node that two searches found is two candidates here: one that agrees is enough.
    std::string candidate(const TracedCandidate &there) const {
        std::string found = "the node at " + placeText(there.at) +
                            " is not a candidate: " + (ours_.coloured ? "no square has its corner there, and " : "") +
                            "it is no node of the front within " + numberText(ours_.searchRadius, 6) + " of C";
        for (const CandidateTrace &here : ours_.candidates) {
            if (!same(there.at, here.position)) {
                continue;
            }
            if (there.score && !same(*there.score, here.score)) {
                found = "the score of " + nameOf(here) + " is " + numberText(here.score, 6) + "; yours is " +
                        numberText(*there.score, 6);
            } else if (there.verdict && !sameVerdict(*there.verdict, here.verdict)) {
                found = verdictsText(here, *there.verdict);
            } else {
                return {};
            }
        }
        return found;
    }
    std::string verdictsText(const CandidateTrace &here, Verdict theirs) const {
        return nameOf(here) + " is " + std::string(wordOf(here.verdict)) + blockOf(here) + "; yours is " +
               std::string(wordOf(theirs));
    }
    std::string nameOf(const CandidateTrace &here) const {
        return (here.square != SquareKind::None
                    ? std::string("the square that ") + squareText(here.square) + ", with a corner at "
                : here.node == kNoNode ? "C at "
                                       : "the node at ") +
               placeText(here.position);
    }
    static std::string blockOf(const CandidateTrace &here) {
        if (!here.blocked) {
            return {};
        }
        return here.blockA == here.blockB
                   ? " because of the node " + placeText(here.blockA)
                   : " because of the segment " + placeText(here.blockA) + "-" + placeText(here.blockB);
    }

    std::string elements() const {
        if (!theirs_.elements || sameElements(*theirs_.elements)) {
            return {};
        }
        if (sameButForTurn(*theirs_.elements)) {
            return "made: " + elementsText(ours_.made) +
                   "; yours is the same, but clockwise: " + elementsText(*theirs_.elements) +
                   ". The corners of an element go counter-clockwise";
        }
        return (ours_.made.empty() ? "no candidate passes, and AB is deferred" : "made: " + elementsText(ours_.made)) +
               "; yours: " + (theirs_.elements->empty() ? "deferred" : elementsText(*theirs_.elements));
    }
    using Elements = std::vector<std::array<Vec2, 3>>;

    bool sameElements(const Elements &theirs) const {
        return ours_.made.size() == theirs.size() &&
               std::all_of(ours_.made.begin(), ours_.made.end(), [&](const std::array<Vec2, 3> &here) {
                   return std::any_of(theirs.begin(), theirs.end(),
                                      [&](const std::array<Vec2, 3> &there) { return sameElement(here, there); });
               });
    }
    /// Returns true if the elements would be the same with those that are clockwise turned over.
    bool sameButForTurn(Elements theirs) const {
        for (auto &[a, b, c] : theirs) {
            if (cross(b - a, c - a) < 0.0) {
                std::swap(b, c);
            }
        }
        return sameElements(theirs);
    }
    bool sameElement(const std::array<Vec2, 3> &here, const std::array<Vec2, 3> &there) const {
        for (std::size_t k = 0; k < 3; ++k) {
            if (same(here[0], there[k]) && same(here[1], there[(k + 1) % 3]) && same(here[2], there[(k + 2) % 3])) {
                return true;
            }
        }
        return false;
    }
    static std::string elementsText(const Elements &elements) {
        std::string text;
        for (const std::array<Vec2, 3> &corners : elements) {
            text += (text.empty() ? "" : ", ") + placeText(corners[0]) + "-" + placeText(corners[1]) + "-" +
                    placeText(corners[2]);
        }
        return text;
    }

    std::string front() const {
        if (!theirs_.front || *theirs_.front == front_) {
            return {};
        }
        return "the front has " + std::to_string(front_) + " segments afterwards; yours has " +
               std::to_string(*theirs_.front);
    }

    const AdvanceExplanation &ours_;
    std::size_t front_;
    const TracedAdvance &theirs_;
    const FrontRules &rules_;
    double tolerance_;
};

} // namespace

Result<TraceComparison> compareTrace(MeshingJob job, std::span<const TracedAdvance> trace,
                                     std::optional<std::uint64_t> steps, const Progress &progress) {
    job.options.improve = ImproveLevel::None;
    job.options.order = ElementOrder::First;
    const bool hasRules = job.options.method == Method::Classic && !makesQuads(job.options);
    const FrontRules rules = hasRules ? job.options.rules : FrontRules();
    Result<MeshStepper> stepper = MeshStepper::create(std::move(job), progress);
    if (!stepper) {
        return stepper.faults();
    }
    const double tolerance = kTraceTolerance * length(stepper->mesh().bounds().size());
    const std::uint64_t last = steps.value_or(std::numeric_limits<std::uint64_t>::max());
    TraceComparison result;
    for (;;) {
        if (progress.cancelled()) {
            return error("cancelled", "the comparison was cancelled");
        }
        const bool ours = result.advances < last && stepper->advance() == 1;
        const bool theirs = result.advances < trace.size() && result.advances < last;
        if (!ours || !theirs) {
            result.agree = ours == theirs;
            if (ours) {
                result.difference = "your trace ends, but the front still has segments";
            } else if (theirs) {
                result.difference = "the run has ended with an empty front; your trace goes on";
                result.offset = trace[result.advances].offset;
            }
            return result;
        }
        const TracedAdvance &other = trace[result.advances];
        const std::shared_ptr<const AdvanceExplanation> told = stepper->explanation();
        const AdvanceComparison compared(*told, stepper->front().size(), other, rules, tolerance);
        result.difference = compared.difference();
        if (!result.difference.empty()) {
            result.offset = other.offset;
            return result;
        }
        if (const std::vector<std::string> tests = compared.otherTests(); !tests.empty()) {
            if (result.otherTests == 0) {
                result.otherTest = "advance " + std::to_string(result.advances + 1) + ": " + tests.front();
            }
            result.otherTests += tests.size();
        }
        ++result.advances;
    }
}

} // namespace forefront
