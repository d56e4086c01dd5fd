#include "ui/panels/part_rows.hpp"

#include "core/drawing/names/part_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/panels/form.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/enum_choice.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace forefront {

namespace {

void applyLayers(Shell &context, const BoundaryPart &part, const LayerSpec &spec) {
    context.applyCommand(setLayers(*context.document.current(), part, spec), "Change boundary layers");
}

/// Draws the number and the height of all layers, of which one at most is given.
void extentRow(Shell &context, const BoundaryPart &part, LayerSpec spec) {
    form::label(context, "Count, height");
    std::optional<double> count = spec.count ? std::optional<double>(*spec.count) : std::nullopt;
    const char *const hint = spec.thickness ? "" : "as needed";
    const bool counted = form::optionalField(context, "inspector/layers/count", count, hint, form::halfWidth(context));
    ui::rowTooltip(context, "Number of layers, or the height of all of them. Leave both empty for layers until their "
                            "elements are as high as they are long.");
    ImGui::SameLine(0, context.px(6));
    const bool heightened =
        form::optionalField(context, "inspector/layers/thickness", spec.thickness, spec.count ? "" : "as needed");
    if (counted && count && !ui::checkWhole(context, "inspector/layers/count", *count, 1.0, kMaxLayers)) {
        return;
    }
    if (counted) {
        spec.count = count ? std::optional(static_cast<std::uint32_t>(*count)) : std::nullopt;
        spec.thickness = count ? std::nullopt : spec.thickness;
        applyLayers(context, part, spec);
    } else if (heightened) {
        spec.count = spec.thickness ? std::nullopt : spec.count;
        applyLayers(context, part, spec);
    }
}

void layerRows(Shell &context, std::int32_t tag, const BoundaryPart &part) {
    const Document &document = *context.document.current();
    const LayerSpec *const given = layersOf(document, tag);
    LayerSpec spec = given != nullptr ? *given : LayerSpec();
    std::optional<double> first = given != nullptr ? std::optional(spec.first) : std::nullopt;
    form::label(context, "Layers, growth");
    const bool entered =
        form::optionalField(context, "inspector/layers/first", first, "none", form::halfWidth(context));
    ui::rowTooltip(context, "Boundary layers: the height of the first row of thin elements along the part, and how "
                            "many times as high each next row is. Leave empty for none.");
    ImGui::SameLine(0, context.px(6));
    ImGui::BeginDisabled(given == nullptr); // growth has no meaning without layers
    const bool grown = ui::inputNumber(context, "inspector/layers/growth", spec.growth, -1.0F);
    ImGui::EndDisabled();
    if (entered && first) {
        spec.first = *first;
        applyLayers(context, part, spec);
        return;
    }
    if (entered && given != nullptr) {
        context.applyCommand(setLayers(document, part, std::nullopt), "Remove boundary layers");
        return;
    }
    if (given == nullptr) {
        return;
    }
    if (grown) {
        applyLayers(context, part, spec);
        return;
    }
    extentRow(context, part, spec);
    form::label(context, "Layers of");
    if (ui::segmented(context, "inspector/layers/cells", spec.cells)) {
        applyLayers(context, part, spec);
    }
}

/// Returns the tags of boundaries, ascending.
std::vector<std::int32_t> boundaryPartsOf(const Document &document) {
    std::set<std::int32_t> tags;
    for (const auto &shape : document.shapes) {
        if (shape->use != ShapeUse::Boundary || shape->construction) {
            continue;
        }
        for (std::uint32_t k = 0; k < taggedSegments(*shape); ++k) {
            tags.insert(segmentTag(*shape, k));
        }
    }
    return {tags.begin(), tags.end()};
}

void crackRow(Shell &context, std::int32_t tag, const BoundaryPart &part) {
    bool cracks = isCrack(*context.document.current(), tag);
    form::label(context, "Crack");
    if (ui::checkbox(context, "inspector/crack", "Two sides", cracks)) {
        context.applyCommand(setCrack(*context.document.current(), part, cracks),
                             cracks ? "Make crack" : "Close crack");
    }
    ui::rowTooltip(context, "The mesh is open along the line: each side has nodes of its own, except where the line "
                            "ends inside the domain.");
}

/// Draws the width of a strip along a line, its rows and the shapes of its elements.
void stripRow(Shell &context, std::int32_t tag, const BoundaryPart &part) {
    const Document &document = *context.document.current();
    const StripSpec *const given = stripOf(document, tag);
    StripSpec spec = given != nullptr ? *given : StripSpec();
    std::optional<double> width = given != nullptr ? std::optional(spec.width) : std::nullopt;
    form::label(context, "Strip, rows");
    const bool entered = form::optionalField(context, "inspector/strip/width", width, "none", form::halfWidth(context));
    ui::rowTooltip(context, "Width of a strip along the line, half of it on either side, and the rows of elements that "
                            "fill it. Leave empty for none.");
    ImGui::SameLine(0, context.px(6));
    ImGui::BeginDisabled(given == nullptr); // rows have no meaning without a width
    double rows = spec.rows;
    const bool changed = ui::inputNumber(context, "inspector/strip/rows", rows, -1.0F);
    ImGui::EndDisabled();
    if (entered && !width && given != nullptr) {
        context.applyCommand(setStrip(document, part, std::nullopt), "Remove strip");
        return;
    }
    if (changed && !ui::checkWhole(context, "inspector/strip/rows", rows, 1.0, kMaxStripRows)) {
        return;
    }
    bool shaped = false;
    if (given != nullptr) {
        form::label(context, "Strip of");
        shaped = ui::segmented(context, "inspector/strip/cells", spec.cells);
    }
    if ((entered && width) || changed || shaped) {
        spec.width = width.value_or(spec.width);
        spec.rows = static_cast<std::uint32_t>(rows);
        context.applyCommand(setStrip(document, part, spec), "Change strip");
    }
}

} // namespace

