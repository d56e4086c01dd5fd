#include "core/files/foreign_files.hpp"

#include "core/engine/base/letter_case.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace forefront {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kHead = 4096; ///< bytes that are looked at

std::string_view withoutBlanks(std::string_view text) {
    const std::size_t start = text.find_first_not_of(" \t\r\n"sv);
    return start == std::string_view::npos ? std::string_view() : text.substr(start);
}

std::string_view nextLine(std::string_view &text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

/// Returns true for text that defines entities of Gmsh's geometry language: "Point(1) = {0, 0, 0};".
bool isGmshGeometry(std::string_view head) {
    constexpr std::string_view kEntities[] = {"point(",        "line(",      "curve(",  "circle(",   "ellipse(",
                                              "spline(",       "bspline(",   "bezier(", "lineloop(", "curveloop(",
                                              "planesurface(", "rectangle(", "disk("};
    while (!head.empty()) {
        std::string line = lowerCase(nextLine(head));
        std::erase_if(line, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
        const std::size_t close = line.find(")={");
        if (close != std::string::npos && line.find(')') == close &&
            std::any_of(std::begin(kEntities), std::end(kEntities),
                        [&](std::string_view entity) { return line.starts_with(entity); })) {
            return true;
        }
    }
    return false;
}

constexpr char kToGeoJson[] = "convert it to GeoJSON, for example with ogr2ogr NEW.geojson FILE";

/// The kind of an unsupported file, and advice on it.
struct ForeignKind {
    std::string_view name, advice;
};

/// Returns true for text in UTF-16, with its byte order mark or, of ASCII characters, without.
bool isUtf16(std::string_view head) {
    if (head.starts_with("\xff\xfe"sv) || head.starts_with("\xfe\xff"sv)) {
        return true;
    }
    constexpr std::size_t kShortest = 8;
    for (const std::size_t high : {0U, 1U}) { // of the two bytes of a character
        bool ascii = head.size() >= kShortest;
        for (std::size_t k = 0; ascii && k < kShortest; ++k) {
            const char c = head[k];
            ascii = k % 2 == high ? c == '\0' : (c >= ' ' && c <= '~') || c == '\n' || c == '\r' || c == '\t';
        }
        if (ascii) {
            return true;
        }
    }
    return false;
}

ForeignKind kindOf(std::string_view head) {
    constexpr std::pair<std::string_view, ForeignKind> kSignatures[] = {
        {"\0\0\x27\x0a"sv, {"an ESRI shapefile", kToGeoJson}},
        {"SQLite format 3"sv, {"a database, perhaps of a map", kToGeoJson}},
        {"PK\x03\x04"sv, {"a ZIP archive", "unpack it first, for example with unzip FILE"}},
        {"%PDF-"sv, {"a PDF document", "convert it to SVG, for example with pdftocairo -svg FILE NEW.svg"}},
        {"%!PS-Adobe"sv,
         {"a PostScript drawing", "convert it to PDF and then to SVG, for example with ps2pdf and pdftocairo -svg"}},
        {"AC10"sv, {"a DWG drawing", "save it as DXF in ASCII, version 2000 or later, in the program that made it"}},
        {"AutoCAD Binary DXF"sv, {"a binary DXF drawing", "save it as DXF in ASCII in the program that made it"}},
        {"\xff\xd8\xff"sv,
         {"a JPEG picture", "trace its outlines first, for example with Path > Trace Bitmap in Inkscape"}},
    };
    for (const auto &[signature, kind] : kSignatures) {
        if (head.starts_with(signature)) {
            return kind;
        }
    }
    if (isUtf16(head)) {
        return {"text in UTF-16", "save it as UTF-8, for example with iconv -f UTF-16 -t UTF-8 FILE >NEW"};
    }
    if (isGmshGeometry(head)) {
        return {"a geometry of Gmsh", "mesh it with Gmsh first: gmsh -2 FILE -o NEW.msh"};
    }
    const std::string root = rootElement(head);
    if (root == "html") {
        return {"a web page", "save the drawing or map itself, not the page that shows it"};
    }
    constexpr std::pair<std::string_view, std::string_view> kMaps[] = {{"kml", "a KML file"}, {"gpx", "a GPX file"}};
    for (const auto &[name, kind] : kMaps) {
        if (root == name) {
            return {kind, kToGeoJson};
        }
    }
    if (root.ends_with("featurecollection")) {
        return {"a GML file", kToGeoJson};
    }
    return {};
}

} // namespace

std::string rootElement(std::string_view head) {
    if (!withoutBlanks(head).starts_with('<')) {
        return {};
    }
    for (std::size_t at = head.find('<'); at != std::string_view::npos; at = head.find('<', at + 1)) {
        const std::string_view rest = head.substr(at);
        if (rest.starts_with("<!--") || rest.starts_with("<?")) {
            at = std::min(head.find(rest.starts_with("<?") ? "?>" : "-->", at), head.size());
            continue;
        }
        const std::size_t end = head.find_first_of(" \t\r\n/>"sv, at + 1);
        const std::string_view name = head.substr(at + 1, end == std::string_view::npos ? end : end - at - 1);
        if (!name.empty() && name.front() != '!') {
            return lowerCase(name);
        }
    }
    return {};
}

Diagnostics foreignFile(std::string_view bytes) {
    const ForeignKind kind = kindOf(bytes.substr(0, kHead));
    return kind.name.empty()
               ? Diagnostics{}
               : error("foreign-format", "the file is " + std::string(kind.name) + ", which cannot be read",
                       std::string(kind.advice));
}

} // namespace forefront
