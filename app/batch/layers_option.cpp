#include "app/batch/layers_option.hpp"

#include "app/batch/suggestion.hpp"
#include "core/files/common/names.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>

namespace forefront {

namespace {

constexpr const char *kKeys = "first, growth, count, thickness or type";

std::optional<double> numberOf(std::string_view text) {
    double value = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    return fault == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// Sets one value of a specification. Returns what is wrong.
std::string setValue(std::string_view key, std::string_view value, LayerSpec &spec) {
    if (key == "type") {
        const std::optional<LayerCells> cells = fromWord<LayerCells>(value);
        spec.cells = cells.value_or(spec.cells);
        return cells ? ""
                     : "unknown type '" + std::string(value) + "'; expected " + wordList<LayerCells>() +
                           suggestion(value, wordsOf<LayerCells>());
    }
    const std::optional<double> number = numberOf(value);
    if (!number) {
        return "expected a number for " + std::string(key) + ", got '" + std::string(value) + "'";
    }
    if (key == "first") {
        spec.first = *number;
    } else if (key == "growth") {
        spec.growth = *number;
    } else if (key == "thickness") {
        spec.thickness = *number;
    } else if (!(*number >= 1.0 && *number <= kMaxLayers &&
                 *number == static_cast<double>(static_cast<std::uint32_t>(*number)))) {
        return "expected a whole number from 1 to " + std::to_string(kMaxLayers) + " for count, got '" +
               std::string(value) + "'";
    } else {
        spec.count = static_cast<std::uint32_t>(*number);
    }
    return {};
}

/// Parses one value of --layers. Returns what is wrong.
std::string parseOne(const std::string &text, LayersArgument &layers) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos || colon == 0) {
        return "expected NAME:first=H, such as wing:first=1e-4,growth=1.2,count=20";
    }
    layers.name = text.substr(0, colon);
    std::vector<std::string_view> seen;
    for (std::string_view rest = std::string_view(text).substr(colon + 1); !rest.empty();) {
        const std::string_view item = rest.substr(0, rest.find(','));
        rest.remove_prefix(std::min(rest.size(), item.size() + 1));
        const std::string_view key = item.substr(0, item.find('='));
        constexpr std::array<std::string_view, 5> kKnown = {"first", "growth", "count", "thickness", "type"};
        if (std::find(kKnown.begin(), kKnown.end(), key) == kKnown.end() || key.size() == item.size()) {
            return "unknown setting '" + std::string(item) + "'; expected KEY=VALUE with " + kKeys +
                   suggestion(key, kKnown);
        }
        if (std::find(seen.begin(), seen.end(), key) != seen.end()) {
            return std::string(key) + " is given twice";
        }
        seen.push_back(key);
        if (std::string wrong = setValue(key, item.substr(key.size() + 1), layers.spec); !wrong.empty()) {
            return wrong;
        }
    }
    if (std::find(seen.begin(), seen.end(), "first") == seen.end()) {
        return "the height of the first layer is missing; add first=H";
    }
    const std::optional<Diagnostic> fault = layerFault(layers.spec, layers.name);
    return fault ? fault->message + "; " + fault->advice : std::string();
}

} // namespace

void addLayersOption(CLI::App &app, std::vector<std::string> &texts) {
    app.add_option("--layers", texts,
                   "boundary layers on a boundary part, such as wing:first=1e-4,growth=1.2,count=20: the height of the "
                   "first layer, the growth (default 1.2), and the count or the thickness of all layers, else layers "
                   "until their elements are isotropic; type=triangles divides the quadrilaterals; can be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME:KEY=VALUE,...");
}

std::string parseLayers(const std::vector<std::string> &texts, std::vector<LayersArgument> &layers) {
    for (const std::string &text : texts) {
        if (const std::string wrong = parseOne(text, layers.emplace_back()); !wrong.empty()) {
            return std::string("--layers ").append(text).append(": ").append(wrong);
        }
    }
    return {};
}

Diagnostics applyLayers(const std::vector<LayersArgument> &layers, MeshingJob &job) {
    std::map<std::int32_t, std::string> parts;
    for (const DomainSegment &segment : job.domain.segments) {
        parts.try_emplace(segment.tag, boundaryName(job.domain.boundaryNames, segment.tag));
    }
    std::vector<LayerSpec> given;
    for (const LayersArgument &argument : layers) {
        bool found = false;
        for (const auto &[tag, name] : parts) {
            const bool named =
                std::any_of(parts.begin(), parts.end(), [&](const auto &part) { return part.second == argument.name; });
            if (named ? name == argument.name : "boundary_" + std::to_string(tag) == argument.name) {
                given.push_back(argument.spec);
                given.back().tag = tag;
                found = true;
            }
        }
        if (!found) {
            std::vector<std::string> known;
            known.reserve(parts.size());
            for (const auto &[tag, name] : parts) {
                known.push_back(name);
            }
            constexpr std::size_t kListed = 20;
            const std::vector<std::string_view> words(known.begin(), known.end());
            return error("unknown-boundary",
                         "--layers: unknown boundary part " + argument.name + suggestion(argument.name, words),
                         "expected one of " + listed(known, kListed));
        }
    }
    std::erase_if(job.layers, [&](const LayerSpec &own) {
        return std::any_of(given.begin(), given.end(), [&](const LayerSpec &spec) { return spec.tag == own.tag; });
    });
    job.layers.insert(job.layers.end(), given.begin(), given.end());
    return {};
}

} // namespace forefront
