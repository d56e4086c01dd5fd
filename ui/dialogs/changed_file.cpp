#include "ui/dialogs/changed_file.hpp"

#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/question_dialog.hpp"
#include "ui/parts/shell.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

bool changedOnDisk(const Shell &context, const FileStamp &now) {
    const FileStamp &known = context.document.stamp();
    return known.known() && now.known() && !now.sameContent(known);
}

void askAboutChange(Shell &context, const FileStamp &now, std::function<void(Shell &)> then) {
    const std::string name = context.document.title();
    const bool missing = now.kind == FileStamp::Kind::Missing;
    std::vector<QuestionDialog::Answer> answers{{"cancel", "Cancel", false, {}}};
    if (!missing) {
        answers.push_back({"reload", "Reload", false, reloadDocument});
    }
    answers.push_back(
        {"overwrite", missing ? "Save" : "Overwrite", missing, [then](Shell &c) { overwriteDocument(c, then); }});
    answers.push_back({"saveAs", "Save as\xe2\x80\xa6", !missing, [then](Shell &c) { saveDocumentAs(c, then); }});
    const std::string text =
        missing ? "Another program has deleted or moved " + name + ". Save it there again?"
                : "Another program has changed " + name +
                      ". Overwrite loses its changes. Reload shows them in place of yours, which undo brings back.";
    context.dialogs.open(std::make_unique<QuestionDialog>(
        "changed", missing ? "The file was deleted" : "The file has changed on disk", text, std::move(answers)));
}

void reloadDocument(Shell &context) {
    const std::filesystem::path file = context.document.path();
    ImportNotes notes;
    Result<StampedDocument> read = readStamped(file, &notes);
    if (!read) {
        context.log.add(read.faults());
        return;
    }
    finishInput(context); // undo brings back what is being drawn, too
    context.document.replace(std::move(read->document), "Reload");
    context.document.markSaved(file, read->stamp);
    context.log.add(notes.diagnostics());
    context.log.announce("Reloaded " + context.document.title() + "; undo restores the previous drawing");
    context.animate();
}

void followFile(Shell &context) {
    if (context.watchedUse != context.document.fileUses()) {
        context.watchedUse = context.document.fileUses();
        if (context.document.path().empty() || !context.document.stamp().known()) {
            context.fileWatch.forget();
        } else {
            context.fileWatch.watch(context.document.path(), context.document.stamp());
        }
    }
    const std::optional<FileStamp> now = context.fileWatch.takeNews();
    if (!now || !changedOnDisk(context, *now)) {
        return;
    }
    const bool missing = now->kind == FileStamp::Kind::Missing;
    Diagnostic change{.severity = Severity::Warning,
                      .code = missing ? "file-deleted" : "file-changed",
                      .message = "another program has " + std::string(missing ? "deleted or moved " : "changed ") +
                                 context.document.title(),
                      .advice = missing ? "save the document to keep it" : "choose File > Reload to see the changes"};
    context.log.add(std::move(change));
    context.animate();
}

} // namespace forefront
