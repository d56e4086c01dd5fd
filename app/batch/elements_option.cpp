#include "app/batch/elements_option.hpp"

#include "app/batch/named_tags.hpp"
#include "app/batch/option_table.hpp"
#include "app/batch/setting_list.hpp"

#include <cstdint>
#include <string_view>

namespace forefront {

void addElementsOption(CLI::App &app, ElementsArguments &arguments) {
    app.add_option(
           "--elements", arguments.texts,
           "triangles (default), quads: quadrilaterals everywhere, or mixed: quadrilaterals where they are well "
           "shaped, else triangles; with a region, as in quads:soil, the shapes there; can be repeated")
        ->check(offering(wordsOf<Elements>()))
        ->allow_extra_args(false)
        ->type_name("SHAPES[:REGION]");
}

std::string parseElements(ElementsArguments &arguments) {
    for (const std::string &text : arguments.texts) {
        const std::size_t colon = text.find(':');
        const std::string word = text.substr(0, colon);
        Elements shapes = {};
        if (const std::string wrong = setWord("shapes", word, shapes); !wrong.empty()) {
            return "--elements: " + wrong;
        }
        if (colon != std::string::npos) {
            arguments.regions.emplace_back(text.substr(colon + 1), shapes);
        } else if (arguments.everywhere) {
            return "--elements is given twice without a region; expected it once, and once for each region";
        } else {
            arguments.everywhere = shapes;
        }
    }
    return {};
}

Diagnostics applyElements(const ElementsArguments &arguments, MeshingJob &job) {
    job.options.elements = arguments.everywhere.value_or(job.options.elements);
    const NamedTags regions = NamedTags::ofRegions(job.domain);
    for (const auto &[name, shapes] : arguments.regions) {
        const std::optional<std::int32_t> tag = regions.find(name);
        if (!tag) {
            return regions.unknown("--elements", name);
        }
        std::erase_if(job.regionElements, [&](const RegionElements &own) { return own.region == *tag; });
        job.regionElements.push_back({*tag, shapes});
    }
    return {};
}

} // namespace forefront
