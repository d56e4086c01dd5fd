#include "core/teaching/film/film_labels.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr double kLabelSize = 13.0; ///< font size in pixels
constexpr double kLabelGap = 7.0;   ///< pixels between a point and its label
constexpr int kDirections = 8, kRings = 7;

std::string fixedText(double value, int decimals) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
    return {text.data(), end.ptr};
}

/// Returns the number of decimals, from 2 to 6, that tells different scores apart.
int scoreDecimals(const AdvanceExplanation &advance) {
    constexpr int kMin = 2, kMax = 6;
    constexpr double kEqual = 1e-8; // within rounding
    std::vector<double> scores;
    for (const CandidateTrace &candidate : advance.candidates) {
        if (candidate.square == SquareKind::None) { // squares are tried in turn, and labelled without a score
            scores.push_back(candidate.score);
        }
    }
    std::sort(scores.begin(), scores.end());
    const auto equal = [](double a, double b) { return b - a <= kEqual * std::abs(b); };
    scores.erase(std::unique(scores.begin(), scores.end(), equal), scores.end());
    for (int decimals = kMin; decimals < kMax; ++decimals) {
        std::set<std::string> texts;
        for (const double score : scores) {
            texts.insert(fixedText(score, decimals));
        }
        if (texts.size() == scores.size()) {
            return decimals;
        }
    }
    return kMax;
}

/// Returns true if a line touches a box: the part of it within the box is not empty.
bool touches(const FilmLine &line, const Box2 &box) {
    double from = 0.0, to = 1.0;
    const auto cut = [&](double start, double along, double low, double high) {
        if (along == 0.0) {
            return low <= start && start <= high;
        }
        const double first = (low - start) / along, second = (high - start) / along;
        from = std::max(from, std::min(first, second));
        to = std::min(to, std::max(first, second));
        return from <= to;
    };
    const Vec2 along = line.b - line.a;
    return cut(line.a.x, along.x, box.min.x, box.max.x) && cut(line.a.y, along.y, box.min.y, box.max.y);
}

/// Places labels one after another, each clear of the points and of the labels before it, and of the lines of the
/// scene, except for the edges of the mesh, if there is room for that.
class LabelPlacer {
  public:
    LabelPlacer(FilmScene &scene, double bottom) : scene_(scene), bottom_(bottom) {
        std::copy_if(scene.lines.begin(), scene.lines.end(), std::back_inserter(lines_),
                     [](const FilmLine &line) { return line.ink != Ink::Edge && line.ink != Ink::Cell; });
    }

    void avoid(Vec2 point) { points_.push_back(point); }

    /// Adds a label of a point, unless the point is not on the sheet; `away` is the preferred direction.
    void add(Vec2 point, Vec2 place, std::string text, Ink ink, Vec2 away) {
        if (!Box2{{0.0, 0.0}, {static_cast<double>(scene_.width), bottom_}}.contains(point)) {
            return;
        }
        const Vec2 size{filmTextWidth(text, kLabelSize), 0.75 * kLabelSize};
        const double first = std::atan2(away.y, away.x);
        const auto boxOf = [&](int k) {
            const int turn = k % kDirections; // 0, 1, -1, 2, -2, ... eighths
            const double eighths = (turn % 2 == 1 ? 1.0 : -1.0) * ((turn + 1) / 2);
            return boxAt(point, size, first + eighths * std::numbers::pi / 4.0, kLabelGap + size.y * (k / kDirections));
        };
        std::optional<int> found;
        for (const bool clear : {true, false}) {
            for (int k = 0; k < kDirections * kRings && !found; ++k) {
                if (isFree(boxOf(k)) && (!clear || isClear(boxOf(k)))) {
                    found = k;
                }
            }
        }
        const Box2 chosen = boxOf(found.value_or(0));
        boxes_.push_back(chosen);
        if (found.value_or(0) >= 2 * kDirections) {
            const Vec2 end{std::clamp(point.x, chosen.min.x, chosen.max.x),
                           std::clamp(point.y, chosen.min.y, chosen.max.y)};
            scene_.lines.push_back({point, end, Ink::Text, 0.6});
        }
        scene_.texts.push_back({{chosen.min.x, chosen.max.y}, std::move(text), ink, kLabelSize, place});
    }

