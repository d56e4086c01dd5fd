#include "ui/parts/document_tabs.hpp"

#include "ui/parts/shell.hpp"
#include "ui/parts/shown_panels.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

void finishInput(Shell &context) {
    context.dialogs.dismissPreviews(context);
    if (Tool &tool = context.tools.current(); !tool.undoLabel(context).empty()) {
        tool.deactivate(context);
    }
    context.naming.close();
    context.dimensionEntry.close();
}

/// Takes the document shown out of the window, which shows an empty one until another is entered.
void DocumentTabs::leave(Shell &context) {
    finishInput(context);
    context.tools.current().deactivate(context); // a drag does not go on in another document
    context.rulerDrag.cancel(context);
    context.document.endStroke();
    if (context.adaptation.busy()) {
        context.log.inform("Adapting " + context.document.title() + " ended with the meshes made so far");
    }
    auto left = std::make_unique<LeftDocument>();
    left->meshColours = context.coloursBefore.has_value();
    restoreColours(context);
    left->view = context.view;
    left->selection = std::exchange(context.selection, {});
    left->workspace = context.presentedFrom.value_or(context.settings.workspace);
    left->exported = std::exchange(context.exported, {});
    left->document = context.document.leave();
    left->run = context.run.exchange(nullptr);
    left->adaptation = context.adaptation.exchange({});
    left->used = ++uses_;
    tabs_[active_].left = std::move(left);
    context.examiner.abandon();
    context.probe.chosen.reset();
    context.naming = {};
    context.fieldFault = {};
    context.entered = {};
    context.view.flag.reset();
    context.view.isolatedBin.reset();
    context.view.candidate.reset();
    context.view.following = false;
    context.animate();
}

/// Shows the document of a tab in place of the empty one that leave() has left.
void DocumentTabs::enter(std::size_t tab, Shell &context) {
    active_ = tab;
    LeftDocument left = std::move(*std::exchange(tabs_[tab].left, nullptr));
    const View before = context.view;
    context.document.enter(std::move(left.document));
    static_cast<void>(context.run.exchange(std::move(left.run)));
    static_cast<void>(context.adaptation.exchange(std::move(left.adaptation)));
    context.selection = std::move(left.selection);
    context.exported = std::move(left.exported);
    context.view = std::move(left.view);
    context.view.panels = before.panels;
    context.view.jumps = before.jumps; // the drawing appears in its place
    context.view.pointer = before.pointer;
    context.view.facePlace.reset();
    if (context.presentedFrom) { // the presentation goes on
        context.presentedFrom = left.workspace;
    } else if (context.settings.workspace != left.workspace && !context.lessons.open) {
        chooseWorkspace(context, left.workspace);
    }
    if (left.meshColours) {
        showMeshColours(context);
    }
    context.plates.start = false;
    if (!context.document.path().empty()) {
        std::error_code ignored;
        context.settings.lastFile =
            std::filesystem::absolute(context.document.path(), ignored).lexically_normal().string();
    }
    context.animate();
}

void DocumentTabs::open(Shell &context) {
    leave(context);
    context.document.giveName();
    ++active_;
    tabs_.insert(tabs_.begin() + static_cast<std::ptrdiff_t>(active_), Tab{++lastId_, nullptr});
    context.view.fitted.reset();
    context.view.fitPending = true;
}

void DocumentTabs::show(std::size_t tab, Shell &context) {
    if (tab != active_ && tab < tabs_.size()) {
        leave(context);
        enter(tab, context);
    }
}

void DocumentTabs::close(std::size_t tab, Shell &context) {
    if (tab == active_) {
        const std::size_t next = tab + 1 < tabs_.size() ? tab + 1 : tab - 1;
        show(next, context);
    }
    const std::filesystem::path file = tabs_[tab].left->document.path;
    std::error_code ignored;
    if (!file.empty() && context.document.path() != file &&
        context.settings.lastFile == std::filesystem::absolute(file, ignored).lexically_normal().string()) {
        context.settings.lastFile.clear(); // a document that was closed does not come back at the next start
    }
    context.run.drop(std::move(tabs_[tab].left->run));
    tabs_.erase(tabs_.begin() + static_cast<std::ptrdiff_t>(tab));
    active_ -= tab < active_ ? 1 : 0;
    context.animate();
}

void DocumentTabs::limitMemory(Shell &context, std::size_t most) {
    for (;;) {
        std::size_t elements = 0;
        LeftDocument *oldest = nullptr;
        for (const Tab &tab : tabs_) {
            const std::size_t own = tab.left ? tab.left->run->elements() : 0;
            elements += own;
            const bool rests = own > 0 && !tab.left->run->session.busy(); // what is being made goes on
            if (rests && (oldest == nullptr || tab.left->used < oldest->used)) {
                oldest = tab.left.get();
            }
        }
        if (elements <= most || oldest == nullptr) {
            return;
        }
        context.run.drop(std::exchange(oldest->run, context.run.withoutMesh(*oldest->run)));
    }
}

TabCaption captionOf(const Shell &context, std::size_t tab) {
    if (const auto &left = context.tabs.at(tab).left) {
        return {left->document.name(), left->document.path, left->document.history.dirty()};
    }
    return {context.document.title(), context.document.path(), context.document.dirty()};
}

bool isBlank(const Shell &context) {
    return context.document.path().empty() && !context.document.dirty() && context.document.history().size() == 1 &&
           context.document.current()->shapes.empty() && !context.run.showsFile();
}

} // namespace forefront
