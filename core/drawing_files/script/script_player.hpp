#pragma once

#include "core/drawing/document/history.hpp"
#include "core/drawing_files/script/script.hpp"
#include "core/engine/base/result.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace forefront {

/// Carries out the commands of a script that change the document, with the history that its undo needs. Commands that
/// mesh and write files are left to the caller.
class ScriptPlayer {
  public:
    const Document &document() const { return history_.document(); }
    std::size_t position() const { return history_.position(); }
    /// Begins with another document and an empty history.
    void load(Document document) { history_ = History(std::move(document), "Open"); }
    /// Carries out a command other than open, mesh, check, export and save. On an error the document stays as it is.
    /// Faults, each with the line and column of the command or its member in `source`: those of the command in
    /// core/drawing, of the project reader, bad-value and nothing-to-undo.
    Status play(const ScriptCommand &command, const SourceText &source);

  private:
    Status walk(const ScriptCommand &command, const SourceText &source);

    History history_;
};

/// Returns true for a command that ScriptPlayer::play() carries out.
bool editsDocument(ScriptWord word);

/// Gives faults without a file the place of a command. Faults of another file keep their own; the last of them is then
/// followed by a note that names the command.
Diagnostics placedAt(Diagnostics faults, const ScriptCommand &command, const SourceText &source);

/// Returns the text of a member of a command that must be there, such as the file of an export.
Result<std::string> requiredText(const ScriptCommand &command, std::string_view member, const SourceText &source);
/// Returns the text of a member that may be absent; then it is empty.
Result<std::string> optionalText(const ScriptCommand &command, std::string_view member, const SourceText &source);

} // namespace forefront
