#include "ui/panels/measure_choice.hpp"

#include "ui/style/measure_colours.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/judging.hpp"
#include "ui/workspace/number_field.hpp"
#include "ui/workspace/workspace.hpp"

#include <imgui.h>

#include <memory>
#include <vector>

namespace forefront {

namespace {

constexpr float kRangeField = 48.0F; ///< width, design pixels

/// A field of the file, as an entry of the list of measures.
struct FieldChoice {
    MeshPart part;
    std::string name, label;
};

std::vector<FieldChoice> fieldChoices(const RunControl &run) {
    std::vector<FieldChoice> choices;
    const std::shared_ptr<const FileFields> fields = run.fields();
    if (fields) {
        for (const auto &[name, values] : fields->nodes) {
            choices.push_back({MeshPart::Nodes, name, name});
        }
        for (const auto &[name, values] : fields->elements) {
            const bool twice = fields->nodes.contains(name);
            choices.push_back({MeshPart::Elements, name, twice ? name + " (elements)" : name});
        }
    }
    return choices;
}

} // namespace

void drawMeasureChoice(Workspace &context, const std::string &name, float width) {
    std::vector<const char *> labels;
    for (const Measure measure : valuesOf<Measure>()) {
        labels.push_back(infoOf(measure).name);
    }
    const std::size_t measures = labels.size();
    auto choice = static_cast<int>(context.view.measure);
    const std::vector<FieldChoice> fields = fieldChoices(context.run);
    for (const FieldChoice &field : fields) {
        const bool shown = field.name == context.view.field && field.part == context.view.fieldPart;
        choice = shown ? static_cast<int>(labels.size()) : choice;
        labels.push_back(field.label.c_str());
    }
    if (context.view.formula.any()) { // of a lesson; to choose it again changes nothing
        choice = static_cast<int>(labels.size());
        labels.push_back(context.view.formula.name.c_str());
    }
    if (ui::combo(context, name, labels, choice, width)) {
        const auto chosen = static_cast<std::size_t>(choice);
        if (chosen < measures) {
            chooseMeasure(context, static_cast<Measure>(choice));
        } else if (chosen - measures < fields.size()) {
            chooseField(context, fields[chosen - measures].part, fields[chosen - measures].name);
        }
    }
    const std::string meaning = context.view.formula.any() ? "Values that the page of the lesson shows"
                                : context.view.field.empty()
                                    ? std::string(infoOf(context.view.measure).meaning)
                                    : "Values of the " + std::string(wordOf(context.view.fieldPart)) + "s in the file";
    ui::tooltip(context, meaning + "\nThe Quality layer shows it in colour");
}

void drawMeasureRange(Workspace &context, const Judgement &judgement, const std::string &prefix) {
    if (judgement.of.measure == Measure::Region) {
        return; // its colours have no order
    }
    ColourRange range = measureRange(context);
    const bool from = ui::inputNumber(context, prefix + "/from", range.from, kRangeField);
    ui::tooltip(context, "Start of the colour map");
    ImGui::SameLine(0, context.px(4));
    const bool to = ui::inputNumber(context, prefix + "/to", range.to, kRangeField);
    ui::tooltip(context, "End of the colour map");
    ImGui::SameLine(0, context.px(4));
    const bool fixed = !judgement.of.fieldValues && fixedRange(judgement.of.measure).has_value();
    const bool fitted = !context.view.measureRange && (context.view.fitRange || !fixed);
    if (ui::button(context, prefix + "/fit", fitted && fixed ? "Fixed" : "Fit", ui::ButtonKind::Plain,
                   !fitted || fixed)) {
        fitMeasureRange(context);
        context.view.fitRange = !fitted;
    }
    ui::tooltip(context, fitted ? "Show all meshes on the same range of colours" : "Fit the colours to the mesh");
    const MeasureInfo &info = judgement.info;
    const bool possible = range.from < range.to && range.from >= info.minimum && range.to <= info.maximum &&
                          (!info.logarithmic || range.from > 0.0);
    if ((from || to) && !possible) {
        ui::refuseCommand(context, {{.severity = Severity::Warning,
                                     .code = "bad-range",
                                     .message = "colour range " + ui::number(range.from) + " to " +
                                                ui::number(range.to) + " is not a range of " + judgement.name,
                                     .advice = "enter two numbers in increasing order"}});
    } else if (from || to) {
        context.view.measureRange = range;
        context.animate();
    }
}

} // namespace forefront
