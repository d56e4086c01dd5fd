#include "ui/dialogs/recovery.hpp"

#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/files/files.hpp"
#include "ui/dialogs/recovery_dialog.hpp"
#include "ui/dialogs/tab_commands.hpp"
#include "ui/parts/shell.hpp"
#include "ui/platform/steady_seconds.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <ctime>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace forefront {

namespace {

constexpr double kLookEvery = 1.0, kLookFor = 30.0; // seconds

std::string timeText(std::time_t time) {
    std::tm parts{};
    char buffer[32] = "";
    if (::localtime_r(&time, &parts) != nullptr) {
        static_cast<void>(std::strftime(buffer, sizeof buffer, "%Y-%m-%d %H:%M:%S", &parts));
    }
    return buffer;
}

/// Returns the name of the file, or the title of a document that was never saved.
std::string nameOf(const OrphanedJournal &orphan) {
    if (!orphan.savedAt().empty()) {
        return orphan.savedAt().filename().string();
    }
    return (orphan.title().empty() ? std::string("Untitled") : orphan.title()) + " (never saved)";
}

/// Returns the number of shapes in a journal, such as "3 shapes, "; nothing if it cannot be read.
std::string shapesText(const OrphanedJournal &orphan) {
    constexpr std::size_t kLongText = 16'000'000; // takes more than a moment to read
    if (orphan.text().size() > kLongText) {
        return {};
    }
    const Result<Document> document = parseProject(orphan.text(), orphan.file().string());
    if (!document) {
        return {};
    }
    const std::size_t count = document->shapes.size();
    return ui::count(count) + (count == 1 ? " shape, " : " shapes, ");
}

} // namespace

Recovery::Recovery(const std::filesystem::path &folder) : folder_(folder / "recovery") {}

Recovery::Journalled::Journalled(const std::filesystem::path &folder) : journal(folder, projectText) {}

/// Takes the journals that were left behind, and returns the number of those that are locked.
std::size_t Recovery::collect(Shell &context) {
    std::size_t locked = 0;
    for (OrphanedJournal &journal : findOrphanedJournals(folder_, &locked)) {
        context.document.reserveTitle(journal.title());
        std::string name = nameOf(journal), details = shapesText(journal) + timeText(journal.written());
        orphans_.push_back({std::move(journal), std::move(name), std::move(details)});
    }
    publish(context);
    return locked;
}

void Recovery::offer(Shell &context) {
    if (collect(context) > 0) {
        nextLook_ = steadySeconds() + kLookEvery;
        lastLook_ = steadySeconds() + kLookFor;
    }
    if (!orphans_.empty()) {
        context.dialogs.open(std::make_unique<RecoveryDialog>(*this));
    }
}

/// A program that was killed holds its lock until the system has taken back its memory, which may take seconds: looks
/// for journals that have become free, until the user has drawn something.
void Recovery::lookAgain(Shell &context) {
    const double now = steadySeconds();
    const bool drawn =
        std::any_of(journals_.begin(), journals_.end(), [](const auto &each) { return each.second.dirty; });
    if (now > lastLook_ || drawn || context.dialogs.any()) {
        return;
    }
    context.wakeAt(context.platform.now() + kLookEvery);
    if (now < nextLook_) {
        return;
    }
    nextLook_ = now + kLookEvery;
    const std::size_t before = orphans_.size();
    collect(context);
    if (orphans_.size() > before) {
        lastLook_ = 0.0;
        context.dialogs.open(std::make_unique<RecoveryDialog>(*this));
    }
}

void Recovery::publish(Shell &context) {
    context.unsaved.clear();
    for (const Orphan &orphan : orphans_) {
        const std::filesystem::path file = orphan.journal.file();
        const auto open = [this, file](Shell &c) {
            const auto at = std::find_if(orphans_.begin(), orphans_.end(),
                                         [&file](const Orphan &each) { return each.journal.file() == file; });
            if (at != orphans_.end()) {
                recover(static_cast<std::size_t>(at - orphans_.begin()), c);
            }
        };
        context.unsaved.push_back({orphan.name, orphan.details, file, orphan.journal.text(), open});
    }
    context.animate();
}

