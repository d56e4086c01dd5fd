#include "core/drawing_files/svg/xml/svg_names.hpp"

#include "core/engine/base/letter_case.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace forefront {

bool isGeneratedName(std::string_view name) {
    constexpr std::array<std::string_view, 16> kWords = {"path",    "rect", "circle", "ellipse",   "line",   "polyline",
                                                         "polygon", "use",  "g",      "rectangle", "vector", "group",
                                                         "layer",   "svg",  "xmlid",  "shape"};
    const std::string word = lowerCase(name.substr(0, name.find_first_of("0123456789-_. ")));
    return name.empty() || (std::find(kWords.begin(), kWords.end(), word) != kWords.end() &&
                            name.find_first_not_of("0123456789-_. ", word.size()) == std::string_view::npos);
}

} // namespace forefront
