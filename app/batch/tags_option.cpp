#include "app/batch/tags_option.hpp"

#include "app/batch/cli_options.hpp"
#include "app/batch/output_formats.hpp"

namespace forefront {

void addTagsOption(CLI::App &app, MeshForm &form) {
    static constexpr std::string_view kRules[] = {"apart", "keep"};
    app.add_option_function<std::string>(
           "--tags", [&form](const std::string &word) { form.keepTags = word == "keep"; },
           "numbers and names of physical groups. apart (default): no two groups have the same, even where a region "
           "has "
           "the tag or name of a boundary part. keep: as they are in the drawing or input; formats: " +
               idsOf(&FileFormat::tellsTagsApart))
        ->check(oneOf(kRules))
        ->type_name("RULE");
}

std::string checkTags(const MeshForm &form, const std::vector<Output> &outputs) {
    if (!form.keepTags) {
        return {};
    }
    if (form.extrusion) {
        return "--tags: extruded meshes have faces and volumes, which are numbered apart; leave out --tags keep";
    }
    return anyHas(outputs, &FileFormat::tellsTagsApart)
               ? std::string()
               : "--tags: no output numbers tags apart; write one of the formats " + idsOf(&FileFormat::tellsTagsApart);
}

} // namespace forefront
