#include "ui/workspace/view/candidate_text.hpp"

#include "ui/widgets/widgets.hpp"

#include <cmath>

namespace forefront {

namespace {

std::string placeText(Vec2 place) {
    return "(" + ui::number(place.x) + ", " + ui::number(place.y) + ")";
}

} // namespace

std::string clearanceText(const CandidateTrace &ideal, double rho) {
    const bool node = ideal.blockA == ideal.blockB;
    const std::string what = node ? "the node " + placeText(ideal.blockA)
                                  : "the segment " + placeText(ideal.blockA) + "\xe2\x80\x93" + placeText(ideal.blockB);
    return what + " is " + ui::number(ideal.blockDistance / rho, 3) + " \xcf\x81 away, nearer than " +
           ui::number(ideal.blockClearance / rho, 3) + " \xcf\x81";
}

int scoreDigits(const AdvanceExplanation &advance) {
    constexpr double kEqual = 1e-8; // within rounding
    const auto looksEqual = [&](double a, double b, double unit) {
        return std::abs(a - b) > kEqual * std::abs(a) && std::round(a * unit) == std::round(b * unit);
    };
    int digits = 2;
    for (double unit = 100.0; digits < 4; ++digits, unit *= 10.0) {
        bool same = false;
        for (std::size_t i = 1; i < advance.candidates.size(); ++i) { // by score
            same = same || looksEqual(advance.candidates[i - 1].score, advance.candidates[i].score, unit);
        }
        if (!same) {
            break;
        }
    }
    return digits;
}

} // namespace forefront
