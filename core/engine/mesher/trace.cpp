#include "core/engine/mesher/trace.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/mesher/square_text.hpp"

#include <algorithm>
#include <cstdio>

namespace forefront {

namespace {

const char *orderText(BaseRule rule) {
    switch (rule) {
    case BaseRule::Shortest:
        return ", the shortest first";
    case BaseRule::Oldest:
        return ", the oldest first";
    case BaseRule::Longest:
        return ", the longest first";
    case BaseRule::Random:
        return ", drawn at random";
    }
    return "";
}

/// Returns a factor of the score with its exponent: "α(ABC)^2"; empty if it does not count.
std::string powerText(const char *factor, const char *base, double exponent) {
    return exponent == 0.0 ? "" : exponent == 1.0 ? factor : base + ('^' + numberText(exponent, 4));
}

} // namespace

std::string scoreFormula(const FrontRules &rules) {
    const std::string shape = powerText("α(ABC)", "α(ABC)", rules.shapeWeight);
    const std::string spacing = powerText("δ(AC)·δ(CB)", "(δ(AC)·δ(CB))", rules.spacingWeight);
    return shape.empty() && spacing.empty() ? "1, the same for all"
                                            : shape + (shape.empty() || spacing.empty() ? "" : "·") + spacing;
}

std::string stepTitle(Step step, const FrontRules *rules) {
    switch (step) {
    case Step::BoundaryToFront:
        return "The boundary becomes the generation front";
    case Step::TakeBase:
        return std::string("Take a base segment AB from the front") +
               (rules != nullptr ? orderText(rules->base) : ", the next along it");
    case Step::EvaluateSpacing:
        return "Evaluate the node spacing at AB";
    case Step::IdealPoint:
        return "Place the ideal point C";
    case Step::FindCandidates:
        return "Find candidate nodes near C";
    case Step::Score:
        return "Score each: " + scoreFormula(rules != nullptr ? *rules : FrontRules());
    case Step::Sort:
        return "Sort; withdraw C if the front is too near";
    case Step::Test:
        return "Test candidate segments against the front";
    case Step::Update:
        return "Store the element, update front and grid";
    case Step::Finish:
        return "Stop when the front is empty";
    }
    return "";
}

const char *verdictText(Verdict verdict) {
    switch (verdict) {
    case Verdict::NotTried:
        return "not tried";
    case Verdict::Accepted:
        return "accepted";
    case Verdict::Withdrawn:
        return "too near the front";
    case Verdict::NotLeft:
        return "on AB or its meshed side";
    case Verdict::OutsideAngle:
        return "leaves the unmeshed side";
    case Verdict::CrossesFront:
        return "crosses the front";
    case Verdict::ContainsNode:
        return "a node lies inside";
    case Verdict::BadShape:
        return "badly shaped";
    case Verdict::OneColour:
        return "would join three nodes of one colour";
    case Verdict::FlatCorner:
        return "would flatten a corner of the boundary";
    }
    return "";
}

namespace {

std::string format(const char *pattern, double value) {
    char text[64];
    std::snprintf(text, sizeof text, pattern, value);
    return text;
}

std::string candidateName(const CandidateTrace &candidate) {
    if (candidate.node != kNoNode) {
        return "node " + std::to_string(index(candidate.node));
    }
    return candidate.over.empty() ? "the ideal point"
                                  : "one point for " + std::to_string(candidate.over.size() - 1) + " segments";
}

/// Returns a text such as "; 3 candidates rejected: 2 cross the front, 1 on AB or its meshed side". Points that are
/// withdrawn before any test do not count as rejected.
std::string rejections(const AdvanceExplanation &explanation) {
    struct Reason {
        Verdict verdict;
        const char *one;
        const char *many;
    };
    static constexpr Reason kReasons[] = {
        {Verdict::CrossesFront, "crosses the front", "cross the front"},
        {Verdict::ContainsNode, "encloses a node", "enclose a node"},
        {Verdict::OutsideAngle, "leaves the unmeshed side", "leave the unmeshed side"},
        {Verdict::NotLeft, "on AB or its meshed side", "on AB or its meshed side"}};
    const auto countOf = [&](Verdict verdict) {
        return static_cast<std::size_t>(
            std::count_if(explanation.candidates.begin(), explanation.candidates.end(),
                          [verdict](const CandidateTrace &candidate) { return candidate.verdict == verdict; }));
    };
    std::string list;
    std::size_t total = 0;
    for (const Reason &reason : kReasons) {
        const std::size_t count = countOf(reason.verdict);
        if (count > 0) {
            list += (list.empty() ? "" : ", ") + std::to_string(count) + ' ' + (count == 1 ? reason.one : reason.many);
            total += count;
        }
    }
    std::string text = total == 0 ? "" : "; " + countText(total, "candidate") + " rejected: " + list;
    const std::size_t withdrawn = countOf(Verdict::Withdrawn);
    if (withdrawn > 0) {
        text += "; " + countText(withdrawn, "new point") + " too near the front";
    }
    return text;
}

std::string outcome(const AdvanceExplanation &explanation) {
    std::string text;
    if (explanation.deferred) {
        text = "no candidate passes, the segment is deferred";
    } else {
        const auto accepted =
            std::find_if(explanation.candidates.begin(), explanation.candidates.end(),
                         [](const CandidateTrace &candidate) { return candidate.verdict == Verdict::Accepted; });
        text = accepted == explanation.candidates.end() ? "element stored" : candidateName(*accepted) + " accepted";
        const bool several = explanation.elements > 1;
        if (several) {
            text += ", " + std::to_string(explanation.elements) + " elements in one advance";
        }
        if (accepted != explanation.candidates.end()) {
            text += (several ? " (minimum α " : " (α ") + format("%.3f", accepted->alpha) + ')';
        }
    }
    return text + rejections(explanation);
}

std::string baseText(const AdvanceExplanation &explanation, const TraceEvent &event) {
    if (explanation.walked) {
        return "next along the front, taken as base AB";
    }
    const auto text = [&](const std::string &chosen) {
        return chosen +
               (explanation.earlierDeferred ? ", leaving out those deferred, taken as base AB" : ", taken as base AB");
    };
    switch (explanation.rules.base) {
    case BaseRule::Oldest:
        return text("the oldest segment of the front");
    case BaseRule::Random:
        return text("a segment of the front drawn at random");
    case BaseRule::Shortest:
    case BaseRule::Longest:
        break;
    }
    const std::string kind = explanation.rules.base == BaseRule::Shortest ? "shortest" : "longest";
    if (event.equal == 0) {
        return "one of the " + kind + " segments of the front, taken as base AB";
    }
    return text(event.equal == 1
                    ? "the " + kind + " segment of the front"
                    : "the oldest of the " + std::to_string(event.equal) + ' ' + kind + " segments of the front");
}

std::string sortText(const AdvanceExplanation &explanation, const TraceEvent &event) {
    if (event.candidate == kNoIndex) {
        return "no candidate is near enough";
    }
    const std::string best = candidateName(explanation.candidates[event.candidate]);
    return event.equal > 1 ? "best first, of " + std::to_string(event.equal) + " equal ones the lowest number: " + best
                           : "best first: " + best;
}

std::string testText(const AdvanceExplanation &explanation, const TraceEvent &event) {
    const CandidateTrace &candidate = explanation.candidates[event.candidate];
    std::string text = "test " + candidateName(candidate);
    if (event.test != kNoIndex) {
        text += explanation.tests[event.test].meets ? ": a candidate segment meets the front"
                                                    : ": this segment of the front is clear";
    } else if (candidate.verdict != Verdict::NotTried) {
        text += std::string(": ") + verdictText(candidate.verdict);
    }
    return text;
}

} // namespace

std::string caption(const AdvanceExplanation &explanation, std::size_t cursor) {
    std::string text =
        "Edge " + std::to_string(index(explanation.nodeA)) + "-" + std::to_string(index(explanation.nodeB)) + ": ";
    if (explanation.coloured) {
        return text + squareCaption(explanation, cursor);
    }
    if (cursor >= explanation.events.size()) {
        return text + outcome(explanation);
    }
    const TraceEvent &event = explanation.events[cursor];
    switch (event.step) {
    case Step::BoundaryToFront:
    case Step::TakeBase:
        return text + baseText(explanation, event);
    case Step::EvaluateSpacing:
        return text + "node spacing ρ = " + format("%.4g", explanation.rho) + " here";
    case Step::IdealPoint:
        return text + "ideal point C at (" + format("%.4g", explanation.ideal.x) + ", " +
               format("%.4g", explanation.ideal.y) + ')';
    case Step::FindCandidates:
        return text + "the front nodes near C become candidates";
    case Step::Score:
        return text + "each candidate scored by " + scoreFormula(explanation.rules);
    case Step::Sort:
        return text + sortText(explanation, event);
    case Step::Test:
        return text + testText(explanation, event);
    case Step::Update:
    case Step::Finish:
        return text + outcome(explanation) + (event.step == Step::Finish ? "; the front is empty" : "");
    }
    return text;
}

} // namespace forefront
