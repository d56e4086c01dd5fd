#include "ui/parts/context_menu.hpp"

#include "ui/parts/shell.hpp"

namespace forefront {

ContextItem copyCommand(std::string id, std::string title, std::string text, std::string detail) {
    const auto run = [text = std::move(text)](Shell &context) {
        context.platform.setClipboard(text);
        const bool single = text.find('\n') == std::string::npos;
        context.log.announce(single ? "Copied " + text : "Copied to the clipboard");
    };
    return commandOf(std::move(id), std::move(title), run, std::move(detail));
}

std::vector<ContextGroup> selectionMenu() {
    return {
        actionsOf({"edit.rename", "edit.setTag", "edit.setSize", "edit.selectBorder", "view.zoomSelection"}),
        actionsOf({"edit.cut", "edit.copy", "edit.paste", "edit.duplicate", "edit.delete"}),
        actionsOf(
            {"path.corner", "path.smooth", "path.symmetric", "path.line", "path.curve", "path.split", "path.join"}),
        actionsOf({"shape.transform", "shape.mirrorX", "shape.mirrorY", "shape.arrange", "shape.linearArray",
                   "shape.polarArray"}),
        actionsOf({"shape.constrain", "shape.dimension"}),
        actionsOf({"shape.fillet", "shape.chamfer", "shape.offset", "edit.union", "edit.difference", "edit.toPath"}),
        actionsOf({"shape.hide", "shape.isolate", "shape.lock", "shape.showAll", "shape.unlockAll", "edit.selectAll",
                   "view.fit"})};
}

} // namespace forefront
