#include "core/io/esri/esri_grid.hpp"

#include "core/base/number_text.hpp"
#include "core/io/text/text_scanner.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {
namespace {

enum Key : std::uint8_t { Columns, Rows, CornerX, CornerY, CentreX, CentreY, CellSize, StepX, StepY, NoData };
constexpr std::array<const char *, 10> kKeys{"ncols",     "nrows",    "xllcorner", "yllcorner", "xllcenter",
                                             "yllcenter", "cellsize", "dx",        "dy",        "nodata_value"};

/// Returns the index of a key of the header, in upper or lower case.
std::optional<std::size_t> keyOf(std::string_view word) {
    const auto equal = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
    for (std::size_t k = 0; k < kKeys.size(); ++k) {
        const std::string_view key = kKeys[k];
        if (std::equal(word.begin(), word.end(), key.begin(), key.end(), equal)) {
            return k;
        }
    }
    return std::nullopt;
}

class EsriReader {
  public:
    explicit EsriReader(const SourceText &source) : source_(source), scanner_(source) {}

    Result<SpacingSpec> read() {
        if (!header() || !layOut() || !values()) {
            return scanner_.faults();
        }
        addNodes();
        addTriangles();
        if (mesh_->elements.empty()) {
            scanner_.fail(0, "no-values", "no three neighbouring cells have a size; expected at least three");
            return scanner_.faults();
        }
        noteIsolated();
        SpacingSpec spec;
        spec.background = std::move(mesh_);
        return spec;
    }

  private:
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    bool header() {
        while (const auto key = keyOf(scanner_.peek())) {
            const std::size_t place = scanner_.offset();
            scanner_.word();
            if (header_[*key]) {
                return scanner_.fail(place, "duplicate-field", std::string("duplicate ") + kKeys[*key]);
            }
            double value = 0.0;
            if (!scanner_.real(value, {kKeys[*key]})) {
                return false;
            }
            header_[*key] = value;
        }
        return true;
    }

    /// Returns the number of rows or columns; fails if it is missing or no positive integer.
    bool count(Key key, std::size_t &result) {
        const double value = header_[key].value_or(0.0);
        if (!header_[key]) {
            return scanner_.fail(0, "missing-field", std::string("the grid has no ") + kKeys[key]);
        }
        if (!(value >= 1.0 && value <= 1e9) || value != std::floor(value)) {
            return scanner_.fail(0, "bad-count",
                                 "expected a whole number above 0 for " + std::string(kKeys[key]) + ", got " +
                                     numberText(value, 6));
        }
        result = static_cast<std::size_t>(value);
        return true;
    }

    /// Computes the lower left corner and the step along one axis.
    bool axis(Key corner, Key centre, Key step, double &low, double &size) {
        const std::optional<double> given = header_[step] ? header_[step] : header_[CellSize];
        if (!given) {
            return scanner_.fail(0, "missing-field", "the grid has no cellsize");
        }
        if (!(*given > 0.0)) {
            return scanner_.fail(0, "bad-number", "expected a cellsize above 0, got " + numberText(*given, 6));
        }
        if (!header_[corner] && !header_[centre]) {
            return scanner_.fail(0, "missing-field", std::string("the grid has no ") + kKeys[corner]);
        }
        size = *given;
        low = header_[corner] ? *header_[corner] : *header_[centre] - 0.5 * size;
        return true;
    }

    bool layOut() {
        if (!count(Columns, columns_) || !count(Rows, rows_) || !axis(CornerX, CentreX, StepX, low_.x, step_.x) ||
            !axis(CornerY, CentreY, StepY, low_.y, step_.y)) {
            return false;
        }
        if (columns_ > kMaxGridValues / rows_) {
            return scanner_.fail(0, "too-large",
                                 "the grid has " + std::to_string(columns_) + " x " + std::to_string(rows_) +
                                     " values; expected at most " + std::to_string(kMaxGridValues),
                                 "make its cells larger");
        }
        return true;
    }

    bool values() {
        constexpr std::size_t kBytes = 2; // length of the shortest value and the blank after it
        if (columns_ * rows_ > scanner_.remaining() / kBytes + 1) {
            return scanner_.fail(scanner_.offset(), "bad-count",
                                 "the file ends before the last of its " + std::to_string(columns_ * rows_) +
                                     " values");
        }
        values_.reserve(columns_ * rows_);
        while (values_.size() < columns_ * rows_) {
            double value = 0.0;
            scanner_.peek(); // skips the blanks, so that the place is that of the number
            const std::size_t place = scanner_.offset();
            if (!scanner_.real(value, {"value", values_.size() + 1})) {
                return false;
            }
            const bool missing = header_[NoData] && value == *header_[NoData];
            if (!missing && !(value > 0.0)) {
                return scanner_.fail(place, "bad-values", "expected a size above 0, got " + numberText(value, 6),
                                     "set NODATA_value to mark cells without a size");
            }
            values_.push_back(missing ? 0.0 : value);
        }
        if (!scanner_.atEnd()) {
            return scanner_.fail(scanner_.offset(), "bad-count",
                                 "expected the end of the file after " + std::to_string(values_.size()) + " values");
        }
        return true;
    }

