#include "app/batch/unit_option.hpp"

#include "app/batch/cli_options.hpp"
#include "core/drawing_files/drawing_formats.hpp"

#include <algorithm>

namespace forefront {

namespace {

std::string formatsWithUnits() {
    std::string list;
    for (const FileFormat &format : allFormats().list()) {
        if (format.namesUnit) {
            list += (list.empty() ? "" : ", ") + std::string(format.id);
        }
    }
    return list;
}

bool namesUnit(const Output &output) {
    if (!output.format.empty()) {
        const FileFormat *const format = allFormats().withId(output.format);
        return format != nullptr && format->namesUnit;
    }
    for (const FileFormat *format : allFormats().withExtensionOf(output.path)) {
        if (format->writesMesh) {
            return format->namesUnit;
        }
    }
    return false;
}

} // namespace

void addUnitOption(CLI::App &app, MeshForm &form, const std::string &fallback) {
    addWordOption<LengthUnit>(
        app, "--unit", form.unit,
        "unit of the coordinates, which the outputs name; the coordinates do not change. none, mm, cm, m, km, in or "
        "ft; default: " +
            fallback + ". Formats: " + formatsWithUnits())
        ->type_name("UNIT");
}

std::string checkUnit(const MeshForm &form, const std::vector<Output> &outputs) {
    return !form.unit || std::any_of(outputs.begin(), outputs.end(), namesUnit)
               ? std::string()
               : "--unit: no output names a unit; write one of the formats " + formatsWithUnits();
}

MeshForm withUnitOf(LengthUnit input, MeshForm form) {
    form.unit = form.unit.value_or(input);
    return form;
}

} // namespace forefront
