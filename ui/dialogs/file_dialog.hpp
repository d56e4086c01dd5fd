#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "ui/dialogs/file_list.hpp"
#include "ui/parts/dialog.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// A program with a button that chooses the right filter.
struct FilePreset {
    std::string id; ///< the button is the widget "dialog/DIALOG/preset/ID"
    std::string label;
    std::string filter; ///< id of the filter
};

/// The outcome of reading a file in the background.
struct FileOutcome {
    bool done = false;
    Diagnostics faults; ///< empty: the file is in use
};

/// The purpose and the initial state of a file dialog.
struct FileRequest {
    std::string id;     ///< widgets are "dialog/ID/..."
    std::string title;  ///< "Open"
    std::string action; ///< label of the button, "Open"
    /// Returns the label of the button for what would be written now, "Export 2 943 triangles"; unset: `action`.
    std::function<std::string(const Shell &)> actionNow = {};
    bool saves = false; ///< asks for the name of a new file, and confirms before replacing one
    std::vector<FileFilter> filters;
    std::size_t filter = 0;
    std::vector<FilePreset> presets; ///< a row of buttons above the name; may be empty
    /// Initial folder until a dialog with this id has been used, after which it is the one of that time; empty: the
    /// working folder.
    std::filesystem::path folder;
    bool fixedFolder = false; ///< always begin in `folder`
    /// Recent files that are offered before those of the settings that the first filter accepts; the last one first.
    std::vector<std::string> recent = {};
    std::string name; ///< suggested name
    /// Returns the files that a choice writes, for those that need more than the chosen one; may be empty.
    std::function<std::vector<std::filesystem::path>(const std::filesystem::path &, const FileFilter &)> writes = {};
    /// Called with the chosen file. The dialog closes if it returns no faults; otherwise it stays open and shows the
    /// first.
    std::function<Diagnostics(Shell &, const std::filesystem::path &, const FileFilter &)> chosen;
    /// Called before `chosen`, if set: reads the file as the background task of the shell. The dialog stays open until
    /// the result is there, and then as with `chosen`. Returns null to leave a small file to `chosen`.
    std::function<std::shared_ptr<const FileOutcome>(Shell &, const std::filesystem::path &)> reads;
    /// Draws extra lines between the list and the buttons, for the chosen filter; returns false to disable the button.
    /// May be empty.
    std::function<bool(Shell &, const FileFilter &)> extra;
    /// Returns the number of lines that `extra` draws for a filter; unset: 1.
    std::function<int(const FileFilter &)> extraLines;
    SnapshotLayers needs{.mesh = false, .front = false}; ///< parts of the run's snapshot that `chosen` uses
};

/// Lets the user choose a file.
class FileDialog : public Dialog {
  public:
    explicit FileDialog(FileRequest request);

    const char *id() const override { return request_.id.c_str(); }
    std::string title() const override { return request_.title; }
    float width() const override { return 680.0F; }
    float height() const override { return browses_ ? 560.0F : 0.0F; }
    /// While a file is read, Esc cancels that.
    bool closesOnEscape() const override { return !reading_; }
    void request(SnapshotLayers &wanted) const override {
        wanted.mesh |= request_.needs.mesh;
        wanted.front |= request_.needs.front;
        wanted.cells |= request_.needs.cells;
        wanted.explanation |= request_.needs.explanation;
    }
    bool draw(Shell &context) override;
    /// Returns the chosen filter.
    const FileFilter &filter() const { return request_.filters[request_.filter]; }

  private:
    /// Uses the result of reading the file, if it is there. Returns false to close the dialog.
    bool followReading(Shell &context);
    void drawReading(Shell &context);
    void cancelReading(Shell &context);
    void enter(const std::filesystem::path &folder);
    /// Enters the folder in which a dialog for the same purpose was used last.
    void recallFolder(const Shell &context);
    /// Returns the recent files that can be chosen.
    std::vector<std::string> recentFiles(const Shell &context) const;
    void drawPlaces(Shell &context);
    void drawPath(Shell &context);
    /// Returns true if a file was double-clicked.
    bool drawList(Shell &context);
    /// Chooses the file or folder whose name begins with what is typed while no field has the focus, or the next one
    /// for an arrow key.
    void typeAhead(Shell &context);
    bool drawRow(Shell &context, const FileEntry &entry);
    /// Draws the folders and the files. Returns true if a file was double-clicked.
    bool drawBrowser(Shell &context);
    /// Draws the folder of the file, and a button that shows the browser.
    void drawFolder(Shell &context);
    bool drawBottom(Shell &context);
    void drawName(Shell &context, bool &wanted);
    void drawPresets(Shell &context);
    const FilePreset *chosenPreset() const;
    void drawNote(Shell &context);
    /// Switches to another filter, and a suggested name to its extension.
    void useFilter(std::size_t filter);
    /// Returns the error in the choice, or a warning that it will replace a file; empty if neither.
    std::string warning() const;
    /// Returns the number of lines of the longest note on a filter at a width in pixels.
    std::ptrdiff_t noteLines(const Shell &context, float width) const;
    /// Returns the height of the rows below the list, in pixels.
    float bottomHeight(const Shell &context) const;
    /// Sets the chosen name and clears the faults of the previous one.
    void suggest(std::string name);
    bool choose(Shell &context);
    /// Returns which files saving to `file` replaces, such as "bay.node and bay.ele already exist"; empty: none.
    std::string replacedBy(const std::filesystem::path &file) const;
    /// Logs the faults of the chosen file and shows the first. Returns true if there are none.
    bool show(Shell &context, const Diagnostics &faults);
    /// Switches to the filter that the extension of a typed name belongs to.
    void followExtension(const std::string &name);
    /// Returns true if a filter has a note.
    bool hasNotes() const;
    std::string widget(const char *part) const { return "dialog/" + request_.id + "/" + part; }

    /// Width of each of the two buttons and the gap between them, in design pixels; the warning is to their left.
    static constexpr float kButton = 108.0F, kButtonGap = 10.0F;
    static constexpr float kNoteIndent = 72.0F; ///< of the note on the chosen format, like the fields

    FileRequest request_;
    std::filesystem::path folder_;
    std::vector<FileEntry> entries_;
    std::string fault_;
    std::shared_ptr<const FileOutcome> reading_;   ///< of the file being read; null: none
    std::optional<std::filesystem::path> replace_; ///< asked whether to replace this file, or what comes with it
    std::string replaced_;                         ///< says which files are replaced then
    std::filesystem::path chosen_;                 ///< the last file that was chosen
    bool recalled_ = false;                        ///< recallFolder() was called
    bool focusName_ = true;
    bool entered_ = false; ///< Enter was pressed in this frame, outside all fields
    bool browses_ = true;  ///< shows the folders and files; at first not if there are presets, which come first
    int presetRows_ = 1;   ///< rows of their buttons in the last frame
    std::string preset_;   ///< id of the one that was pressed last
    bool newFolder_ = false;
    std::string newFolderName_;
    std::string typed_;     ///< beginning of a name, see typeAhead()
    double typedAt_ = -1e9; ///< time of its last letter
};

} // namespace forefront
