#include "core/drawing_files/clipboard/coordinate_list.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {
namespace {

bool begins(char c) {
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
}

/// Reads a number at the start of `text` and removes it; none if there is no finite one.
std::optional<double> takeNumber(std::string_view &text) {
    if (text.starts_with('+')) {
        text.remove_prefix(1);
    }
    double value = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc() || !std::isfinite(value)) {
        return std::nullopt;
    }
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

/// Returns the number in a cell of a table. The last point or comma is the decimal sign; the other may separate
/// thousands before it.
std::optional<double> numberIn(std::string_view cell) {
    const std::size_t last = cell.find_last_of(".,");
    if (last != std::string_view::npos && cell.find(cell[last]) != last) {
        return std::nullopt; // two decimal signs
    }
    std::string digits;
    for (std::size_t k = 0; k < cell.size(); ++k) {
        if (k == last) {
            digits += '.';
        } else if (cell[k] != '.' && cell[k] != ',') {
            digits += cell[k];
        }
    }
    std::string_view rest = digits;
    const std::optional<double> number = digits.empty() || !begins(digits[0]) ? std::nullopt : takeNumber(rest);
    return rest.empty() ? number : std::nullopt;
}

/// A point, and whether its line goes on after it.
struct ListedPoint {
    Vec2 at;
    bool more = false;
};

constexpr std::string_view kFillers = " \t\r,;|\"'()[]{}";

bool goesOn(std::string_view rest) {
    return rest.find_first_not_of(kFillers) != std::string_view::npos;
}

/// Returns the first two cells of a line separated by tabs or semicolons; none if they are not numbers.
std::optional<ListedPoint> pointInCells(std::string_view line) {
    constexpr std::string_view kBlank = " \r\"'()[]{}";
    double values[2] = {};
    std::size_t found = 0;
    while (found < 2 && !line.empty()) {
        const std::size_t end = std::min(line.find_first_of(";\t"), line.size());
        std::string_view cell = line.substr(0, end);
        line.remove_prefix(std::min(end + 1, line.size()));
        cell.remove_prefix(std::min(cell.find_first_not_of(kBlank), cell.size()));
        cell.remove_suffix(cell.size() - (cell.find_last_not_of(kBlank) + 1));
        if (cell.empty()) {
            continue;
        }
        const std::optional<double> number = numberIn(cell);
        if (!number) {
            return std::nullopt;
        }
        values[found++] = *number;
    }
    return found == 2 ? std::optional(ListedPoint{{values[0], values[1]}, goesOn(line)}) : std::nullopt;
}

/// Returns the first two numbers of a line; none if it begins with anything else or has fewer.
std::optional<ListedPoint> pointIn(std::string_view line) {
    if (line.find_first_of(";\t") != std::string_view::npos) {
        if (const std::optional<ListedPoint> point = pointInCells(line)) {
            return point;
        }
    }
    double values[2] = {};
    for (double &value : values) {
        const std::size_t at = line.find_first_not_of(kFillers);
        if (at == std::string_view::npos || !begins(line[at])) {
            return std::nullopt;
        }
        line.remove_prefix(at);
        const std::optional<double> number = takeNumber(line);
        if (!number) {
            return std::nullopt;
        }
        value = *number;
    }
    return ListedPoint{{values[0], values[1]}, goesOn(line)};
}

/// Returns the runs of lines with points. Notes other lines that are not blank, and numbers after the points.
std::vector<std::vector<Vec2>> runsIn(std::string_view text, ImportNotes *notes) {
    std::vector<std::vector<Vec2>> runs(1);
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        const std::optional<ListedPoint> point = pointIn(line);
        const auto note = [&](const char *code, const char *message) {
            if (notes != nullptr) {
                notes->add(code, message, "the clipboard", text, begin);
            }
        };
        if (point) {
            if (runs.back().empty() || runs.back().back() != point->at) {
                runs.back().push_back(point->at);
            }
            if (point->more) {
                note("more-columns", "only the first two numbers of a line are used");
            }
        } else {
            if (goesOn(line)) {
                note("other-lines", "lines without two numbers are ignored");
            }
            if (!runs.back().empty()) {
                runs.emplace_back();
            }
        }
        begin = end + 1;
    }
    if (runs.back().empty()) {
        runs.pop_back();
    }
    return runs;
}

Shape pathOf(std::vector<Vec2> points) {
    constexpr double kNear = 1.5; // gap between the ends of a closed path, in lengths of its longest segment
    Shape shape;
    double longest = 0.0;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        longest = std::max(longest, distance(points[k], points[k + 1]));
    }
    const bool closed = points.size() > 3 && distance(points.front(), points.back()) <= kNear * longest;
    if (closed && points.front() == points.back()) {
        points.pop_back();
    }
    const bool single = points.size() == 1;
    shape.form = formOf(closed ? ShapeKind::Polygon : single ? ShapeKind::Point : ShapeKind::Polyline);
    shape.use = closed ? ShapeUse::Boundary : ShapeUse::Constraint;
    shape.tag = closed ? 1 : 2;
    shape.nodes = std::move(points);
    return shape;
}

} // namespace

Result<Document> readCoordinates(std::string_view text, ImportNotes *notes) {
    Document document;
    for (std::vector<Vec2> &run : runsIn(text, notes)) {
        Shape shape = pathOf(std::move(run));
        shape.id = document.nextId++;
        document.shapes.push_back(std::make_shared<const Shape>(std::move(shape)));
    }
    if (document.shapes.empty()) {
        return error("no-drawing",
                     "the clipboard holds nothing to draw; expected an SVG drawing or lines with two "
                     "numbers each",
                     "copy two columns of a spreadsheet, or shapes from a drawing program");
    }
    return document;
}

} // namespace forefront
