#include "app/batch/form_options.hpp"

#include "app/batch/elevation_option.hpp"
#include "app/batch/extrude_option.hpp"
#include "app/batch/open_boundaries.hpp"
#include "app/batch/output_formats.hpp"
#include "app/batch/tags_option.hpp"
#include "app/batch/unit_option.hpp"

namespace forefront {

void addFormOptions(CLI::App &app, MeshForm &form, const std::string &unit) {
    addOpenOption(app, form);
    addExtrudeOption(app, form);
    addTagsOption(app, form);
    addUnitOption(app, form, unit);
    addElevationOption(app, form.elevation);
}

void useWaterOf(const std::vector<std::int32_t> &openBoundaries, const std::string &elevation,
                const std::vector<Output> &outputs, MeshForm &form) {
    form.openOfProject = openBoundaries;
    if (!form.elevation && !elevation.empty() && anyHas(outputs, &FileFormat::holdsElevations)) {
        form.elevation = elevation;
    }
}

std::string checkForm(const MeshForm &form, const std::vector<Output> &outputs, std::optional<ElementOrder> order) {
    std::string wrong = checkOpen(form, outputs);
    if (wrong.empty()) {
        wrong = checkExtrude(form, outputs, order);
    }
    if (wrong.empty()) {
        wrong = checkTags(form, outputs);
    }
    if (wrong.empty()) {
        wrong = checkUnit(form, outputs);
    }
    return wrong.empty() ? checkElevation(form.elevation, outputs) : wrong;
}

} // namespace forefront
