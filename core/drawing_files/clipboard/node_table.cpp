#include "core/drawing_files/clipboard/node_table.hpp"

#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/clipboard/table_cells.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

namespace forefront {

namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// Where a table has its columns; kNone: it does not have it.
struct TableColumns {
    std::size_t shape = kNone, node = kNone, x = kNone, y = kNone;
};

/// A line of a table, read.
struct TableRow {
    std::size_t line = 0;
    NodeRef node; ///< without a shape if the table does not name it
    Vec2 at;
};

struct ReadTable {
    std::vector<TableRow> rows;
    bool addressed = false; ///< the rows name their nodes
};

bool isBlankLine(std::string_view line) {
    return line.find_first_not_of(" \t\r;,") == std::string_view::npos;
}

/// Returns the character that separates the columns of a table, by its first line.
char separatorOf(std::string_view line) {
    for (const char separator : {'\t', ';'}) {
        if (line.find(separator) != std::string_view::npos) {
            return separator;
        }
    }
    const std::vector<std::string_view> words = cellsOf(line, ' ');
    const bool decimal = words.size() > 1 && std::all_of(words.begin(), words.end(), [](std::string_view word) {
                             return numberInCell(word) && word.back() != ',' && word.front() != ',';
                         });
    return decimal || line.find(',') == std::string_view::npos ? ' ' : ',';
}

std::string lowered(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return lower;
}

/// Reads the lines of a table; `result` receives their faults.
class TableReader {
  public:
    TableReader(std::span<const std::string> lines, NodeTableResult &result) : lines_(lines), result_(result) {}

    ReadTable read() {
        ReadTable table;
        std::size_t line = nextLine(0);
        if (line == lines_.size()) {
            result_.fault = "the table is empty; expected lines with two numbers, x and y";
            return table;
        }
        separator_ = separatorOf(lines_[line]);
        if (!findColumns(line)) {
            return table;
        }
        table.addressed = columns_.shape != kNone;
        for (line = nextLine(heading_ ? line + 1 : line); line < lines_.size(); line = nextLine(line + 1)) {
            if (const std::optional<TableRow> row = readRow(line)) {
                table.rows.push_back(*row);
            }
        }
        if (table.rows.empty() && result_.faults.empty()) {
            result_.fault = "the table has a heading but no lines with numbers";
        }
        if (either_ && !decimalComma_ && result_.faults.empty()) {
            const std::string number = numberText(*numberInCell(either_->cell), 15);
            result_.fault = "'" + either_->cell + "' in line " + std::to_string(either_->line + 1) + " may be " +
                            number + " or " + withoutComma(either_->cell) +
                            "; write decimal points, or another number of decimals, and no thousands separators";
        }
        return table;
    }

  private:
    std::size_t nextLine(std::size_t line) const {
        while (line < lines_.size() && isBlankLine(lines_[line])) {
            ++line;
        }
        return line;
    }

    /// Finds the columns by the first line. Returns false if that is impossible.
    bool findColumns(std::size_t line) {
        const std::vector<std::string_view> cells = cellsOf(lines_[line], separator_);
        heading_ = std::none_of(cells.begin(), cells.end(), [](std::string_view c) { return !!numberInCell(c); });
        count_ = cells.size();
        if (heading_) {
            return findNamed(cells);
        }
        if (count_ == 4 && separator_ == ',') {
            result_.fault = "four numbers separated by commas may be two with decimal commas; separate the columns by "
                            "tabs or semicolons, or give them a heading such as shape,node,x,y";
            return false;
        }
        if (count_ == 4) {
            columns_ = {0, 1, 2, 3};
        } else {
            columns_ = {kNone, kNone, 0, 1};
            count_ = 2; // a line with another number of columns is at fault by itself
        }
        return true;
    }

