#include "core/teaching/moment/short_texts.hpp"

#include <array>
#include <cstddef>

namespace forefront {

namespace {

constexpr std::array<const char *, kStepCount> kSteps{
    "Boundary becomes front \xce\x93",
    "Take base segment AB",
    "Evaluate \xcf\x81 at AB",
    "Place ideal point C",
    "Find candidate nodes",
    "Score \xce\xb1 \xc2\xb7 \xce\xb4(AC) \xc2\xb7 \xce\xb4(CB)",
    "Sort; drop C if too near",
    "Test AC, CB against \xce\x93",
    "Store ABC, update \xce\x93",
    "Stop when \xce\x93 = \xe2\x88\x85",
};

constexpr std::array<const char *, kStepCount> kStepsOfSquares{
    "Boundary in two colours: \xce\x93",
    "Take a diagonal, else leg AB",
    "Evaluate \xcf\x81 at AB",
    "Place corners of a square",
    "Square, else search",
    "Score \xc2\xbd square \xc2\xb7 \xce\xb4 \xc2\xb7 \xce\xb4",
    "Sort; drop one colour, too near",
    "Test new sides against \xce\x93",
    "Store the square, update \xce\x93",
    "\xce\x93 = \xe2\x88\x85: drop diagonals",
};

} // namespace

std::string stepLine(Step step, const FrontRules *rules) {
    if (step == Step::TakeBase && rules != nullptr) {
        return "Take " + std::string(wordOf(rules->base)) + " segment AB";
    }
    if (step == Step::Score && rules != nullptr && !(rules->shapeWeight == 1.0 && rules->spacingWeight == 1.0)) {
        return "Score " + scoreFormula(*rules);
    }
    return kSteps[static_cast<std::size_t>(step) - 1];
}

std::string squareStepLine(Step step) {
    return kStepsOfSquares[static_cast<std::size_t>(step) - 1];
}

const char *shortVerdict(Verdict verdict) {
    switch (verdict) {
    case Verdict::NotTried:
        return "\xe2\x80\x93";
    case Verdict::Accepted:
        return "accepted";
    case Verdict::Withdrawn:
        return "too near";
    case Verdict::NotLeft:
        return "behind AB";
    case Verdict::OutsideAngle:
        return "outside";
    case Verdict::CrossesFront:
        return "crosses";
    case Verdict::ContainsNode:
        return "node inside";
    case Verdict::BadShape:
        return "bad shape";
    case Verdict::OneColour:
        return "one colour";
    case Verdict::FlatCorner:
        return "flat corner";
    }
    return "";
}

std::string shortName(const CandidateTrace &candidate) {
    switch (candidate.square) {
    case SquareKind::Row:
        return "row";
    case SquareKind::Opening:
        return "open";
    case SquareKind::Closing:
        return "close";
    case SquareKind::None:
        break;
    }
    return candidate.node == kNoNode ? std::string("C") : std::to_string(index(candidate.node));
}

} // namespace forefront
