#include "core/files/points/points.hpp"
#include "core/files/text/text_scanner.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace forefront {

namespace {

constexpr std::int32_t kUpper = 1, kLower = 2, kTrailing = 3; // tags

/// A point of an airfoil, and the byte of its line.
struct FoilPoint {
    Vec2 at;
    std::size_t offset = 0;
};

class AirfoilReader {
  public:
    explicit AirfoilReader(const SourceText &source) : source_(source), scanner_(source, '#', ',') {}

    Result<DomainFile> read() {
        if (!readPoints()) {
            return scanner_.faults();
        }
        if (points_.size() < 3) {
            scanner_.fail(0, "bad-count", "an airfoil needs at least 3 points, found " + std::to_string(points_.size()),
                          "give the name on the first line and a point, x and y, on each other line");
            return scanner_.faults();
        }
        build();
        return std::move(file_);
    }

  private:
    bool readPoints() {
        TextScanner line = scanner_;
        bool first = true;
        std::size_t counts[2] = {0, 0};
        while (scanner_.nextLine(line)) {
            const std::size_t place = line.offset();
            TextScanner words = line;
            const auto x = parseReal(words.word());
            const auto y = parseReal(words.word());
            if (first && !(x && y && words.atEnd())) {
                first = false; // the name
                continue;
            }
            first = false;
            FoilPoint point{{}, place};
            if (!line.real(point.at.x, {"x of a point"}) || !line.real(point.at.y, {"y of a point"})) {
                return scanner_.fail(line);
            }
            if (!line.atEnd()) {
                return scanner_.fail(line.offset(), "bad-syntax", "expected two numbers on a line, found more");
            }
            if (points_.empty() && counts[0] == 0 && areCounts(point.at)) {
                counts[0] = static_cast<std::size_t>(point.at.x);
                counts[1] = static_cast<std::size_t>(point.at.y);
            } else {
                points_.push_back(point);
            }
        }
        return scanner_.ok() && (counts[0] == 0 || joinSides(counts[0], counts[1]));
    }

    /// Coordinates are fractions of the chord, so that numbers from 2 on are Lednicer's counts.
    static bool areCounts(Vec2 numbers) {
        const auto isCount = [](double n) {
            return n >= 2.0 && n <= 1e6 && n == static_cast<double>(static_cast<int>(n));
        };
        return isCount(numbers.x) && isCount(numbers.y);
    }

    /// Makes one list, from the trailing edge along the upper side, of the two sides from the leading edge on.
    bool joinSides(std::size_t upper, std::size_t lower) {
        if (points_.size() != upper + lower) {
            return scanner_.fail(0, "bad-count",
                                 "expected " + std::to_string(upper) + " points on the upper side and " +
                                     std::to_string(lower) + " on the lower, found " + std::to_string(points_.size()) +
                                     " in all");
        }
        const auto middle = points_.begin() + static_cast<std::ptrdiff_t>(upper);
        const bool shared = points_.front().at == middle->at; // the leading edge, on both sides
        std::reverse(points_.begin(), middle);
        leading_ = upper - 1;
        if (shared) {
            points_.erase(middle);
        }
        return true;
    }

    void build() {
        if (leading_ == 0) {
            const auto least = std::min_element(points_.begin(), points_.end(),
                                                [](const auto &p, const auto &q) { return p.at.x < q.at.x; });
            leading_ = static_cast<std::size_t>(least - points_.begin());
        }
        std::vector<std::size_t> kept; // without repeated points
        for (std::size_t k = 0; k < points_.size(); ++k) {
            if (kept.empty() || points_[k].at != points_[kept.back()].at) {
                kept.push_back(k);
            }
        }
        const bool sharp = kept.size() > 3 && points_[kept.front()].at == points_[kept.back()].at;
        if (sharp) {
            kept.pop_back();
        }
        Domain &domain = file_.domain;
        const bool upperFirst = meanHeight(0, leading_) >= meanHeight(leading_, points_.size());
        domain.boundaryNames = {{kUpper, upperFirst ? "upper" : "lower"}, {kLower, upperFirst ? "lower" : "upper"}};
        for (std::size_t k = 0; k < kept.size(); ++k) {
            const FoilPoint &point = points_[kept[k]];
            const bool last = k + 1 == kept.size();
            domain.nodes.push_back(point.at);
            const std::int32_t tag = kept[k] < leading_ ? kUpper : last && !sharp ? kTrailing : kLower;
            domain.segments.push_back({static_cast<std::uint32_t>(k),
                                       static_cast<std::uint32_t>(last ? 0 : k + 1),
                                       tag,
                                       SegmentRole::Boundary,
                                       {}});
            if (source_.origin != nullptr) {
                source_.origin->of(DomainPartKind::Node).push_back({point.offset, {}});
                source_.origin->of(DomainPartKind::Segment).push_back({point.offset, {}});
            }
        }
        if (!sharp) {
            domain.boundaryNames.emplace(kTrailing, "trailing_edge");
        }
    }

    double meanHeight(std::size_t begin, std::size_t end) const {
        double sum = 0.0;
        for (std::size_t k = begin; k < end; ++k) {
            sum += points_[k].at.y / static_cast<double>(end - begin);
        }
        return sum;
    }

    const SourceText &source_;
    TextScanner scanner_;
    std::vector<FoilPoint> points_;
    std::size_t leading_ = 0; ///< the point at the leading edge; 0: not known yet
    DomainFile file_;
};

} // namespace

Result<DomainFile> readAirfoil(const SourceText &source) {
    return AirfoilReader(source).read();
}

} // namespace forefront
