#include "ui/style/icon_path.hpp"

#include "core/engine/base/assert.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numbers>
#include <utility>

namespace forefront {

namespace {

/// Reads the commands and numbers of a path.
class PathReader {
  public:
    explicit PathReader(const char *path) : at_(path) {}

    /// Moves to the next command, or keeps the last one if a number follows. Returns false at the end.
    bool next() {
        skip();
        if (*at_ == '\0') {
            return false;
        }
        if (std::strchr("MLHVACZ", *at_) != nullptr) {
            command = *at_++;
        } else if (command == 'M') {
            command = 'L'; // further places after a move are lines
        }
        return true;
    }
    double number() {
        skip();
        char *end = nullptr;
        const double value = std::strtod(at_, &end);
        FOREFRONT_ASSERT(end != at_);
        at_ = end;
        return value;
    }
    glm::dvec2 place() {
        const double x = number();
        return {x, number()};
    }

    char command = 'M';

  private:
    void skip() {
        while (*at_ == ' ' || *at_ == ',') {
            ++at_;
        }
    }

    const char *at_;
};

/// Adds a circular arc from the end of a line; `large` and `clockwise` are the flags of SVG, whose y points down.
void addArc(IconLine &line, double radiusX, double radiusY, bool large, bool clockwise, glm::dvec2 to) {
    const glm::dvec2 from = line.back();
    const glm::dvec2 scale{radiusX, radiusY};
    const glm::dvec2 half = 0.5 * (to - from) / scale; // on the unit circle
    const double reach = std::min(1.0, glm::dot(half, half));
    const double away = std::sqrt((1.0 - reach) / std::max(reach, 1e-12));
    const double side = large == clockwise ? -1.0 : 1.0;
    const glm::dvec2 centre = 0.5 * (from + to) / scale + side * away * glm::dvec2{-half.y, half.x};
    const glm::dvec2 a = from / scale - centre, b = to / scale - centre;
    const double begin = std::atan2(a.y, a.x);
    double sweep = std::atan2(b.y, b.x) - begin;
    constexpr double kTurn = 2.0 * std::numbers::pi;
    sweep += clockwise && sweep < 0.0 ? kTurn : !clockwise && sweep > 0.0 ? -kTurn : 0.0;
    const int pieces = std::max(2, static_cast<int>(std::ceil(std::abs(sweep) * 8.0)));
    for (int k = 1; k < pieces; ++k) {
        const double angle = begin + sweep * k / pieces;
        line.push_back((centre + glm::dvec2{std::cos(angle), std::sin(angle)}) * scale);
    }
    line.push_back(to);
}

void addCubic(IconLine &line, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
    const glm::dvec2 a = line.back();
    constexpr int kPieces = 12;
    for (int k = 1; k <= kPieces; ++k) {
        const double t = static_cast<double>(k) / kPieces, s = 1.0 - t;
        line.push_back(s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d);
    }
}

} // namespace

std::vector<IconLine> flattenPath(const char *path) {
    std::vector<IconLine> lines;
    PathReader reader(path);
    while (reader.next()) {
        if (reader.command == 'M') {
            lines.push_back({reader.place()});
            continue;
        }
        FOREFRONT_ASSERT(!lines.empty());
        IconLine &line = lines.back();
        const glm::dvec2 from = line.back();
        switch (reader.command) {
        case 'L':
            line.push_back(reader.place());
            break;
        case 'H':
            line.push_back({reader.number(), from.y});
            break;
        case 'V':
            line.push_back({from.x, reader.number()});
            break;
        case 'A': {
            const double radiusX = reader.number(), radiusY = reader.number();
            reader.number(); // the rotation, which is 0
            const bool large = reader.number() != 0.0, clockwise = reader.number() != 0.0;
            addArc(line, radiusX, radiusY, large, clockwise, reader.place());
            break;
        }
        case 'C': {
            const glm::dvec2 b = reader.place(), c = reader.place();
            addCubic(line, b, c, reader.place());
            break;
        }
        default:
            line.push_back(line.front());
        }
    }
    return lines;
}

std::vector<IconLine> dashesOf(const std::vector<IconLine> &lines, double dash, double gap) {
    std::vector<IconLine> dashes;
    for (const IconLine &line : lines) {
        bool on = true;
        double left = dash;
        IconLine piece{line.front()};
        for (std::size_t k = 1; k < line.size(); ++k) {
            glm::dvec2 from = line[k - 1];
            double rest = glm::distance(from, line[k]);
            while (rest > left) {
                from = glm::mix(from, line[k], left / rest);
                if (on) {
                    piece.push_back(from);
                    dashes.push_back(std::move(piece));
                }
                piece = {from};
                on = !on;
                rest -= std::exchange(left, on ? dash : gap);
            }
            left -= rest;
            piece.push_back(line[k]);
        }
        if (on) {
            dashes.push_back(std::move(piece));
        }
    }
    return dashes;
}

std::vector<double> numbersIn(const char *text) {
    std::vector<double> numbers;
    char *end = nullptr;
    for (double value = std::strtod(text, &end); end != text; value = std::strtod(text, &end)) {
        numbers.push_back(value);
        text = end;
    }
    return numbers;
}

} // namespace forefront