void PartRows::drawPeriodic(Shell &context, std::int32_t tag, const BoundaryPart &part) {
    const Document &document = *context.document.current();
    if (revision_ != context.document.revision()) {
        revision_ = context.document.revision();
        parts_ = boundaryPartsOf(document);
    }
    std::vector<std::int32_t> others = parts_;
    std::erase(others, tag);
    const std::optional<std::int32_t> partner = periodicPartner(document, tag);
    if (others.empty() && !partner) {
        return;
    }
    std::vector<std::string> names{"no other part"};
    int choice = 0;
    for (const std::int32_t other : others) {
        if (partner == other) {
            choice = static_cast<int>(names.size());
        }
        names.push_back(boundaryName(document.boundaryNames, other));
    }
    form::label(context, "Periodic with");
    const bool changed = ui::combo(context, "inspector/periodic", names, choice);
    ui::rowTooltip(context, "Both parts are divided alike: one is the other, moved or turned, and each node of one has "
                            "a partner on the other.");
    if (changed) {
        const std::optional<std::int32_t> wanted =
            choice > 0 ? std::optional(others[static_cast<std::size_t>(choice) - 1]) : std::nullopt;
        context.applyCommand(setPeriodic(document, part, wanted), "Change periodic part");
    }
}

void PartRows::drawBoundary(Shell &context, std::int32_t tag, const BoundaryPart &part) {
    const Document &document = *context.document.current();
    const bool sizes = context.settings.workspace == WorkspaceKind::Size;
    if (sizes || layersOf(document, tag) != nullptr) {
        layerRows(context, tag, part);
    }
    if (sizes || periodicPartner(document, tag)) {
        drawPeriodic(context, tag, part);
    }
}

void PartRows::drawLine(Shell &context, std::int32_t tag, const BoundaryPart &part) {
    crackRow(context, tag, part);
    stripRow(context, tag, part);
}

void regionElementsRow(Shell &context, std::int32_t region) {
    const Document &document = *context.document.current();
    const std::optional<Elements> own = elementsOf(document, region);
    static const std::vector<const char *> kLabels = [] {
        std::vector<const char *> labels{"As the rest"};
        std::ranges::copy(ui::enumLabels<Elements>(), std::back_inserter(labels));
        return labels;
    }();
    int choice = own ? 1 + static_cast<int>(*own) : 0;
    form::label(context, "Elements");
    if (ui::combo(context, "inspector/elements", kLabels, choice)) {
        const std::optional<Elements> chosen =
            choice > 0 ? std::optional(static_cast<Elements>(choice - 1)) : std::nullopt;
        context.applyCommand(setElements(document, region, chosen), "Change elements of region");
    }
    ui::rowTooltip(context, "The elements of this region; they fit those beside it. The rest has those of the panel "
                            "Meshing.");
}

} // namespace forefront
