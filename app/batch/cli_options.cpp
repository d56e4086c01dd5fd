#include "app/batch/cli_options.hpp"

#include "app/batch/inputs.hpp"
#include "app/batch/option_table.hpp"
#include "app/batch/outputs.hpp"
#include "app/batch/suggestion.hpp"
#include "core/engine/base/letter_case.hpp"
#include "core/files/common/names.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Parses the whole text as a number of that type, with or without a sign.
template <class Number>
std::optional<Number> parse(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) {
        text.remove_prefix(1);
    }
    Number value{};
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    return fault == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::string shown(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

/// Refuses values that `accepts` rejects.
template <class Accepts>
CLI::Validator check(std::string expected, Accepts accepts) {
    return {[expected = std::move(expected), accepts](const std::string &text) {
                return accepts(text) ? std::string() : "expected " + expected + ", got '" + text + '\'';
            },
            ""};
}

/// Parses `count` finite numbers with `separator` between them; empty if the text is anything else.
std::vector<double> numbersIn(std::string_view text, char separator, std::size_t count) {
    std::vector<double> numbers;
    while (numbers.size() < count) {
        const std::size_t end = numbers.size() + 1 < count ? text.find(separator) : text.size();
        const auto value = end == std::string_view::npos ? std::nullopt : parse<double>(text.substr(0, end));
        if (!value || !std::isfinite(*value)) {
            return {};
        }
        numbers.push_back(*value);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return numbers;
}

} // namespace

std::optional<double> numberIn(std::string_view text) {
    return parse<double>(text);
}

CLI::Validator positiveNumber() {
    return check("a positive number", [](const std::string &text) {
        const auto value = parse<double>(text);
        return value && std::isfinite(*value) && *value > 0.0;
    });
}

CLI::Validator nonNegativeNumber() {
    return check("a number of at least 0", [](const std::string &text) {
        const auto value = parse<double>(text);
        return value && std::isfinite(*value) && *value >= 0.0;
    });
}

CLI::Validator numberWithin(double minimum, double maximum) {
    return check("a number from " + shown(minimum) + " to " + shown(maximum),
                 [minimum, maximum](const std::string &text) {
                     const auto value = parse<double>(text);
                     return value && *value >= minimum && *value <= maximum;
                 });
}

CLI::Validator wholeNumberWithin(int minimum, int maximum) {
    return check("a whole number from " + std::to_string(minimum) + " to " + std::to_string(maximum),
                 [minimum, maximum](const std::string &text) {
                     const auto value = parse<int>(text);
                     const bool octal = value && text.ends_with('0' + std::to_string(*value)); // as CLI11 would read it
                     return value && !octal && *value >= minimum && *value <= maximum;
                 });
}

CLI::Validator oneOf(std::span<const std::string_view> words) {
    std::string expected = "expected one of ";
    for (const std::string_view word : words) {
        expected += word;
        expected += word == words.back() ? "" : ", ";
    }
    return withWords(CLI::Validator(
                         [words, expected = std::move(expected)](const std::string &text) {
                             const bool known = std::find(words.begin(), words.end(), text) != words.end();
                             return known ? std::string()
                                          : expected + ", got '" + text + '\'' + suggestion(text, words);
                         },
                         ""),
                     words);
}

void addSpacingOptions(CLI::App &group, std::optional<double> &size, std::optional<std::string> &expression) {
    group.add_option("--size", size, "uniform edge length")->check(positiveNumber())->type_name("H");
    group
        .add_option("--spacing", expression,
                    "edge length as an expression in x and y, with min, max, sqrt, exp, sin, ... "
                    "and dist(a,b), the distance to (a, b); edges have it on average")
        ->type_name("EXPR");
}

bool applySpacingOptions(std::optional<double> size, const std::optional<std::string> &expression,
                         SpacingSpec &spacing) {
    if (!size && !expression) {
        return false;
    }
    SpacingSpec rules;
    rules.size = size;
    rules.expression = expression;
    rules.names = spacing.names; // of the project's parameters
    rules.rasters = spacing.rasters;
    spacing.replaceRules(std::move(rules));
    return true;
}

void addCurveToleranceOption(CLI::App &app, std::optional<CurveToleranceArgument> &tolerance) {
    app.add_option_function<std::string>(
           "--curve-tolerance",
           [&tolerance](std::string text) {
               CurveToleranceArgument given;
               given.percent = text.ends_with('%');
               if (given.percent) {
                   text.pop_back();
               }
               given.value = parse<double>(text).value_or(0.0);
               if (!(given.value > 0.0 && std::isfinite(given.value))) {
                   throw CLI::ValidationError("--curve-tolerance", "expected a positive length or percentage, got '" +
                                                                       text + (given.percent ? "%'" : "'"));
               }
               tolerance = given;
           },
           "maximum distance of a curve from its edges, which also limits the size beside it: a length, or a "
           "percentage of the domain's diagonal; default: from the project, or 0.05%")
        ->type_name("LENGTH|PERCENT%");
}

void addPictureOptions(CLI::App &app, std::optional<PictureSizes> &sizes, std::optional<Box2> &box) {
    app.add_option_function<std::string>(
           "--picture-sizes",
           [&sizes](const std::string &text) {
               const std::vector<double> numbers = numbersIn(text, ':', 2);
               if (numbers.empty() || !(std::min(numbers[0], numbers[1]) > 0.0)) {
                   throw CLI::ValidationError("--picture-sizes",
                                              "expected two positive numbers such as 0.1:2, got '" + text + '\'');
               }
               sizes = PictureSizes{.black = numbers[0], .white = numbers[1]};
           },
           "edge lengths at black and at white in a picture given as --spacing-file, linear in between; transparent "
           "pixels set none")
        ->type_name("BLACK:WHITE");
    addBoxOption(
        app, "--picture-box",
        "rectangle that the picture fills; default: where the project places it as its background picture, else "
        "around the domain, keeping its proportions",
        box);
}

CLI::Option *addBoxOption(CLI::App &app, const std::string &name, const std::string &meaning,
                          std::optional<Box2> &box) {
    const auto read = [&box, name](const std::string &text) {
        const std::vector<double> numbers = numbersIn(text, ',', 4);
        if (numbers.empty() || !(numbers[0] < numbers[2] && numbers[1] < numbers[3])) {
            throw CLI::ValidationError(name, "expected the lower left and upper right corner such as 0,0,20,10, got '" +
                                                 text + '\'');
        }
        box = Box2{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
    };
    return app.add_option_function<std::string>(name, read, meaning)->type_name("X0,Y0,X1,Y1");
}

void addInputFormatOption(CLI::App &app, const std::string &input, std::string &formatId) {
    app.add_option("--input-format", formatId,
                   "format of " + input + ", if content and extension are ambiguous: " + inputFormatIds())
        ->check(offering(inputFormatIds()))
        ->type_name("ID");
}

namespace {

/// Takes a folder as completion writes it, "case.foam/", for its name.
CLI::Validator withoutLastSlash() {
    return {[](std::string &path) {
                while (path.size() > 1 && path.back() == '/') {
                    path.pop_back();
                }
                return std::string();
            },
            ""};
}

} // namespace

CLI::Option *addOutputOptions(CLI::App &app, std::vector<std::filesystem::path> &outputs,
                              std::vector<std::string> &formats, MeshForm &form) {
    auto *output = app.add_option("-o,--output", outputs,
                                  "mesh to write; its extension sets the format; -: standard output; can be repeated")
                       ->allow_extra_args(false)
                       ->transform(withoutLastSlash())
                       ->type_name("OUT");
    app.add_option("--format", formats, "formats of the outputs, in the order of -o: " + formatIds())
        ->allow_extra_args(false)
        ->check(offering(formatIds()))
        ->type_name("ID");
    addWordOption<InnerEdges>(app, "--inner-edges", form.innerEdges,
                              "tagged edges inside the domain in the output meshes: keep (default, except for SU2) or "
                              "drop, for programs such as deal.II that accept tags on the boundary only")
        ->type_name("WORD");
    addWordOption<Numbering>(
        app, "--numbering", form.numbering,
        "numbers of nodes and elements in the output meshes: rcm (default, except for Triangle and "
        "convert), reverse Cuthill-McKee, for matrices of small bandwidth; or creation, the order "
        "in which they were made or read")
        ->type_name("WORD");
    return output;
}

void addMaxElementsOption(CLI::App &app, std::optional<double> &maxElements) {
    app.add_option("--max-elements", maxElements,
                   "refuse to make more elements than this; default: from the project, or " +
                       shown(static_cast<double>(kDefaultMaxElements)))
        ->check(numberWithin(1.0, static_cast<double>(kMaxElements)))
        ->type_name("N");
}

void applyMaxElements(std::optional<double> maxElements, MeshingOptions &options) {
    if (maxElements) {
        options.maxElements = static_cast<std::uint64_t>(*maxElements);
    }
}

void addParameterOption(CLI::App &app, std::map<std::string, std::string> &parameters) {
    app.add_option_function<std::vector<std::string>>(
           "--set",
           [&parameters](const std::vector<std::string> &settings) {
               for (const std::string &setting : settings) {
                   const std::size_t cut = std::min(setting.find('='), setting.size());
                   const std::string name = cleanName(setting.substr(0, cut));
                   const std::string value = cleanName(setting.substr(std::min(cut + 1, setting.size())));
                   if (name.empty() || value.empty()) {
                       throw CLI::ValidationError("--set", "expected NAME=EXPRESSION, got '" + setting + "'");
                   }
                   if (!parameters.emplace(name, value).second) {
                       throw CLI::ValidationError("--set", "parameter '" + name + "' is set twice");
                   }
               }
           },
           "set a parameter of the project, such as r=0.5 or gap=2*r; can be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME=EXPR");
}

void DrawingArguments::applyTo(ImportOptions &options) const {
    options.weldTolerance = weldTolerance;
    options.overlap = overlap.value_or(options.overlap);
    options.degrees = degrees;
    options.layer = layer;
    options.nameProperty = nameProperty;
    options.sizeProperty = sizeProperty;
    options.projection = projection;
    options.beyondPage = beyondPage;
    options.dropLines = dropLines;
    options.strokeAreas = strokeAreas;
    options.shapeRegions = shapeRegions;
    options.whiteHoles = whiteHoles;
    options.partNames = partNames;
}

std::string DrawingArguments::firstGiven() const {
    const std::pair<bool, const char *> given[] = {
        {weldTolerance.has_value(), "--weld"},
        {overlap.has_value(), "--overlap"},
        {layer.has_value(), "--layer"},
        {nameProperty.has_value(), "--name-property"},
        {sizeProperty.has_value(), "--size-property"},
        {degrees == DegreeRule::Local || !projection.empty(), "--projection"},
        {degrees == DegreeRule::Keep, "--allow-degrees"},
        {beyondPage, "--beyond-page"},
        {dropLines, "--drop-lines"},
        {strokeAreas, "--stroke-areas"},
        {shapeRegions, "--shape-regions"},
        {whiteHoles.has_value(), whiteHoles.value_or(true) ? "--white-holes" : "--no-white-holes"},
        {!partNames.empty(), "--name"}};
    const auto *const first =
        std::find_if(std::begin(given), std::end(given), [](const auto &one) { return one.first; });
    return first == std::end(given) ? std::string() : first->second;
}

std::string setProjection(const std::string &word, DrawingArguments &arguments) {
    if (word == "local") {
        arguments.degrees = DegreeRule::Local;
    } else if (word.size() > 5 && lowerCase(word.substr(0, 5)) == "epsg:" &&
               word.find_first_not_of("0123456789", 5) == std::string::npos) {
        arguments.projection = "EPSG:" + word.substr(5);
    } else {
        return "expected local or a code such as EPSG:3067, got '" + word + "'";
    }
    return {};
}

namespace {

/// Adds the options for maps in longitudes and latitudes.
void addDegreeOptions(CLI::App &app, DrawingArguments &arguments) {
    const auto take = [&arguments](const std::string &word) {
        if (const std::string wrong = setProjection(word, arguments); !wrong.empty()) {
            throw CLI::ValidationError("--projection", wrong);
        }
    };
    auto *const option =
        app.add_option_function<std::string>(
               "--projection", take,
               "convert the coordinates of a map. local: longitudes and latitudes to metres, azimuthal "
               "equidistant about the middle of the map; distances from there are true. EPSG:n: any "
               "map that names its reference system, and GeoTIFF rasters, to that one (needs "
               "forefront-gdal)")
            ->type_name("NAME");
    app.add_flag_callback(
           "--allow-degrees", [&arguments] { arguments.degrees = DegreeRule::Keep; },
           "take the longitudes and latitudes of a map for coordinates in the plane, without a warning")
        ->excludes(option);
}

/// Adds --name, which can be repeated.
void addPartNameOption(CLI::App &app, std::vector<PartName> &parts) {
    const auto read = [&parts](const std::vector<std::string> &texts) {
        for (const std::string &text : texts) {
            const std::size_t colon = std::min(text.rfind(':'), text.size()); // names may hold colons
            const std::string places = text.substr(std::min(colon + 1, text.size()));
            const std::size_t between = std::min(places.find(';'), places.size());
            const std::string second = places.substr(std::min(between + 1, places.size()));
            const std::vector<double> from = numbersIn(places.substr(0, between), ',', 2);
            const std::vector<double> to = numbersIn(second, ',', 2);
            const std::string name = cleanName(text.substr(0, colon));
            if (name.empty() || from.empty() || to.empty()) {
                throw CLI::ValidationError(
                    "--name", "expected NAME:X1,Y1;X2,Y2, such as \"sea:0,0;5,0\" in quotes, got '" + text + '\'');
            }
            parts.push_back({name, {from[0], from[1]}, {to[0], to[1]}});
        }
    };
    app.add_option_function<std::vector<std::string>>(
           "--name", read,
           "name the part of the boundary from the node nearest to the first place to the node nearest to the second, "
           "with the domain on the left; the same place twice: the whole loop. Of a map, the places are in its own "
           "coordinates, longitude first, also with --projection. A line of the map on the edge of an area, within "
           "--weld, also gives its name to that edge. Can be repeated")
        ->allow_extra_args(false)
        ->type_name("\"NAME:X1,Y1;X2,Y2\"");
}

} // namespace

void addDrawingOptions(CLI::App &app, DrawingArguments &arguments) {
    addDegreeOptions(app, arguments);
    addPartNameOption(app, arguments.partNames);
    app.add_option(
           "--weld", arguments.weldTolerance,
           "join nodes and segments closer than this (default: 1e-6 of the diagonal for drawings and maps, less "
           "if that changes their area by over 0.1 %; 0 for other files, which are joined only with --repair)")
        ->check(nonNegativeNumber())
        ->type_name("T");
    addWordOption<OverlapRule>(app, "--overlap", arguments.overlap,
                               "which polygon of a map wins where two overlap: later (default) or smaller; a polygon "
                               "inside another always keeps its area")
        ->type_name("RULE");
    app.add_option("--layer", arguments.layer,
                   "layers of a DXF, GeoPackage or KML file to read, with commas between them; default: all that are "
                   "shown of a drawing, the first one with polygons of a map. Or the layer of a TopoJSON file")
        ->type_name("NAME");
    app.add_option("--name-property", arguments.nameProperty,
                   "property of the features of a map that names regions and boundaries, text or numbers; id also "
                   "uses the own ids of the features; default: name, Name or NAME, else NAME_n of the finest "
                   "administrative level n")
        ->type_name("KEY");
    app.add_option("--size-property", arguments.sizeProperty,
                   "property of the features of a map that gives the element size in areas and at points, a number; "
                   "default: none")
        ->type_name("KEY");
    app.add_flag("--beyond-page", arguments.beyondPage,
                 "keep the parts of filled SVG shapes that lie outside the page (the view box)");
    app.add_flag(
        "--drop-lines", arguments.dropLines,
        "leave out the lines of a drawing or map that has filled shapes or polygons: SVG paths without a fill, "
        "line strings");
    app.add_flag("--stroke-areas", arguments.strokeAreas,
                 "also mesh the area that SVG strokes paint; by default, strokes are lines");
    app.add_flag("--shape-regions", arguments.shapeRegions,
                 "make every filled SVG shape a region named by its id or label, as far as no later shape covers it; "
                 "by default, all shapes are one region");
    // A flag of CLI11 with a negative form counts as given even where it is not.
    auto *const holes = app.add_flag_callback(
        "--white-holes", [&arguments] { arguments.whiteHoles = true; },
        "white filled SVG shapes that lie on others are holes in these (default, unless nothing would remain)");
    app.add_flag_callback(
           "--no-white-holes", [&arguments] { arguments.whiteHoles = false; },
           "white filled SVG shapes that lie on others are merged with them")
        ->excludes(holes);
}

} // namespace forefront