    /// Returns the index of the cell whose value holds at node line i of n + 2: those at the ends repeat the outer
    /// cells.
    static std::size_t cellOf(std::size_t i, std::size_t n) { return std::clamp<std::size_t>(i, 1, n) - 1; }
    static double placeOf(std::size_t i, std::size_t n, double low, double step) {
        const double cells = i == 0 ? 0.0 : i == n + 1 ? static_cast<double>(n) : static_cast<double>(i) - 0.5;
        return low + cells * step;
    }

    /// Adds a node for each centre of a cell, and for each edge of the grid beside one, that has a value.
    void addNodes() {
        nodes_.assign((columns_ + 2) * (rows_ + 2), kNone);
        for (std::size_t j = 0; j < rows_ + 2; ++j) {
            for (std::size_t i = 0; i < columns_ + 2; ++i) {
                const std::size_t row = rows_ - 1 - cellOf(j, rows_); // the first row is the highest
                const double value = values_[row * columns_ + cellOf(i, columns_)];
                if (value > 0.0) {
                    nodes_[j * (columns_ + 2) + i] = static_cast<std::uint32_t>(mesh_->nodes.size());
                    mesh_->nodes.push_back({placeOf(i, columns_, low_.x, step_.x), placeOf(j, rows_, low_.y, step_.y)});
                    mesh_->values.push_back(value);
                }
            }
        }
    }

    /// Divides each rectangle of four nodes into two triangles; one with three nodes is a single triangle.
    void addTriangles() {
        for (std::size_t j = 0; j + 1 < rows_ + 2; ++j) {
            for (std::size_t i = 0; i + 1 < columns_ + 2; ++i) {
                const std::size_t at = j * (columns_ + 2) + i, above = at + columns_ + 2;
                const std::array<std::uint32_t, 4> corners{nodes_[at], nodes_[at + 1], nodes_[above + 1],
                                                           nodes_[above]};
                std::vector<std::uint32_t> known;
                std::copy_if(corners.begin(), corners.end(), std::back_inserter(known),
                             [](std::uint32_t node) { return node != kNone; });
                for (std::size_t k = 2; k < known.size(); ++k) {
                    mesh_->elements.push_back({known[0], known[k - 1], known[k]});
                }
            }
        }
    }

    /// Reports cells with a size that no triangle uses, such as a strip one cell wide between cells without one.
    void noteIsolated() {
        std::vector<std::uint8_t> used(mesh_->nodes.size(), 0);
        for (const auto &element : mesh_->elements) {
            for (const std::uint32_t node : element) {
                used[node] = 1;
            }
        }
        std::size_t isolated = 0;
        for (std::size_t j = 1; j <= rows_; ++j) {
            for (std::size_t i = 1; i <= columns_; ++i) {
                const std::uint32_t node = nodes_[j * (columns_ + 2) + i];
                isolated += node != kNone && used[node] == 0 ? 1 : 0;
            }
        }
        if (isolated > 0) {
            source_.note("isolated-sizes",
                         std::to_string(isolated) + (isolated == 1 ? " cell has a size" : " cells have sizes") +
                             " not used: expected at least two neighbours with sizes, not all in one line",
                         0);
        }
    }

    const SourceText &source_;
    TextScanner scanner_;
    std::array<std::optional<double>, kKeys.size()> header_;
    std::size_t columns_ = 0, rows_ = 0;
    Vec2 low_, step_;
    std::vector<double> values_;       ///< row by row from the top; 0: none
    std::vector<std::uint32_t> nodes_; ///< index of each node, row by row from the bottom; kNone: none
    std::shared_ptr<BackgroundMesh> mesh_ = std::make_shared<BackgroundMesh>();
};

} // namespace

bool looksLikeEsriGrid(std::string_view head) {
    const std::size_t begin = head.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) {
        return false;
    }
    const std::size_t end = head.find_first_of(" \t\r\n", begin);
    const auto key = keyOf(head.substr(begin, end == std::string_view::npos ? end : end - begin));
    return key == Columns || key == Rows;
}

Result<SpacingSpec> readEsriGrid(const SourceText &source) {
    return EsriReader(source).read();
}

} // namespace forefront