    bool findNamed(const std::vector<std::string_view> &cells) {
        for (const auto &[name, column] : {std::pair("shape", &columns_.shape), std::pair("node", &columns_.node),
                                           std::pair("x", &columns_.x), std::pair("y", &columns_.y)}) {
            for (std::size_t k = 0; k < cells.size() && *column == kNone; ++k) {
                *column = lowered(cells[k]) == name ? k : kNone;
            }
        }
        const bool places = columns_.x != kNone && columns_.y != kNone;
        if (!places) {
            result_.fault = "the heading '" + lines_[nextLine(0)] +
                            "' has no columns x and y; name the columns x and y, or leave out the heading";
        } else if ((columns_.shape == kNone) != (columns_.node == kNone)) {
            result_.fault = std::string("the table has a column ") + (columns_.node == kNone ? "shape" : "node") +
                            " but none " + (columns_.node == kNone ? "node" : "shape") +
                            "; give it both, or neither for the nodes of one shape in order";
        }
        return result_.fault.empty();
    }

    std::optional<TableRow> readRow(std::size_t line) {
        // A line that was corrected by hand may have other separators: fields take no tabs.
        const bool usual = separator_ == ' ' || lines_[line].find(separator_) != std::string::npos;
        const std::vector<std::string_view> cells =
            cellsOf(lines_[line], usual ? separator_ : separatorOf(lines_[line]));
        const auto fail = [&](std::string reason) {
            result_.faults.push_back({line, std::move(reason)});
            return std::nullopt;
        };
        const bool complete = heading_ ? cells.size() > lastColumn() : cells.size() == count_;
        if (!complete) {
            return fail("expected " + std::to_string(count_) + " columns, got " + std::to_string(cells.size()));
        }
        TableRow row{line, {}, {}};
        for (const auto &[column, value] : {std::pair(columns_.x, &row.at.x), std::pair(columns_.y, &row.at.y)}) {
            const std::optional<double> number = numberInCell(cells[column]);
            if (!number) {
                return fail("expected a number, got '" + std::string(cells[column]) + "'");
            }
            *value = *number;
            noteComma(cells[column], line);
        }
        for (const auto &[column, value] :
             {std::pair(columns_.shape, &row.node.shape), std::pair(columns_.node, &row.node.node)}) {
            const std::optional<double> number = column == kNone ? std::optional(1.0) : numberInCell(cells[column]);
            if (!number || !(*number >= 1.0 && *number <= 4e9) || *number != std::floor(*number)) {
                return fail("expected the number of a " + std::string(value == &row.node.node ? "node" : "shape") +
                            ", got '" + std::string(cells[column]) + "'");
            }
            *value = static_cast<std::uint32_t>(*number);
        }
        --row.node.node;
        return row;
    }

    /// Remembers whether commas are decimal signs: "1,234" alone may be 1234, too.
    void noteComma(std::string_view cell, std::size_t line) {
        const CommaUse use = commaUse(cell);
        decimalComma_ = decimalComma_ || use == CommaUse::Decimal;
        if (use == CommaUse::Either && !either_) {
            either_ = {std::string(cell), line};
        }
    }

    static std::string withoutComma(std::string text) {
        std::erase(text, ',');
        return text;
    }

    std::size_t lastColumn() const {
        std::size_t last = std::max(columns_.x, columns_.y);
        for (const std::size_t column : {columns_.shape, columns_.node}) {
            last = column == kNone ? last : std::max(last, column);
        }
        return last;
    }

    std::span<const std::string> lines_;
    NodeTableResult &result_;
    char separator_ = '\t';
    bool heading_ = false;
    std::size_t count_ = 0; ///< columns of the first line
    TableColumns columns_;
    bool decimalComma_ = false; ///< a number has one
    struct Cell {
        std::string cell;
        std::size_t line = 0;
    };
    std::optional<Cell> either_; ///< the first number whose comma may be a decimal sign or separate thousands
};

/// Returns true for a path whose nodes are all that is in it: more or fewer of them can take their place.
bool isPlainPath(const Shape &shape) {
    return isPath(shape) && shape.segmentTags.empty() && shape.nodeSizes.empty() && shape.segmentSizes.empty() &&
           std::all_of(shape.path().curves.begin(), shape.path().curves.end(),
                       [](const Curve &curve) { return curve.kind() == CurveKind::Line; });
}

/// Moves handles of one shape. Faults name the line of the handle that cannot be where the table has it.
class ShapePlacer {
  public:
    ShapePlacer(const Shape &shape, NodeTableResult &result) : before_(shape), shape_(shape), result_(result) {}

