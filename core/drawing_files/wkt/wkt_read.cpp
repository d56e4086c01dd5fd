#include "core/drawing_files/common/drawing_builder.hpp"
#include "core/drawing_files/wkt/wkt.hpp"
#include "core/engine/base/letter_case.hpp"
#include "core/files/text/text_scanner.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr int kMaxCollections = 64; ///< one in the other
constexpr std::string_view kWktBlanks = " \t\r\n";

/// A line or ring: its places and where they stand in the text.
struct WktPath {
    std::vector<Vec2> places;
    std::vector<std::size_t> offsets;
};

class WktReader {
  public:
    explicit WktReader(const SourceText &source)
        : source_(source), text_(source.text), faults_(source), builder_(source) {}

    Result<Domain> read() {
        skip();
        while (ok() && at_ < text_.size()) {
            tagged();
            skip();
            while (at_ < text_.size() && (text_[at_] == ';' || text_[at_] == ',')) {
                ++at_;
                skip();
            }
        }
        if (ok() && polygons_.empty() && lines_.empty()) {
            faults_.fail(0, "empty-domain", "the file holds no polygon and no line that could bound a domain");
        }
        if (!ok()) {
            return faults_.faults();
        }
        build();
        return builder_.finish();
    }

  private:
    bool ok() const { return faults_.ok(); }
    void fail(const char *code, const std::string &message, const std::string &advice = {}) {
        faults_.fail(at_, code, message, advice);
    }

    void skip() { at_ = std::min(text_.find_first_not_of(kWktBlanks, at_), text_.size()); }

