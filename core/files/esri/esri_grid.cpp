#include "core/files/esri/esri_grid.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/files/common/cell_grid.hpp"
#include "core/files/text/text_scanner.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
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

bool isNan(std::string_view word) {
    const std::optional<double> value = parseReal(word);
    return value && std::isnan(*value);
}

class EsriReader {
  public:
    explicit EsriReader(const SourceText &source) : source_(source), scanner_(source) {}

    Result<SpacingSpec> read() {
        noteProjection();
        if (!header() || !layOut(kMaxGridValues) || !values()) {
            return scanner_.faults();
        }
        return spacingOfGrid(grid_, source_);
    }

    Result<Raster> readRaster() {
        Raster raster;
        noteProjection();
        if (!header() || !layOut(std::numeric_limits<std::size_t>::max())) {
            return scanner_.faults();
        }
        raster.columns = columns_;
        raster.rows = rows_;
        raster.pitch = grid_.step;
        raster.origin = grid_.low + 0.5 * grid_.step;
        bool any = false;
        const auto take = [&](std::size_t k, std::optional<double> value, std::size_t) {
            if (k == 0) {
                raster.values.resize(columns_ * rows_);
            }
            any = any || value.has_value();
            raster.values[(rows_ - 1 - k / columns_) * columns_ + k % columns_] =
                value.value_or(std::numeric_limits<double>::quiet_NaN());
            return true;
        };
        if (!eachValue(take)) {
            return scanner_.faults();
        }
        if (!any) {
            scanner_.fail(0, "no-values", "the grid has no values");
            return scanner_.faults();
        }
        return raster;
    }

  private:
    void noteProjection() const {
        if (!source_.options.projection.empty()) {
            source_.note(
                "no-crs",
                "the grid names no coordinate reference system; it is taken to be in " + source_.options.projection, 0);
        }
    }

    bool header() {
        while (const auto key = keyOf(scanner_.peek())) {
            const std::size_t place = scanner_.offset();
            scanner_.word();
            if (header_[*key]) {
                return scanner_.fail(place, "duplicate-field", std::string("duplicate ") + kKeys[*key]);
            }
            double value = 0.0;
            if (*key == NoData && isNan(scanner_.peek())) { // as GDAL writes
                scanner_.word();
                value = std::numeric_limits<double>::quiet_NaN();
            } else if (!scanner_.real(value, {kKeys[*key]})) {
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

    /// Places the cells, averaged to at most `most`.
    bool layOut(std::size_t most) {
        if (!count(Columns, columns_) || !count(Rows, rows_) ||
            !axis(CornerX, CentreX, StepX, grid_.low.x, grid_.step.x) ||
            !axis(CornerY, CentreY, StepY, grid_.low.y, grid_.step.y)) {
            return false;
        }
        const GridCounts counts = averagedCounts(columns_, rows_, most);
        grid_.columns = counts.columns;
        grid_.rows = counts.rows;
        grid_.step.x *= static_cast<double>(columns_) / static_cast<double>(grid_.columns);
        grid_.step.y *= static_cast<double>(rows_) / static_cast<double>(grid_.rows);
        return true;
    }

    /// Reads the values from the top row on. `take`: gets the index of a value, the value, none where it is missing,
    /// and its offset; returns false after a failure.
    template <class Take>
    bool eachValue(Take take) {
        constexpr std::size_t kBytes = 2; // length of the shortest value and the blank after it
        const std::size_t total = columns_ * rows_;
        if (total > scanner_.remaining() / kBytes + 1) {
            return scanner_.fail(scanner_.offset(), "bad-count",
                                 "the file ends before the last of its " + std::to_string(total) + " values");
        }
        for (std::size_t k = 0; k < total; ++k) {
            double value = 0.0;
            scanner_.peek(); // skips the blanks, so that the place is that of the number
            const std::size_t place = scanner_.offset();
            bool missing = header_[NoData] && std::isnan(*header_[NoData]) && isNan(scanner_.peek());
            if (missing) {
                scanner_.word();
            } else if (!scanner_.real(value, {"value", k + 1})) {
                return false;
            }
            missing = missing || (header_[NoData] && value == *header_[NoData]);
            if (!take(k, missing ? std::nullopt : std::optional(value), place)) {
                return false;
            }
        }
        if (!scanner_.atEnd()) {
            return scanner_.fail(scanner_.offset(), "bad-count",
                                 "expected the end of the file after " + std::to_string(total) + " values");
        }
        return true;
    }

    bool values() {
        CellMeans means(columns_, rows_, grid_);
        const auto take = [&](std::size_t k, std::optional<double> value, std::size_t place) {
            if (value && !(*value > 0.0)) {
                return scanner_.fail(place, "bad-values", "expected a size above 0, got " + numberText(*value, 6),
                                     "set NODATA_value to mark cells without a size");
            }
            means.add(k, value);
            return true;
        };
        if (!eachValue(take)) {
            return false;
        }
        means.finish();
        noteAveraged(grid_, columns_, rows_, source_);
        return true;
    }

    const SourceText &source_;
    TextScanner scanner_;
    std::array<std::optional<double>, kKeys.size()> header_;
    std::size_t columns_ = 0, rows_ = 0; ///< of the file
    CellGrid grid_;
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

Result<Raster> readEsriRaster(const SourceText &source) {
    return EsriReader(source).readRaster();
}

Result<SpacingSpec> readEsriGrid(const SourceText &source) {
    return EsriReader(source).read();
}

} // namespace forefront
