#include "ui/dialogs/script_recording.hpp"

#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/files.hpp"
#include "core/files/text/atomic_file.hpp"
#include "ui/dialogs/export_dialog.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/tab_commands.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Returns the finished mesh of the current document, or null if it has none.
std::shared_ptr<const MeshSnapshot> recordableMesh(const Shell &context) {
    const SessionSnapshot &run = context.run.now();
    const bool finished = run.complete && run.state == RunState::Finished && run.mesh && !context.run.preview() &&
                          !context.run.outOfDate() && !context.run.showsFile();
    return finished ? run.mesh : nullptr;
}

/// A dialog whose result no script can hold.
struct LeftOut {
    std::string_view dialog; ///< its id
    const char *what;
};
constexpr std::array kLeftOut{LeftOut{"film", "films"}, LeftOut{"moment", "pictures of moments"},
                              LeftOut{"saverules", "files of rules"}};

Status writeScript(const std::filesystem::path &file, const ScriptRecorder &recorder) {
    if (Status fault = notRegular(file); !fault.empty()) {
        return fault;
    }
    return writeFileAtomically(file, recorder.text());
}

} // namespace

Diagnostics ScriptRecording::start(Shell &context, const std::filesystem::path &file) {
    std::error_code failed;
    const std::filesystem::path whole = std::filesystem::absolute(file, failed);
    ScriptRecorder recorder(context.document.current());
    if (Status faults = writeScript(failed ? file : whole, recorder); !faults.empty()) {
        return faults;
    }
    recorder_ = std::move(recorder);
    file_ = failed ? file : whole;
    loads_ = context.document.loads();
    fileUses_ = context.document.fileUses();
    last_ = context.document.current();
    context.written.reset();
    noted_ = nullptr;
    saved_ = recorder_->commands();
    context.log.announce("Recording a script to " + file_.filename().string() + "; File > Stop recording ends it");
    return {};
}

void ScriptRecording::stop(Shell &context) {
    follow(context);
    if (!active()) {
        return; // the file could not be written
    }
    const std::shared_ptr<const MeshSnapshot> mesh = recordableMesh(context);
    if (mesh && last_ == context.document.current()) {
        recorder_->recordMesh(meshHash(mesh->view()));
    }
    save(context);
    if (active()) {
        context.log.announce("Saved the script to " + file_.string() + ": " + ui::count(recorder_->commands()) +
                             " commands; repeat them with forefront run");
        recorder_.reset();
    }
}

void ScriptRecording::follow(Shell &context) {
    const std::shared_ptr<const MeshExport> written = std::exchange(context.written, nullptr);
    context.recordedScript = active() ? file_.filename().string() : std::string();
    if (!active()) {
        return;
    }
    if (written) {
        record(context, *written);
    }
    followOthers(context);
    if (!ImGui::IsAnyMouseDown()) { // a drag is recorded as one step
        followDocument(context);
    }
    if (recorder_->commands() != saved_) {
        save(context);
    }
}

void ScriptRecording::followDocument(Shell &context) {
    const DocumentStore &store = context.document;
    const std::shared_ptr<const Document> now = store.current();
    if (store.loads() != loads_) {
        recorder_->load(now);
        loads_ = store.loads();
        fileUses_ = store.fileUses();
    } else if (now != last_) {
        recorder_->record(now);
    }
    last_ = now;
    if (store.fileUses() != fileUses_) {
        fileUses_ = store.fileUses();
        recorder_->recordSave(inScript(store.path()));
    }
}

/// Returns the path of a file as the script has it: relative to its folder if the file lies there or below, so that a
/// copy of the folder works alone; else the full path.
std::filesystem::path ScriptRecording::inScript(const std::filesystem::path &file) const {
    std::error_code failed;
    const std::filesystem::path whole = std::filesystem::absolute(file, failed).lexically_normal();
    if (failed) {
        return file;
    }
    const std::filesystem::path relative = whole.lexically_relative(file_.parent_path().lexically_normal());
    return relative.empty() || *relative.begin() == ".." ? whole : relative;
}

void ScriptRecording::record(Shell &context, const MeshExport &exported) {
    followDocument(context);
    const auto refuse = [&](const char *reason) {
        context.log.refuse("the export of " + exported.file.filename().string() + " is not in the script: " + reason);
    };
    if (exported.choice.innerEdges == InnerEdges::Drop && acceptsInnerEdges(exported.file, exported.format)) {
        refuse("scripts write meshes with their tagged edges inside the domain");
    } else if (recordableMesh(context) != exported.mesh) {
        refuse("its mesh is not that of the drawing as it is now");
    } else {
        std::vector<std::string> open;
        for (const auto &[tag, name] : exported.choice.open) {
            open.push_back(name);
        }
        recorder_->recordExport(inScript(exported.file), exported.format, meshHash(exported.mesh->view()), open,
                                exported.choice.elevation);
    }
}

/// Says once for each dialog that its result is left out.
void ScriptRecording::followOthers(Shell &context) {
    const Dialog *const top = context.dialogs.top();
    if (top == noted_) {
        return;
    }
    noted_ = top;
    for (const LeftOut &left : kLeftOut) {
        if (top != nullptr && left.dialog == top->id()) {
            context.log.inform(std::string("Not recorded in the script: ") + left.what);
        }
    }
}

/// Ends the recording if its file cannot be written.
void ScriptRecording::save(Shell &context) {
    saved_ = recorder_->commands();
    if (Status faults = writeScript(file_, *recorder_); !faults.empty()) {
        context.log.add(faults);
        context.log.refuse("the recording of the script has ended: " + file_.filename().string() +
                           " cannot be written");
        recorder_.reset();
    }
}

namespace {

void askForScript(Shell &context, ScriptRecording &recording) {
    FileRequest request;
    request.id = "recordscript";
    request.title = "Record script";
    request.action = "Record";
    request.saves = true;
    request.filters = {{"Script of commands (.jsonl)", {".jsonl"}, "script"}};
    request.folder = startFolder(context);
    request.name = "script.jsonl";
    request.chosen = [&recording](Shell &c, const std::filesystem::path &file, const FileFilter &) {
        return recording.start(c, file);
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

} // namespace

void addFileMenuEnd(ActionRegistry &actions, ScriptRecording &recording) {
    actions.add({.id = "file.recordScript",
                 .menu = "File",
                 .title = "Record script\xe2\x80\xa6",
                 .run = [&recording](Shell &c) { recording.active() ? recording.stop(c) : askForScript(c, recording); },
                 .dynamic =
                     [&recording](const Shell &) {
                         return recording.active() ? "Stop recording (" + ui::count(recording.commands()) + " commands)"
                                                   : std::string("Record script\xe2\x80\xa6");
                     },
                 .separatorBefore = true});
    actions.add({.id = "file.quit",
                 .menu = "File",
                 .title = "Quit",
                 .shortcuts = {{'Q', kControl}},
                 .run =
                     [&recording](Shell &c) {
                         afterAllUnsaved(c, [&recording](Shell &d) {
                             if (recording.active()) {
                                 recording.stop(d);
                             }
                             d.quit = true;
                         });
                     },
                 .separatorBefore = true});
}

} // namespace forefront
