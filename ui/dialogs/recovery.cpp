#include "ui/dialogs/recovery.hpp"

#include "core/drawing_files/project/project.hpp"
#include "core/files/files.hpp"
#include "ui/dialogs/recovery_dialog.hpp"
#include "ui/parts/shell.hpp"

namespace forefront {

Recovery::Recovery(const std::filesystem::path &folder)
    : folder_(folder / "recovery"), journal_(folder / "recovery", projectText) {}

void Recovery::offer(Shell &context) {
    std::vector<OrphanedJournal> orphans = findOrphanedJournals(folder_);
    for (const OrphanedJournal &orphan : orphans) {
        context.document.reserveTitle(orphan.title());
    }
    if (!orphans.empty()) {
        context.dialogs.open(std::make_unique<RecoveryDialog>(*this, std::move(orphans)));
    }
}

void Recovery::follow(Shell &context) {
    const std::uint64_t revision = context.document.revision();
    const bool dirty = context.document.dirty();
    if (revision != revision_ || dirty != dirty_) {
        if (dirty) {
            journal_.record(context.document.current(),
                            {context.document.path(), context.document.title(), context.document.stamp().hash});
        } else {
            journal_.recordSaved();
        }
        revision_ = revision;
        dirty_ = dirty;
    }
    context.log.add(journal_.takeFaults());
}

bool Recovery::recover(OrphanedJournal &orphan, Shell &context) {
    Result<Document> document = parseProject(orphan.text(), orphan.file().string());
    if (!document) {
        context.log.add(document.faults());
        return false;
    }
    FileStamp stamp; // by which changes since the crash are found
    if (orphan.savedHash() != 0) {
        stamp.kind = FileStamp::Kind::File;
        stamp.hash = orphan.savedHash();
    }
    context.document.load(std::move(document).value(), orphan.savedAt(), true, orphan.title(), stamp);
    context.selection.clear();
    context.run.clear();
    restoreColours(context);
    context.view.fitPending = true;
    follow(context);
    journal_.flush();
    orphan.discard();
    context.log.announce("Recovered unsaved changes; save the document to keep them");
    return true;
}

} // namespace forefront
