#include "core/engine/base/letter_case.hpp"
#include "core/files/common/names.hpp"
#include "core/files/common/tag_allocator.hpp"
#include "core/files/points/points.hpp"
#include "core/files/text/text_scanner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

namespace {

constexpr std::string_view kCsvBlanks = " \t\r";

struct Cell {
    std::string_view text;
    std::size_t offset = 0; ///< in the file
};

std::string_view withoutCsvBlanks(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(kCsvBlanks), text.size());
    text.remove_prefix(begin);
    text.remove_suffix(text.size() - (text.find_last_not_of(kCsvBlanks) + 1));
    return text;
}

/// Returns the character between the cells of a line; a blank stands for any number of blanks.
char separatorOf(std::string_view line) {
    for (const char c : {';', '\t', ','}) {
        if (line.find(c) != std::string_view::npos) {
            return c;
        }
    }
    return ' ';
}

std::vector<Cell> cellsOf(std::string_view line, std::size_t offset, char separator) {
    std::vector<Cell> cells;
    std::size_t at = 0;
    while (at <= line.size()) {
        std::size_t end =
            std::min(line.find_first_of(separator == ' ' ? " \t" : std::string_view(&separator, 1), at), line.size());
        const std::size_t open = line.find_first_not_of(' ', at);
        if (open < end && line[open] == '"') { // a separator in quotes is text
            const std::size_t close = std::min(line.find('"', open + 1), line.size());
            end = std::max(end, std::min(line.find(separator, close), line.size()));
        }
        std::string_view text = withoutCsvBlanks(line.substr(at, end - at));
        if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
            text = withoutCsvBlanks(text.substr(1, text.size() - 2));
        }
        if (separator != ' ' || !text.empty()) {
            cells.push_back({text, offset + (text.empty() ? at : static_cast<std::size_t>(text.data() - line.data()))});
        }
        at = end + 1;
    }
    return cells;
}

constexpr int kNoName = 3;

/// Returns how well a name of a column says that it holds the names of parts, 0: best.
int rankOfName(const std::string &name) {
    return name == "part" ? 0 : name == "path" ? 1 : name == "name" ? 2 : kNoName;
}

/// A run of points that are one path.
struct PointPath {
    std::string name;
    std::vector<Vec2> places;
    std::vector<std::size_t> offsets;
};

class CsvReader {
  public:
    explicit CsvReader(const SourceText &source) : source_(source), faults_(source) {}

    Result<DomainFile> read() {
        readLines();
        if (!faults_.ok()) {
            return faults_.faults();
        }
        for (PointPath &path : paths_) {
            build(path);
        }
        if (std::none_of(domain_.segments.begin(), domain_.segments.end(),
                         [](const DomainSegment &s) { return s.role == SegmentRole::Boundary; })) {
            return Diagnostics{faultAt(source_, 0, "empty-domain", "no three points in a row bound a domain",
                                       "list the points of an outline in order, one a line")};
        }
        domain_.boundaryNames = tags_.names();
        return std::move(file_);
    }

