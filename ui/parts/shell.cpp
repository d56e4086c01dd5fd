#include "ui/parts/shell.hpp"

namespace forefront {

void ToolBox::choose(std::string_view id, Shell &context) {
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (tools[i]->id() == id && i != active) {
            current().deactivate(context);
            active = i;
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

void cancelTask(Shell &context) {
    if (context.task.busy()) {
        context.log.announce("Cancelled " + context.task.purpose());
        context.task.cancel();
    }
}

} // namespace forefront
