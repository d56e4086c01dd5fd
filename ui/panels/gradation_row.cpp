#include "ui/panels/gradation_row.hpp"

#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/engine/base/number_text.hpp"
#include "ui/panels/form.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace forefront {
namespace {

constexpr double kGentlest = 0.02, kSteepest = 1.0; ///< ends of the slider, which is logarithmic
constexpr double kUsual = 0.25;                     ///< shown by the knob where none is given

double knobOf(double gradation) {
    return std::clamp(std::log(gradation / kGentlest) / std::log(kSteepest / kGentlest), 0.0, 1.0);
}

/// The number of elements that the estimate predicts; empty texts while it is unknown.
struct Prediction {
    std::string brief; ///< fits beside the slider: "3 000 △", "130 k △", "1.3 M △"
    std::string whole; ///< as in the status bar
};

Prediction predictionOf(double elements) {
    if (!(elements >= 1.0)) {
        return {};
    }
    const double rounded = roundedTo(elements, 2);
    const std::string whole = ui::count(static_cast<std::size_t>(rounded));
    const std::string brief = rounded < 1e5   ? whole
                              : rounded < 1e6 ? ui::number(1e-3 * rounded, 3) + " k"
                                              : ui::number(1e-6 * rounded, 3) + " M";
    return {brief + " \xe2\x96\xb3", whole};
}

} // namespace

void GradationRow::draw(Shell &context) {
    std::optional<double> gradation = context.document.current()->spacing.gradation;
    form::label(context, "Gradation");
    constexpr float kField = 58.0F;
    if (form::optionalField(context, "spacing/gradation", gradation, "auto", kField,
                            NumberAddress{NumberOwner::ofSpacing(), Quantity::Gradation})) {
        context.applyCommand(setGradation(*context.document.current(), gradation), "Change gradation");
    }
    ui::rowTooltip(context, "Maximum change of \xcf\x81 per unit of length: 0.1 is gentle, 0.3 is steep. auto: 0.25 "
                            "where sizes spread from "
                            "the boundary, regions and paint, 0.5 for expressions and background meshes");
    ImGui::SameLine(0, context.px(6));
    drawSlider(context);
}

void GradationRow::drawSlider(Shell &context) {
    const std::optional<double> given = context.document.current()->spacing.gradation;
    double knob = knobOf(given.value_or(kUsual));
    constexpr float kPrediction = 62.0F;
    const float width = ImGui::GetContentRegionAvail().x / context.scale - kPrediction;
    const Prediction predicted = predictionOf(context.preview->estimatedElements);
    const bool moved =
        ui::thinSlider(context, "spacing/gradation/slider", knob, predicted.brief, std::max(24.0F, width), kPrediction);
    ui::tooltip(context, "Predicted number of elements" + (predicted.whole.empty() ? "" : ": " + predicted.whole) +
                             ". Drag the slider: the node spacing and the live mesh follow.");
    drag_.follow(context, moved, [&](const char *stroke) {
        const double gradation = roundedTo(kGentlest * std::pow(kSteepest / kGentlest, knob), 2);
        if (given == gradation) {
            return false;
        }
        context.applyCommand(setGradation(*context.document.current(), gradation), "Change gradation", stroke);
        return true;
    });
}

} // namespace forefront
