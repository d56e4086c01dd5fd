#include "app/batch/layers_option.hpp"

#include "app/batch/cli_options.hpp"
#include "app/batch/named_tags.hpp"
#include "app/batch/setting_list.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace forefront {

namespace {

/// Sets one value of a specification. Returns what is wrong.
std::string setValue(std::string_view key, std::string_view value, LayerSpec &spec) {
    if (key == "type") {
        return setWord("type", value, spec.cells);
    }
    const std::optional<double> number = numberIn(value);
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
    static constexpr std::array<std::string_view, 5> kKnown = {"first", "growth", "count", "thickness", "type"};
    SettingList list;
    const auto set = [&](std::string_view key, std::string_view value) { return setValue(key, value, layers.spec); };
    if (std::string wrong = readSettings(text,
                                         {kKnown, "first, growth, count, thickness or type",
                                          "NAME:first=H, such as wing:first=1e-4,growth=1.2,count=20", set},
                                         list);
        !wrong.empty()) {
        return wrong;
    }
    layers.name = list.name;
    if (!list.has("first")) {
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
    const NamedTags parts = NamedTags::ofParts(job.domain);
    std::vector<LayerSpec> given;
    for (const LayersArgument &argument : layers) {
        const std::vector<std::int32_t> tags = parts.all(argument.name);
        if (tags.empty()) {
            return parts.unknown("--layers", argument.name);
        }
        for (const std::int32_t tag : tags) {
            given.push_back(argument.spec);
            given.back().tag = tag;
        }
    }
    std::erase_if(job.layers, [&](const LayerSpec &own) {
        return std::any_of(given.begin(), given.end(), [&](const LayerSpec &spec) { return spec.tag == own.tag; });
    });
    job.layers.insert(job.layers.end(), given.begin(), given.end());
    return {};
}

} // namespace forefront