    std::string word() {
        skip();
        const std::size_t begin = at_;
        while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) {
            ++at_;
        }
        return upperCase(text_.substr(begin, at_ - begin));
    }

    bool take(char c) {
        skip();
        const bool found = at_ < text_.size() && text_[at_] == c;
        at_ += found ? 1 : 0;
        return found;
    }

    void expect(char c) {
        if (ok() && !take(c)) {
            fail("bad-syntax", std::string("expected '") + c + "', found " + found());
        }
    }

    std::string found() const {
        const std::size_t end = std::min(text_.find_first_of(" \t\r\n(),;", at_ + 1), text_.size());
        return at_ < text_.size() ? inQuotes(text_.substr(at_, end - at_)) : std::string("the end of the file");
    }

    /// Reads "SRID=number;", then a geometry.
    void tagged() {
        const std::size_t begin = at_;
        if (word() != "SRID") {
            at_ = begin;
            geometry(0);
            return;
        }
        expect('=');
        double number = 0.0;
        coordinate(number);
        expect(';');
        if (number == 4326.0 || number == 4258.0) {
            const std::string message = "the coordinates are longitudes and latitudes in degrees";
            const std::string advice = "project them, for example to UTM, before meshing";
            if (source_.options.strict) {
                faults_.fail(begin, kDegreesWarning, message, advice);
            } else {
                source_.warn(kDegreesWarning, message + "; " + advice, begin);
            }
        }
        geometry(0);
    }

    void geometry(int depth) {
        skip();
        const std::size_t begin = at_;
        const std::string kind = word();
        if (kind.empty()) {
            fail("bad-syntax", "expected a geometry such as POLYGON, found " + found());
            return;
        }
        static constexpr std::string_view kKinds[] = {"POINT",        "LINESTRING", "LINEARRING",
                                                      "POLYGON",      "MULTIPOINT", "MULTILINESTRING",
                                                      "MULTIPOLYGON", "TRIANGLE",   "GEOMETRYCOLLECTION"};
        // Z, M and ZM may follow without a blank.
        std::string name = kind;
        for (const char *suffix : {"ZM", "Z", "M"}) {
            const bool known = std::find(std::begin(kKinds), std::end(kKinds), name) != std::end(kKinds);
            if (!known && name.ends_with(suffix)) {
                name.resize(name.size() - std::string_view(suffix).size());
            }
        }
        if (std::find(std::begin(kKinds), std::end(kKinds), name) == std::end(kKinds)) {
            at_ = begin;
            fail("unknown-geometry", "a geometry of type " + inQuotes(kind) + " cannot be read",
                 "convert it to polygons and lines, for example with ST_CurveToLine of PostGIS");
            return;
        }
        for (const char *dimension : {"ZM", "Z", "M"}) {
            if (takeWord(dimension)) {
                break;
            }
        }
        if (!takeWord("EMPTY")) {
            content(name, depth);
        }
    }

    /// Skips a word if it is this one.
    bool takeWord(std::string_view wanted) {
        const std::size_t begin = at_;
        const bool found = word() == wanted;
        at_ = found ? at_ : begin;
        return found;
    }

    void content(const std::string &name, int depth) {
        if (name == "POINT") {
            const WktPath path = list();
            points_.emplace_back(path.places.front(), path.offsets.front());
        } else if (name == "LINESTRING" || name == "LINEARRING") {
            addLine(list());
        } else if (name == "POLYGON" || name == "TRIANGLE") {
            polygon();
        } else if (name == "GEOMETRYCOLLECTION" && depth >= kMaxCollections) {
            fail("bad-syntax", "too many collections lie in each other");
        } else {
            expect('(');
            do {
                skip();
                if (name == "GEOMETRYCOLLECTION") {
                    geometry(depth + 1);
                } else if (takeWord("EMPTY")) {
                    continue;
                } else if (name == "MULTIPOLYGON") {
                    polygon();
                } else if (name == "MULTILINESTRING") {
                    addLine(list());
                } else { // points may have brackets of their own
                    const bool bracket = take('(');
                    const std::size_t place = at_;
                    points_.emplace_back(position(), place);
                    if (bracket) {
                        expect(')');
                    }
                }
            } while (ok() && take(','));
            expect(')');
        }
    }

    void addLine(WktPath path) {
        if (ok() && path.places.size() < 2) {
            fail("bad-count", "a line needs at least 2 positions");
        }
        lines_.push_back(std::move(path));
    }

    void polygon() {
        expect('(');
        std::vector<WktPath> rings;
        do {
            WktPath ring = list();
            while (ring.places.size() > 1 && ring.places.front() == ring.places.back()) {
                ring.places.pop_back();
                ring.offsets.pop_back();
            }
            if (ok() && ring.places.size() < 3) {
                fail("bad-count", "a ring of a polygon needs at least 3 different positions");
            }
            rings.push_back(std::move(ring));
        } while (ok() && take(','));
        expect(')');
        polygons_.push_back(std::move(rings));
    }

    WktPath list() {
        WktPath path;
        expect('(');
        do {
            skip();
            path.offsets.push_back(at_);
            path.places.push_back(position());
        } while (ok() && faults_.proceed(at_) && take(','));
        expect(')');
        return path;
    }

    Vec2 position() {
        Vec2 place;
        double ignored = 0.0;
        coordinate(place.x);
        coordinate(place.y);
        for (int k = 0; k < 2 && ok(); ++k) { // z and m
            skip();
            if (at_ < text_.size() && text_[at_] != ',' && text_[at_] != ')') {
                if (k == 0) {
                    source_.note("wkt-heights", "third coordinates are ignored", at_);
                }
                coordinate(ignored);
            }
        }
        return place;
    }

    void coordinate(double &value) {
        if (!ok()) {
            return;
        }
        skip();
        const std::size_t end = std::min(text_.find_first_of(" \t\r\n(),;", at_), text_.size());
        const auto number = parseReal(text_.substr(at_, end - at_));
        if (!number || !std::isfinite(*number)) {
            fail("bad-number", "expected a coordinate, found " + found());
            return;
        }
        value = *number;
        at_ = end;
    }

    void build() {
        for (std::size_t k = 0; k < polygons_.size(); ++k) {
            const bool many = polygons_.size() > 1;
            const std::uint32_t shape =
                builder_.addShape(builder_.addFeature(many ? static_cast<std::int32_t>(k + 1) : 1));
            for (std::size_t r = 0; r < polygons_[k].size(); ++r) {
                builder_.from(polygons_[k][r].offsets);
                builder_.addRing(builder_.addContour(shape, FillRule::NonZero, r > 0), polygons_[k][r].places, 1);
            }
        }
        if (polygons_.size() > 1) {
            builder_.markRegions();
        }
        DrawingContents contents;
        contents.lines = !polygons_.empty() && !lines_.empty();
        source_.reportContents(contents);
        for (const WktPath &line : lines_) {
            if (contents.lines && source_.options.dropLines) {
                source_.note("dropped-lines", "lines are left out", line.offsets.front());
                continue;
            }
            builder_.from(line.offsets);
            builder_.addChain(line.places, polygons_.empty() ? 1 : 2);
        }
        for (const auto &[place, offset] : points_) {
            builder_.from({offset});
            builder_.addPoint(place, 1);
        }
    }

    const SourceText &source_;
    std::string_view text_;
    TextScanner faults_;
    std::size_t at_ = 0;
    std::vector<std::vector<WktPath>> polygons_; ///< rings of each, the first node not repeated
    std::vector<WktPath> lines_;
    std::vector<std::pair<Vec2, std::size_t>> points_; ///< and their offsets
    DrawingBuilder builder_;
};

} // namespace

Result<Domain> readWkt(const SourceText &source) {
    return WktReader(source).read();
}

bool looksLikeWkt(std::string_view head) {
    constexpr std::string_view kKinds[] = {
        "point",           "linestring",         "polygon",     "multipoint",   "multipolygon",
        "multilinestring", "geometrycollection", "srid",        "curvepolygon", "circularstring",
        "compoundcurve",   "multicurve",         "multisurface"};
    constexpr std::string_view kNext[] = {"(", ";", "=", "z", "m", "empty"};
    const auto trimmed = [](std::string_view text) {
        return text.substr(std::min(text.find_first_not_of(kWktBlanks), text.size()));
    };
    const std::string start = lowerCase(trimmed(head).substr(0, 32));
    const std::size_t length = std::min(start.find_first_of(" \t\r\n(;="), start.size());
    std::string_view kind = std::string_view(start).substr(0, length);
    const std::string_view after = trimmed(std::string_view(start).substr(length));
    const auto isKind = [&] { return std::find(std::begin(kKinds), std::end(kKinds), kind) != std::end(kKinds); };
    for (const std::string_view suffix : {"zm", "z", "m"}) {
        if (!isKind() && kind.ends_with(suffix)) {
            kind.remove_suffix(suffix.size());
        }
    }
    return isKind() && after.find('{') == std::string_view::npos && // "Point(1) = {" is a geometry of Gmsh
           std::any_of(std::begin(kNext), std::end(kNext), [&](auto next) { return after.starts_with(next); });
}

} // namespace forefront
