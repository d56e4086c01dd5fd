#include "app/batch/tags_option.hpp"

#include "app/batch/cli_options.hpp"
#include "core/drawing_files/drawing_formats.hpp"

#include <algorithm>

namespace forefront {

namespace {

std::string formatsWithTagsApart() {
    std::string list;
    for (const FileFormat &format : allFormats().list()) {
        if (format.tellsTagsApart) {
            list += (list.empty() ? "" : ", ") + std::string(format.id);
        }
    }
    return list;
}

bool tellsTagsApart(const Output &output) {
    if (!output.format.empty()) {
        const FileFormat *const format = allFormats().withId(output.format);
        return format != nullptr && format->tellsTagsApart;
    }
    for (const FileFormat *format : allFormats().withExtensionOf(output.path)) {
        if (format->writesMesh) {
            return format->tellsTagsApart;
        }
    }
    return false;
}

} // namespace

void addTagsOption(CLI::App &app, MeshForm &form) {
    static constexpr std::string_view kRules[] = {"apart", "keep"};
    app.add_option_function<std::string>(
           "--tags", [&form](const std::string &word) { form.keepTags = word == "keep"; },
           "numbers and names of physical groups. apart (default): no two groups have the same, even where a region "
           "has "
           "the tag or name of a boundary part. keep: as they are in the drawing or input; formats: " +
               formatsWithTagsApart())
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
    return std::any_of(outputs.begin(), outputs.end(), tellsTagsApart)
               ? std::string()
               : "--tags: no output numbers tags apart; write one of the formats " + formatsWithTagsApart();
}

} // namespace forefront
