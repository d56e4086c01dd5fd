#include "ui/parts/shown_panels.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/workspace/judging.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace forefront::shell {
namespace {

/// Returns the layers that can colour the mesh, as switches.
ContextGroup colourGroup(const Shell &context) {
    ContextGroup group;
    for (const LayerSlot &slot : context.layers) {
        if (slot.layer->coloursByValue()) {
            const auto choose = [id = std::string(slot.layer->id()), on = !slot.visible](Shell &c) {
                showLayer(c.layers, id, on);
                c.coloursBefore.reset(); // the user's own choice
            };
            group.push_back(switchOf(std::string("colour/") + slot.layer->id(),
                                     std::string("Colour by: ") + slot.layer->name(), slot.visible, choose));
        }
    }
    return group;
}

/// Returns the measures that the Quality layer can show, as switches.
ContextGroup measureGroup(const Shell &context) {
    ContextGroup group;
    for (const Measure measure : valuesOf<Measure>()) {
        const bool shown = context.view.field.empty() && !context.view.formula.any() && context.view.measure == measure;
        group.push_back(switchOf("measure/" + std::string(wordOf(measure)), infoOf(measure).name, shown,
                                 [measure](Shell &c) { chooseMeasure(c, measure); }));
    }
    return group;
}

ContextGroup limitsGroup(const Shell &context) {
    ContextGroup group{commandOf("limits", "Colour limits\xe2\x80\xa6", [](Shell &c) {
        showPanel(c, "histogram");
        c.widgets.fields.request("histogram/from");
    })};
    const View &view = context.view;
    group.push_back(switchOf("fitColours", "Fit range to the mesh", view.fitRange && !view.measureRange, [](Shell &c) {
        const bool fitted = c.view.fitRange && !c.view.measureRange;
        fitMeasureRange(c);
        c.view.fitRange = !fitted;
    }));
    const bool cividis = view.scale == QualityScale::Cividis;
    group.push_back(switchOf("cividis", "Colours: cividis", cividis, [cividis](Shell &c) {
        c.view.scale = cividis ? QualityScale::Alarm : QualityScale::Cividis;
        c.animate();
    }));
    return group;
}

} // namespace

bool openLegendMenu(Shell &context, Pixel pixel) {
    constexpr std::string_view kLegend = "canvas/legend/";
    const auto &all = context.widgets.all();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto &widget) {
        return widget.first.starts_with(kLegend) && widget.second.rect.contains(pixel);
    });
    if (found == all.end()) {
        return false;
    }
    const std::string layer = found->first.substr(kLegend.size());
    std::vector<ContextGroup> groups{colourGroup(context)};
    if (layer == "quality") {
        groups.push_back(measureGroup(context));
        groups.push_back(limitsGroup(context));
    }
    groups.push_back(
        {commandOf("hideLayer", "Hide this layer", [layer](Shell &c) { showLayer(c.layers, layer, false); })});
    groups.push_back(actionsOf({"file.exportPicture", "file.exportMoment", "file.export", "file.exportFilm"}));
    context.menu.open(std::move(groups));
    return true;
}

} // namespace forefront::shell