    /// Returns the shape with the handles of `rows`, sorted by node, at their places; none if nothing moves or
    /// something is at fault.
    std::optional<Shape> place(std::span<const TableRow> rows) {
        const std::vector<Vec2> handles = handlesOf(before_);
        const auto moves = [&](const TableRow &row) { return row.at != handles[row.node.node]; };
        const auto first = std::find_if(rows.begin(), rows.end(), moves);
        if (first == rows.end()) {
            return std::nullopt;
        }
        if (before_.locked) {
            fail(*first, displayName(before_) + " is locked; unlock it to move its nodes");
            return std::nullopt;
        }
        if (isPath(shape_)) {
            std::vector<Vec2> places = shape_.nodes;
            for (const TableRow &row : rows) {
                places[row.node.node] = row.at;
            }
            moveNodes(shape_, std::move(places));
        } else {
            // A handle takes others along: those of rows that stay, too.
            for (const TableRow &row : rows) {
                placeHandle(shape_, row.node.node, row.at);
            }
        }
        result_.moved += static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), moves));
        return accept(*first, rows) ? std::optional(shape_) : std::nullopt;
    }

  private:
    void fail(const TableRow &row, std::string reason) { result_.faults.push_back({row.line, std::move(reason)}); }

    bool accept(const TableRow &firstMoved, std::span<const TableRow> rows) {
        if (const Diagnostics faults = checkShape(shape_); !faults.empty()) {
            fail(firstMoved, faults.front().message);
            return false;
        }
        constexpr double kRounding = 1e-9; // of the extent: handles of slots and ellipses are computed
        const std::vector<Vec2> handles = handlesOf(shape_);
        const double extent = length(boundsOf(shape_).size());
        bool good = true;
        for (const TableRow &row : rows) {
            const Vec2 at = handles[row.node.node];
            constexpr double kLastPlaces = 8.0 * std::numeric_limits<double>::epsilon(); // far from the origin
            if (!(distance(at, row.at) <= kRounding * extent + kLastPlaces * length(at))) {
                fail(row, "node " + std::to_string(row.node.node + 1) + " of " + displayName(shape_) + " would be at " +
                              placeText(at) + ", as its other nodes say; convert the shape to a path to move it alone");
                good = false;
            }
        }
        return good;
    }

    const Shape &before_;
    Shape shape_;
    NodeTableResult &result_;
};

/// Gives the nodes of the only shape to the rows of a table of two columns. Returns the shape with another number of
/// nodes if the table has one.
std::optional<Shape> addressRows(const Document &document, const std::set<std::uint32_t> &shapes,
                                 std::vector<TableRow> &rows, NodeTableResult &result) {
    const Shape *const shape = shapes.size() == 1 ? findShape(document, *shapes.begin()) : nullptr;
    if (shape == nullptr) {
        result.fault = "two columns are the nodes of one shape; select that shape, or add the columns shape and node";
        return std::nullopt;
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].node = {shape->id, static_cast<std::uint32_t>(k)};
    }
    const std::size_t count = handleCount(*shape);
    if (rows.size() == count) {
        return std::nullopt;
    }
    if (!isPlainPath(*shape) || shape->locked) {
        result.fault = "the table has " + countText(rows.size(), "line") + ", but " + displayName(*shape) + " has " +
                       countText(count, "node") + "; give it one line for each node";
        return std::nullopt;
    }
    Shape next = *shape;
    next.nodes.clear();
    std::transform(rows.begin(), rows.end(), std::back_inserter(next.nodes), [](const TableRow &r) { return r.at; });
    next.path().curves.clear();
    next.cuts.clear();
    if (const Diagnostics faults = checkShape(next); !faults.empty()) {
        result.fault = faults.front().message;
        return std::nullopt;
    }
    result.moved = rows.size();
    return next;
}

