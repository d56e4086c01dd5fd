#include "ui/parts/shell.hpp"

#include <utility>

namespace forefront {

void ToolBox::choose(std::string_view id, Shell &context) {
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (tools[i]->id() == id && i != active) {
            current().deactivate(context);
            std::erase(left, active);
            left.push_back(active);
            active = i;
            context.probe.follow(0); // what was chosen ends with the tool
            current().activate(context);
            context.animate();
            return;
        }
    }
}

void ToolBox::followDocument(Shell &context) {
    if (loads_ != context.document.loads()) {
        loads_ = context.document.loads();
        for (const std::unique_ptr<Tool> &tool : tools) {
            tool->forget(context);
        }
        choose("select", context);
    }
}

LayerSlot *Shell::layer(std::string_view id) {
    for (LayerSlot &slot : layers) {
        if (slot.layer->id() == id) {
            return &slot;
        }
    }
    return nullptr;
}

void showMeshColours(Shell &context) {
    if (!context.coloursBefore) {
        context.coloursBefore.emplace();
        for (const LayerSlot &slot : context.layers) {
            if (slot.visible && slot.layer->coloursByValue()) {
                context.coloursBefore = slot.layer->id();
            }
        }
    }
    showLayer(context.layers, "quality", true);
}

void restoreColours(Shell &context) {
    if (const std::optional<std::string> before = std::exchange(context.coloursBefore, std::nullopt)) {
        showLayer(context.layers, "quality", false);
        showLayer(context.layers, *before, true);
    }
}

void cancelTask(Shell &context) {
    if (context.task.busy()) {
        context.log.announce("Cancelled " + context.task.purpose());
        context.task.cancel();
    }
}

} // namespace forefront
