#include "app/batch/unit_option.hpp"

#include "app/batch/cli_options.hpp"
#include "app/batch/output_formats.hpp"

namespace forefront {

void addUnitOption(CLI::App &app, MeshForm &form, const std::string &fallback) {
    addWordOption<LengthUnit>(
        app, "--unit", form.unit,
        "unit of the coordinates, which the outputs name; the coordinates do not change. none, mm, cm, m, km, in or "
        "ft; default: " +
            fallback + ". Formats: " + idsOf(&FileFormat::namesUnit))
        ->type_name("UNIT");
}

std::string checkUnit(const MeshForm &form, const std::vector<Output> &outputs) {
    return !form.unit || anyHas(outputs, &FileFormat::namesUnit)
               ? std::string()
               : "--unit: no output names a unit; write one of the formats " + idsOf(&FileFormat::namesUnit);
}

MeshForm withUnitOf(LengthUnit input, MeshForm form) {
    form.unit = form.unit.value_or(input);
    return form;
}

} // namespace forefront