/// Reports rows whose node does not exist or is in an earlier row.
void checkAddresses(const Document &document, const std::vector<TableRow> &rows, NodeTableResult &result) {
    std::map<NodeRef, std::size_t> lines;
    for (const TableRow &row : rows) {
        const Shape *const shape = findShape(document, row.node.shape);
        const std::string node = std::to_string(row.node.node + 1);
        const auto [earlier, fresh] = lines.emplace(row.node, row.line);
        if (shape == nullptr) {
            result.faults.push_back({row.line, "shape " + std::to_string(row.node.shape) + " not found"});
        } else if (row.node.node >= handleCount(*shape)) {
            result.faults.push_back({row.line, "node " + node + " not found; " + displayName(*shape) + " has " +
                                                   countText(handleCount(*shape), "node")});
        } else if (!fresh) {
            result.faults.push_back({row.line, "node " + node + " of " + displayName(*shape) + " is also in line " +
                                                   std::to_string(earlier->second + 1)});
        }
    }
}

/// Moves the nodes of rows that name them.
void placeRows(const Document &document, std::vector<TableRow> rows, NodeTableResult &result) {
    std::sort(rows.begin(), rows.end(), [](const TableRow &a, const TableRow &b) { return a.node < b.node; });
    std::vector<Shape> changed;
    for (auto begin = rows.begin(); begin != rows.end();) {
        const auto end =
            std::find_if(begin, rows.end(), [&](const TableRow &row) { return row.node.shape != begin->node.shape; });
        if (std::optional<Shape> shape =
                ShapePlacer(*findShape(document, begin->node.shape), result).place({begin, end})) {
            changed.push_back(*std::move(shape));
        }
        begin = end;
    }
    if (!result.faults.empty()) {
        return;
    }
    Result<Document> next = replaceShapes(document, std::move(changed));
    if (next) {
        result.next = *std::move(next);
    } else {
        result.fault = next.faults().front().message;
    }
}

} // namespace

std::vector<NodeRow> nodeRows(const Document &document, const std::set<std::uint32_t> &shapes) {
    std::vector<NodeRow> rows;
    for (const auto &shape : document.shapes) {
        if (shapes.contains(shape->id)) {
            std::uint32_t number = 0;
            for (const Vec2 at : handlesOf(*shape)) {
                rows.push_back({{shape->id, number++}, at + Vec2{}}); // no negative zero
            }
        }
    }
    return rows;
}

std::string nodeTableText(std::span<const NodeRow> rows) {
    std::string text = "shape\tnode\tx\ty\n";
    for (const NodeRow &row : rows) {
        text += std::to_string(row.node.shape) + '\t' + std::to_string(row.node.node + 1) + '\t' + exactText(row.at.x) +
                '\t' + exactText(row.at.y) + '\n';
    }
    return text;
}

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const bool returns = end > begin && text[end - 1] == '\r';
        lines.emplace_back(text.substr(begin, end - begin - (returns ? 1 : 0)));
        begin = end + 1;
    }
    return lines;
}

NodeTableResult placeNodes(const Document &document, const std::set<std::uint32_t> &shapes,
                           std::span<const std::string> lines) {
    NodeTableResult result;
    ReadTable table = TableReader(lines, result).read();
    if (!result.fault.empty() || (!result.faults.empty() && !table.addressed)) {
        return result; // rows without addresses stand for nodes by their number, which faults would change
    }
    if (!table.addressed) {
        std::optional<Shape> other = addressRows(document, shapes, table.rows, result);
        if (other) {
            Result<Document> next = replaceShape(document, *std::move(other));
            result.next = next ? std::optional(*std::move(next)) : std::nullopt;
            result.fault = next ? std::string() : next.faults().front().message;
            return result;
        }
        if (!result.fault.empty()) {
            return result;
        }
    }
    checkAddresses(document, table.rows, result);
    if (result.faults.empty()) {
        placeRows(document, std::move(table.rows), result);
    }
    std::stable_sort(result.faults.begin(), result.faults.end(),
                     [](const TableFault &a, const TableFault &b) { return a.line < b.line; });
    return result;
}

} // namespace forefront
