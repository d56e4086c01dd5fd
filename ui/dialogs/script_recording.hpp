#pragma once

#include "core/drawing_files/script/script_recorder.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

namespace forefront {

class ActionRegistry;
struct MeshExport;
struct MeshSnapshot;
struct Shell;

/// Records what the user does to documents as a script for `forefront run`: see ScriptRecorder. Its file is written
/// after every step, so that a crash loses nothing. What a script cannot hold is said in the log when it happens.
class ScriptRecording {
  public:
    /// Returns true from start() until stop().
    bool active() const { return recorder_.has_value(); }
    /// Begins with the current document; the script goes to `file`. Faults: those of writing it.
    Diagnostics start(Shell &context, const std::filesystem::path &file);
    /// Records the finished mesh of the document with its hash, if there is one, and ends.
    void stop(Shell &context);
    /// Records what has happened since the last call. Called once per frame.
    void follow(Shell &context);
    std::size_t commands() const { return recorder_ ? recorder_->commands() : 0; }

  private:
    void followDocument(Shell &context);
    void followOthers(Shell &context);
    void record(Shell &context, const MeshExport &exported);
    std::filesystem::path inScript(const std::filesystem::path &file) const;
    void save(Shell &context);

    std::optional<ScriptRecorder> recorder_;
    std::filesystem::path file_;
    std::uint64_t loads_ = 0;              ///< see DocumentStore::loads()
    std::uint64_t fileUses_ = 0;           ///< see DocumentStore::fileUses()
    std::shared_ptr<const Document> last_; ///< recorded last
    const void *noted_ = nullptr;          ///< the dialog that was said to be left out
    std::size_t saved_ = 0;                ///< commands in the file
};

/// Registers the end of the File menu: the recording of a script, and Quit.
void addFileMenuEnd(ActionRegistry &actions, ScriptRecording &recording);

} // namespace forefront
