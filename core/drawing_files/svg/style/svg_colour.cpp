#include "core/drawing_files/svg/style/svg_colour.hpp"

#include "core/drawing_files/svg/values/svg_pen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

namespace forefront {

namespace {

constexpr SvgColour kWhite{1.0, 1.0, true};

/// Luminance of a colour with components from 0 to 1, with the weights of SVG masks.
double luminanceOf(double red, double green, double blue) {
    return 0.2125 * red + 0.7154 * green + 0.0721 * blue;
}

bool isHexColour(std::string_view digits) {
    const bool known = digits.size() == 3 || digits.size() == 4 || digits.size() == 6 || digits.size() == 8;
    return known && digits.find_first_not_of("0123456789abcdef") == digits.npos;
}

int hexDigit(char c) {
    return c <= '9' ? c - '0' : c - 'a' + 10;
}

SvgColour hexColour(std::string_view digits) {
    if (!isHexColour(digits)) {
        return kWhite;
    }
    const bool shortForm = digits.size() <= 4;
    std::array<double, 4> part{0.0, 0.0, 0.0, 1.0};
    for (std::size_t k = 0; k < digits.size() / (shortForm ? 1 : 2); ++k) {
        const int high = hexDigit(digits[shortForm ? k : 2 * k]), low = hexDigit(digits[shortForm ? k : 2 * k + 1]);
        part[k] = (16 * high + low) / 255.0;
    }
    return {luminanceOf(part[0], part[1], part[2]), part[3], true};
}

/// An argument of a colour function.
struct Component {
    double value = 0.0;
    bool percent = false;
    /// Returns the argument as a fraction of `whole`, or of 100 if it is a percentage; limited to 0 to 1.
    double of(double whole) const { return std::clamp(value / (percent ? 100.0 : whole), 0.0, 1.0); }
};
using Components = std::array<Component, 4>; ///< the last one is the opacity

/// Reads the arguments of a colour function; std::nullopt if they are malformed.
std::optional<Components> componentsOf(std::string_view arguments) {
    Components components{{{}, {}, {}, {1.0}}};
    SvgNumbers numbers(arguments);
    for (std::size_t k = 0; k < components.size() && !numbers.atEnd(); ++k) {
        if (numbers.peek() == '/') {
            numbers.skip();
        }
        if (!numbers.number(components[k].value)) {
            return std::nullopt;
        }
        components[k].percent = numbers.unit() == "%";
    }
    return components;
}

/// Returns the colour of rgb(), rgba(): numbers up to 255 or percentages.
SvgColour fromRgb(const Components &c) {
    constexpr double kWhole = 255.0;
    return {luminanceOf(c[0].of(kWhole), c[1].of(kWhole), c[2].of(kWhole)), c[3].of(1.0), true};
}

/// Returns the colour of hsl(), hsla(): the hue in degrees, saturation and lightness as percentages (formula of CSS
/// Color 4).
SvgColour fromHsl(const Components &c) {
    const double saturation = c[1].of(1.0), lightness = c[2].of(1.0);
    const double range = saturation * std::min(lightness, 1.0 - lightness);
    const auto component = [&](double shift) {
        const double turn = std::fmod(std::fmod(shift + c[0].value / 30.0, 12.0) + 12.0, 12.0);
        return lightness - range * std::clamp(std::min(turn - 3.0, 9.0 - turn), -1.0, 1.0);
    };
    return {luminanceOf(component(0.0), component(8.0), component(4.0)), c[3].of(1.0), true};
}

/// The names of CSS Color 4, each between blanks.
constexpr std::string_view kColourNames =
    " aliceblue antiquewhite aqua aquamarine azure beige bisque black blanchedalmond blue blueviolet brown "
    "burlywood cadetblue chartreuse chocolate coral cornflowerblue cornsilk crimson cyan darkblue darkcyan "
    "darkgoldenrod darkgray darkgreen darkgrey darkkhaki darkmagenta darkolivegreen darkorange darkorchid "
    "darkred darksalmon darkseagreen darkslateblue darkslategray darkslategrey darkturquoise darkviolet "
    "deeppink deepskyblue dimgray dimgrey dodgerblue firebrick floralwhite forestgreen fuchsia gainsboro "
    "ghostwhite gold goldenrod gray green greenyellow grey honeydew hotpink indianred indigo ivory khaki "
    "lavender lavenderblush lawngreen lemonchiffon lightblue lightcoral lightcyan lightgoldenrodyellow "
    "lightgray lightgreen lightgrey lightpink lightsalmon lightseagreen lightskyblue lightslategray "
    "lightslategrey lightsteelblue lightyellow lime limegreen linen magenta maroon mediumaquamarine "
    "mediumblue mediumorchid mediumpurple mediumseagreen mediumslateblue mediumspringgreen mediumturquoise "
    "mediumvioletred midnightblue mintcream mistyrose moccasin navajowhite navy oldlace olive olivedrab "
    "orange orangered orchid palegoldenrod palegreen paleturquoise palevioletred papayawhip peachpuff peru "
    "pink plum powderblue purple rebeccapurple red rosybrown royalblue saddlebrown salmon sandybrown "
    "seagreen seashell sienna silver skyblue slateblue slategray slategrey snow springgreen steelblue tan "
    "teal thistle tomato turquoise violet wheat white whitesmoke yellow yellowgreen ";

/// Returns true for a name of CSS Color 4 in lower case.
bool isColourName(std::string_view word) {
    return kColourNames.find(" " + std::string(word) + " ") != std::string_view::npos;
}

} // namespace

SvgColour parseColour(std::string_view text, const SvgColour &current) {
    if (text == "currentcolor") {
        return current;
    }
    if (text == "transparent") {
        return {0.0, 0.0, true};
    }
    if (text.starts_with("url(")) {
        return {1.0, 1.0, false};
    }
    if (text.starts_with('#')) {
        return hexColour(text.substr(1));
    }
    if (text.starts_with("rgb") || text.starts_with("hsl")) {
        const std::size_t open = text.find('('), close = text.find(')');
        if (open > close || close == text.npos) {
            return kWhite;
        }
        const auto components = componentsOf(text.substr(open + 1, close - open - 1));
        return !components ? kWhite : text.starts_with("rgb") ? fromRgb(*components) : fromHsl(*components);
    }
    // The luminance of the names that masks use; others count as light, with a note.
    constexpr std::pair<std::string_view, double> kNamed[] = {
        {"black", 0.0},      {"navy", 0.04},      {"blue", 0.07},   {"maroon", 0.11},     {"purple", 0.14},
        {"red", 0.21},       {"green", 0.36},     {"teal", 0.39},   {"olive", 0.47},      {"dimgray", 0.41},
        {"dimgrey", 0.41},   {"gray", 0.5},       {"grey", 0.5},    {"darkgray", 0.66},   {"darkgrey", 0.66},
        {"silver", 0.75},    {"fuchsia", 0.28},   {"lime", 0.72},   {"aqua", 0.79},       {"lightgray", 0.83},
        {"lightgrey", 0.83}, {"gainsboro", 0.86}, {"yellow", 0.93}, {"whitesmoke", 0.96}, {"white", 1.0}};
    const auto *const found =
        std::find_if(std::begin(kNamed), std::end(kNamed), [&](const auto &named) { return named.first == text; });
    return found == std::end(kNamed) ? SvgColour{1.0, 1.0, false} : SvgColour{found->second, 1.0, true};
}

bool isPaint(std::string_view text) {
    constexpr std::string_view kFunctions[] = {"url(",   "rgb(",       "rgba(",       "hsl(",        "hsla(",
                                               "hwb(",   "lab(",       "lch(",        "oklab(",      "oklch(",
                                               "color(", "color-mix(", "light-dark(", "device-cmyk("};
    constexpr std::string_view kOthers[] = {
        "none",        "currentcolor",    "transparent",    "inherit",    "initial",      "unset",
        "revert",      "context-fill",    "context-stroke", "canvas",     "canvastext",   "linktext",
        "visitedtext", "activetext",      "buttonface",     "buttontext", "buttonborder", "field",
        "fieldtext",   "highlight",       "highlighttext",  "mark",       "marktext",     "graytext",
        "accentcolor", "accentcolortext", "window",         "windowtext"};
    if (std::ranges::any_of(kFunctions, [&](std::string_view name) { return text.starts_with(name); })) {
        return true;
    }
    text = text.substr(0, text.find_first_of(" \t\r\n")); // SVG 1.1 allows icc-color() after a colour
    return text.starts_with('#') ? isHexColour(text.substr(1))
                                 : std::ranges::find(kOthers, text) != std::end(kOthers) || isColourName(text);
}

double parseOpacity(std::string_view text) {
    SvgNumbers numbers(text);
    double value = 1.0;
    if (!numbers.number(value)) {
        return 1.0;
    }
    return std::clamp(!numbers.atEnd() && numbers.peek() == '%' ? value / 100.0 : value, 0.0, 1.0);
}

} // namespace forefront
