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

Settings settingsToSave(const Shell &context) {
    Settings settings = context.settings;
    const std::optional<OpenLesson> &lesson = context.lessons.open;
    settings.layers.clear();
    for (const LayerSlot &slot : context.layers) {
        const bool coloured = context.coloursBefore && slot.layer->coloursByValue();
        const bool visible = lesson     ? lesson->layersBefore.at(slot.layer->id())
                             : coloured ? slot.layer->id() == *context.coloursBefore
                                        : slot.visible;
        if (visible != slot.layer->visibleAtStart()) {
            settings.layers[slot.layer->id()] = visible;
        }
    }
    settings.panels = lesson ? lesson->panelsBefore : context.view.panels;
    settings.tab = lesson ? lesson->tabBefore : settings.tab;
    settings.snapping = context.snapping;
    return settings;
}

} // namespace forefront