  private:
    void readLines() {
        const std::string_view text = source_.text;
        for (std::size_t begin = 0; begin < text.size() && faults_.ok() && faults_.proceed(begin);) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            const std::string_view line = withoutCsvBlanks(text.substr(begin, end - begin));
            if (line.empty()) {
                broken_ = true;
            } else if (line.front() != '#') {
                readLine(text.substr(begin, end - begin), begin);
            }
            begin = end + 1;
        }
    }

    void readLine(std::string_view line, std::size_t offset) {
        if (separator_ == '\0') {
            separator_ = separatorOf(withoutCsvBlanks(line));
            if (readNames(cellsOf(line, offset, separator_))) {
                return;
            }
        }
        const std::vector<Cell> cells = cellsOf(line, offset, separator_);
        const std::size_t needed = std::max(x_, y_) + 1;
        if (cells.size() < needed) {
            faults_.fail(offset, "bad-count",
                         "a line has " + std::to_string(cells.size()) + (cells.size() == 1 ? " cell" : " cells") +
                             "; expected at least " + std::to_string(needed),
                         "give x and y on each line, with the same separator as on the first line");
            return;
        }
        const std::optional<double> x = numberIn(cells[x_]), y = numberIn(cells[y_]);
        if (!x || !y) {
            return;
        }
        std::string name;
        if (name_ && *name_ < cells.size()) {
            name = cleanName(cells[*name_].text);
        }
        if (paths_.empty() || broken_ || name != paths_.back().name) {
            paths_.push_back({name, {}, {}});
            broken_ = false;
        }
        paths_.back().places.push_back({*x, *y});
        paths_.back().offsets.push_back(cells[x_].offset);
    }

    /// Reads the names of columns; returns false if the line has numbers instead.
    bool readNames(const std::vector<Cell> &cells) {
        if (cells.empty() || std::all_of(cells.begin(), cells.end(), [&](const Cell &cell) {
                return cell.text.empty() || parsed(cell.text).has_value();
            })) {
            return false;
        }
        if (cells.size() > 1 && parsed(cells[0].text) && parsed(cells[1].text)) {
            return false; // further columns may hold texts
        }
        std::optional<std::size_t> x, y;
        std::vector<std::string> others;
        int best = kNoName;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const std::string name = lowerCase(cells[k].text);
            const bool letter = name.size() == 1 ||
                                (name.size() > 1 && std::string_view(" _[(").find(name[1]) != std::string_view::npos);
            if (!x && ((letter && name[0] == 'x') || name == "easting")) {
                x = k;
            } else if (!y && ((letter && name[0] == 'y') || name == "northing")) {
                y = k;
            } else if (const int rank = rankOfName(name); rank < best) {
                if (name_) {
                    others.emplace_back(cells[*name_].text);
                }
                best = rank;
                name_ = k;
            } else {
                others.emplace_back(cells[k].text);
            }
        }
        if (!x || !y) {
            faults_.fail(cells[0].offset, "bad-syntax",
                         "the first line names no columns x and y; found " + listed(others, 6),
                         "name them x and y, or leave out the line of names");
            return true;
        }
        if (!others.empty()) {
            source_.note("more-columns", "other columns are not used: " + listed(others, 6), cells[0].offset);
        }
        x_ = *x;
        y_ = *y;
        return true;
    }

    std::optional<double> parsed(std::string_view text) const {
        std::string digits(text);
        if (separator_ == ';' || separator_ == '\t') {
            std::replace(digits.begin(), digits.end(), ',', '.');
        }
        return parseReal(digits);
    }

    std::optional<double> numberIn(const Cell &cell) {
        const std::optional<double> value = parsed(cell.text);
        if (value && std::isfinite(*value)) {
            return value;
        }
        faults_.fail(cell.offset, "bad-number", "expected a coordinate, found " + inQuotes(cell.text));
        return std::nullopt;
    }

    void build(const PointPath &path) {
        const auto first = static_cast<std::uint32_t>(domain_.nodes.size());
        for (std::size_t k = 0; k < path.places.size(); ++k) {
            const bool repeats = k > 0 && path.places[k] == domain_.nodes.back();
            const bool closes = k > 2 && k + 1 == path.places.size() && path.places[k] == path.places.front();
            if (!repeats && !closes) {
                domain_.nodes.push_back(path.places[k]);
                record(DomainPartKind::Node, path.offsets[k]);
            }
        }
        const auto count = static_cast<std::uint32_t>(domain_.nodes.size()) - first;
        const std::int32_t tag = tags_.of(path.name);
        if (count == 1) {
            domain_.points.push_back({first, tag});
            record(DomainPartKind::ConstraintPoint, path.offsets.front());
            return;
        }
        const bool loop = count > 2;
        for (std::uint32_t k = 0; k < (loop ? count : 1); ++k) {
            domain_.segments.push_back(
                {first + k, first + (k + 1) % count, tag, loop ? SegmentRole::Boundary : SegmentRole::Constraint, {}});
            record(DomainPartKind::Segment, path.offsets[std::min<std::size_t>(k, path.offsets.size() - 1)]);
        }
    }

    void record(DomainPartKind kind, std::size_t offset) {
        if (source_.origin != nullptr) {
            source_.origin->of(kind).push_back({offset, {}});
        }
    }

    const SourceText &source_;
    TextScanner faults_;
    char separator_ = '\0';
    std::size_t x_ = 0, y_ = 1; ///< columns
    std::optional<std::size_t> name_;
    bool broken_ = false; ///< by an empty line
    std::vector<PointPath> paths_;
    TagAllocator tags_;
    DomainFile file_;
    Domain &domain_ = file_.domain;
};

} // namespace

Result<DomainFile> readCsv(const SourceText &source) {
    return CsvReader(source).read();
}

} // namespace forefront