namespace {

/// Returns the document with the path that is being drawn as an open shape.
std::shared_ptr<const Document> withPath(const std::shared_ptr<const Document> &document, Shape path) {
    path.name = "Unfinished path";
    Result<Document> whole = addShape(*document, std::move(path));
    return whole ? std::make_shared<const Document>(*std::move(whole)) : document;
}

} // namespace

Recovery::Now Recovery::documentOf(const Shell &context, std::size_t tab) {
    if (const auto &left = context.tabs.at(tab).left) {
        const OpenDocument &open = left->document;
        return {open.history.shared(),
                open.revision(),
                open.history.dirty(),
                std::nullopt,
                {open.path, open.name(), open.stamp.hash}};
    }
    const DocumentStore &store = context.document;
    return {store.current(),
            store.revision(),
            store.dirty(),
            context.tools.current().unfinished(),
            {store.path(), store.title(), store.stamp().hash}};
}

void Recovery::record(std::uint64_t tab, Now now) {
    auto known = journals_.find(tab);
    if (known == journals_.end()) {
        if (!now.dirty && !now.path) {
            return; // nothing could be lost
        }
        known = journals_.try_emplace(tab, folder_).first;
    }
    Journalled &last = known->second;
    if (now.revision == last.revision && now.dirty == last.dirty && now.path == last.path) {
        return;
    }
    last.revision = now.revision;
    last.dirty = now.dirty;
    last.path = now.path;
    if (now.path) { // pulled in every frame, but rarely written
        last.journal.record(
            [document = now.document, drawn = *std::move(now.path)] { return withPath(document, drawn); }, now.place);
    } else if (now.dirty) {
        last.journal.record(now.document, now.place);
    } else {
        last.journal.recordSaved();
    }
}

/// Removes the journals of tabs that are not open. One that is being written is removed later, since its destructor
/// would wait for it.
void Recovery::close(const std::set<std::uint64_t> &open) {
    for (auto each = journals_.begin(); each != journals_.end();) {
        const auto next = std::next(each);
        if (!open.contains(each->first)) {
            if (!each->second.journal.resting()) {
                each->second.journal.recordSaved();
            }
            closed_.push_back(journals_.extract(each));
        }
        each = next;
    }
    std::erase_if(closed_, [](const Journals::node_type &node) { return node.mapped().journal.resting(); });
}

void Recovery::follow(Shell &context) {
    std::set<std::uint64_t> open;
    for (std::size_t tab = 0; tab < context.tabs.size(); ++tab) {
        const std::uint64_t id = context.tabs.at(tab).id;
        open.insert(id);
        record(id, documentOf(context, tab));
    }
    close(open);
    for (auto &[id, journalled] : journals_) {
        context.log.add(journalled.journal.takeFaults());
    }
    lookAgain(context);
}

/// Shows what a recovered document takes the place of.
void Recovery::makeRoom(const OrphanedJournal &journal, Shell &context) {
    const bool shown = !journal.savedAt().empty() && showTabOf(context, journal.savedAt());
    if (!shown || context.document.dirty()) {
        freshTab(context);
    }
}

bool Recovery::recover(std::size_t orphan, Shell &context) {
    const OrphanedJournal &journal = orphans_[orphan].journal;
    Result<Document> document = parseProject(journal.text(), journal.file().string());
    if (!document) {
        context.log.add(document.faults());
        return false;
    }
    FileStamp stamp; // by which changes since the crash are found
    if (journal.savedHash() != 0) {
        stamp.kind = FileStamp::Kind::File;
        stamp.hash = journal.savedHash();
    }
    makeRoom(journal, context);
    context.document.load(std::move(document).value(), journal.savedAt(), true, journal.title(), stamp);
    context.selection.clear();
    context.run.clear();
    restoreColours(context);
    context.view.fitPending = true;
    follow(context);
    journals_.at(context.tabs.at(context.tabs.active()).id).journal.flush();
    discard(orphan, context);
    context.log.announce("Recovered unsaved changes; save the document to keep them");
    return true;
}

bool Recovery::recoverAll(Shell &context) {
    for (std::size_t k = 0; k < orphans_.size();) {
        k += recover(k, context) ? 0 : 1;
    }
    return orphans_.empty();
}

void Recovery::discard(std::size_t orphan, Shell &context) {
    orphans_[orphan].journal.discard();
    orphans_.erase(orphans_.begin() + static_cast<std::ptrdiff_t>(orphan));
    publish(context);
}

} // namespace forefront
