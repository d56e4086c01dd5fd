#include "ui/panels/region_rows.hpp"

#include "core/drawing/names/region_commands.hpp"
#include "ui/panels/form.hpp"
#include "ui/panels/shared_number.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/number_field.hpp"

#include <optional>

namespace forefront {
namespace {

/// Applies a command to each of several regions, as one step.
template <class Command>
void applyToAll(Shell &context, const std::set<std::uint32_t> &markers, const char *label, const Command &command) {
    Document document = *context.document.current();
    for (const std::uint32_t marker : markers) {
        Result<Document> next = command(document, marker);
        if (!next) {
            context.applyCommand(std::move(next), label);
            return;
        }
        document = *std::move(next);
    }
    context.applyCommand(std::move(document), label);
}

} // namespace

void manyRegionsRows(Shell &context, const std::set<std::uint32_t> &markers) {
    SharedNumber tag, area, size;
    const auto given = [](double number) { return number > 0.0 ? std::optional(number) : std::nullopt; };
    for (const std::uint32_t k : markers) {
        const MarkedRegion &marker = context.document.current()->regionMarkers[k];
        tag.add(marker.tag);
        area.add(given(marker.maxArea));
        size.add(given(marker.size));
    }
    form::label(context, "Region tag");
    if (form::optionalField(context, "inspector/tag", tag.value, tag.hint()) && tag.value &&
        ui::checkTag(context, "inspector/tag", *tag.value)) {
        applyToAll(context, markers, "Change regions", [&](const Document &document, std::uint32_t marker) {
            return setRegionTag(document, marker, static_cast<std::int32_t>(*tag.value));
        });
        return;
    }
    ui::rowTooltip(context, "Regions with the same tag are one region, with one name");
    form::label(context, "Max. area");
    if (form::optionalField(context, "inspector/maxarea", area.value, area.hint("no limit"))) {
        applyToAll(context, markers, "Limit area of regions", [&](const Document &document, std::uint32_t marker) {
            return setRegionArea(document, marker, area.value.value_or(0.0));
        });
        return;
    }
    ui::rowTooltip(context, "Maximum area of an element in these regions");
    form::label(context, "Size");
    if (form::optionalField(context, "inspector/regionsize", size.value, size.hint())) {
        applyToAll(context, markers, "Change size of regions", [&](const Document &document, std::uint32_t marker) {
            const double growth = document.regionMarkers[marker].growth;
            return setRegionSize(document, marker,
                                 size.value ? std::optional(PartSize{*size.value, growth}) : std::nullopt);
        });
        return;
    }
    ui::rowTooltip(context,
                   "Maximum element size in these regions. Leave empty to use the size from the Spacing panel.");
}

} // namespace forefront
