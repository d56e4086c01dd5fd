#include "ui/editor/apply_settings.hpp"

#include "ui/parts/shell.hpp"

namespace forefront {

void applySettings(Shell &context) {
    const Settings &settings = context.settings;
    for (LayerSlot &slot : context.layers) {
        const auto known = settings.layers.find(slot.layer->id());
        if (known != settings.layers.end()) {
            slot.visible = known->second;
        }
    }
    context.view.panels = settings.panels;
    context.snapping = settings.snapping;
    for (const auto &[action, keys] : settings.keys) {
        context.actions.rebind(action, parseShortcut(keys));
    }
}

void collectSettings(Shell &context) {
    Settings &settings = context.settings;
    settings.layers.clear();
    for (const LayerSlot &slot : context.layers) {
        const bool visible =
            context.lessons.open ? context.lessons.open->layersBefore.at(slot.layer->id()) : slot.visible;
        if (visible != slot.layer->visibleAtStart()) {
            settings.layers[slot.layer->id()] = visible;
        }
    }
    settings.panels = context.view.panels;
    settings.snapping = context.snapping;
}

} // namespace forefront
