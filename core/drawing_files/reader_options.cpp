#include "core/drawing_files/reader_options.hpp"

#include "core/drawing_files/drawing_formats.hpp"
#include "core/files/format_list.hpp"

#include <cstddef>
#include <vector>

namespace forefront {

namespace {

using Accepts = bool (*)(const FileFormat &);

bool isMap(const FileFormat &format) {
    return format.kind == FileKind::Map;
}
bool isProject(const FileFormat &format) {
    return format.kind == FileKind::Project;
}
bool isPage(const FileFormat &format) {
    return format.kind == FileKind::Drawing;
}
bool hasLayers(const FileFormat &format) {
    return format.hasLayers;
}
bool hasCurves(const FileFormat &format) {
    return format.readsCurves;
}
bool arranges(const FileFormat &format) {
    return format.arranges;
}
/// Formats with filled shapes beside lines; all lines of a CAD drawing are alike.
bool hasLines(const FileFormat &format) {
    return format.arranges && format.kind != FileKind::CadDrawing;
}
/// A project keeps names of its own.
bool takesNames(const FileFormat &format) {
    return format.readsDomain && !isProject(format);
}

/// The formats that an option belongs to, and the words after and before their names.
struct Rule {
    Accepts accepts;
    const char *what;
    const char *only = "only ";
};

Rule ruleOf(ReaderOption option) {
    switch (option) {
    case ReaderOption::CurveTolerance:
        return {hasCurves, "have curves that are read with a tolerance"};
    case ReaderOption::Weld:
        return {arranges, "are joined while they are read"};
    case ReaderOption::Layer:
        return {hasLayers, "have layers"};
    case ReaderOption::NameProperty:
    case ReaderOption::SizeProperty:
        return {isMap, "have properties", "only the features of "};
    case ReaderOption::Projection:
        return {isMap, "name a coordinate reference system"};
    case ReaderOption::Degrees:
        return {isMap, "have longitudes and latitudes"};
    case ReaderOption::Overlap:
        return {isMap, "have an order", "only the polygons of "};
    case ReaderOption::PartNames:
        return {takesNames, "get names by places"};
    case ReaderOption::DropLines:
        return {hasLines, "have lines beside filled shapes"};
    case ReaderOption::BeyondPage:
    case ReaderOption::StrokeAreas:
    case ReaderOption::ShapeRegions:
    case ReaderOption::WhiteHoles:
        return {isPage, "have filled shapes on a page"};
    case ReaderOption::Parameters:
        return {isProject, "have parameters"};
    }
    return {};
}

/// Returns the names of the accepted formats that domains are read from, such as "GeoJSON and TopoJSON".
std::string formatNames(Accepts accepts) {
    std::vector<std::string> names;
    for (const FileFormat &format : allFormats().list()) {
        if (format.readsDomain && accepts(format)) {
            names.emplace_back(format.name);
        }
    }
    std::string text;
    for (std::size_t k = 0; k < names.size(); ++k) {
        text += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
    }
    return text;
}

} // namespace

std::string reasonWithout(ReaderOption option, const FileFormat &format) {
    const Rule rule = ruleOf(option);
    if (rule.accepts(format)) {
        return {};
    }
    const std::string name = format.name;
    switch (option) {
    case ReaderOption::Weld:
        return name + " files are read unchanged";
    case ReaderOption::PartNames:
        return "the parts of a " + name + " keep names of their own";
    default:
        return rule.only + formatNames(rule.accepts) + " files " + rule.what + "; the file is in the format " + name;
    }
}

} // namespace forefront