  private:
    static Box2 boxAt(Vec2 point, Vec2 size, double angle, double gap) {
        const Vec2 half = 0.5 * size;
        const Vec2 middle = point + Vec2{std::cos(angle) * (gap + half.x), std::sin(angle) * (gap + half.y)};
        return {middle - half, middle + half};
    }
    bool isFree(const Box2 &box) const {
        constexpr double kApart = 2.0;
        const auto hits = [&](const Box2 &other) {
            return box.min.x < other.max.x + kApart && other.min.x < box.max.x + kApart &&
                   box.min.y < other.max.y + kApart && other.min.y < box.max.y + kApart;
        };
        return box.min.x >= 0.0 && box.min.y >= 0.0 && box.max.x <= scene_.width && box.max.y <= bottom_ &&
               std::none_of(boxes_.begin(), boxes_.end(), hits) &&
               std::none_of(points_.begin(), points_.end(), [&](Vec2 point) {
                   return hits({point, point});
               });
    }

    bool isClear(const Box2 &box) const {
        return std::none_of(lines_.begin(), lines_.end(), [&](const FilmLine &line) { return touches(line, box); });
    }

    FilmScene &scene_;
    double bottom_;
    std::vector<Vec2> points_;
    std::vector<FilmLine> lines_;
    std::vector<Box2> boxes_;
};

/// Returns the verdict on a candidate for its label, once it is known: " crosses the front". The legend explains the
/// colour of those that are not tested.
std::string verdictOf(const Moment &moment, std::size_t k) {
    const CandidateTrace &candidate = moment.advance->candidates[k];
    const Verdict verdict = candidate.verdict;
    if (!moment.judged[k] || verdict == Verdict::NotTried) {
        return {};
    }
    if (candidate.square != SquareKind::None) { // what it does is said already
        return verdict == Verdict::Accepted ? std::string() : std::string(", ") + verdictText(verdict);
    }
    return std::string(" ") + (verdict == Verdict::Withdrawn ? "too near" : verdictText(verdict));
}

} // namespace

void addLabels(const Moment &moment, const std::function<Vec2(Vec2)> &at, double bottom, FilmScene &scene) {
    const AdvanceExplanation &advance = *moment.advance;
    const Vec2 a = at(advance.a), b = at(advance.b), c = at(advance.ideal);
    LabelPlacer labels(scene, bottom);
    for (const Vec2 point : {a, b, c}) {
        labels.avoid(point);
    }
    for (std::size_t k = 0; k < moment.candidates; ++k) {
        labels.avoid(at(advance.candidates[k].position));
        if (advance.candidates[k].square == SquareKind::Opening) {
            labels.avoid(at(advance.candidates[k].second));
        }
    }
    const Vec2 middle = 0.5 * (a + b);
    labels.add(a, advance.a, "A", Ink::Base, a - c);
    labels.add(b, advance.b, "B", Ink::Base, b - c);
    if (moment.idealKnown) {
        labels.add(c, advance.ideal, "C", Ink::Text, c - middle);
    }
    const int decimals = scoreDecimals(advance);
    for (std::size_t k = 0; k < moment.candidates && moment.scoresKnown; ++k) {
        const CandidateTrace &candidate = advance.candidates[k];
        const std::string what =
            candidate.square == SquareKind::None ? fixedText(candidate.score, decimals) : squareText(candidate.square);
        const std::string text = std::to_string(k + 1) + ": " + what + verdictOf(moment, k);
        const Vec2 point = at(candidate.position);
        labels.add(point, candidate.position, text, Ink::Text, point - middle);
    }
}

} // namespace forefront
