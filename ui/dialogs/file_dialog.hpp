#pragma once

#include "core/base/diagnostic.hpp"
#include "ui/dialogs/dialog.hpp"
#include "ui/dialogs/file_list.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// What a file dialog is for.
struct FileRequest {
    std::string id;     ///< widgets are "dialog/ID/..."
    std::string title;  ///< "Open"
    std::string action; ///< label of the button, "Open"
    bool saves = false; ///< a name for a new file is wanted; an existing one is asked about
    std::vector<FileFilter> filters;
    std::size_t filter = 0;
    std::filesystem::path folder; ///< where to begin; empty: the working folder
    std::string name;             ///< suggested
    /// Called with the file chosen. No faults: done, the dialog closes; else it stays and shows the first.
    std::function<Diagnostics(AppContext &, const std::filesystem::path &, const FileFilter &)> chosen;
    /// Lines between the list and the buttons; returns false to disable the button. May be empty.
    std::function<bool(AppContext &)> extra;
    int extraLines = 1; ///< number of lines that `extra` draws
};

/// Choosing a file inside the program.
class FileDialog : public Dialog {
  public:
    explicit FileDialog(FileRequest request);

    const char *id() const override { return request_.id.c_str(); }
    std::string title() const override { return request_.title; }
    float width() const override { return 680.0F; }
    float height() const override { return 560.0F; }
    bool draw(AppContext &context) override;

  private:
    void enter(const std::filesystem::path &folder);
    void drawPlaces(AppContext &context);
    void drawPath(AppContext &context);
    /// The file double-clicked, if any.
    bool drawList(AppContext &context);
    bool drawRow(AppContext &context, const FileEntry &entry);
    bool drawBottom(AppContext &context);
    void drawName(AppContext &context, bool &wanted);
    /// What is wrong with the choice, or what choosing once more will do; empty: nothing.
    std::string warning() const;
    /// Height of what stands below the list, in pixels.
    float bottomHeight(const AppContext &context) const;
    /// What the list and the field of the name say counts from now on; earlier faults do not.
    void suggest(std::string name);
    bool choose(AppContext &context);
    /// A typed ending of another kind of file chooses that kind.
    void followExtension(const std::string &name);
    std::string widget(const char *part) const { return "dialog/" + request_.id + "/" + part; }
    const FileFilter &filter() const { return request_.filters[request_.filter]; }

    FileRequest request_;
    std::filesystem::path folder_;
    std::vector<FileEntry> entries_;
    std::string fault_;
    std::optional<std::filesystem::path> replace_; ///< asked whether to replace this file
    bool focusName_ = true;
    bool newFolder_ = false;
    std::string newFolderName_;
};

} // namespace forefront
