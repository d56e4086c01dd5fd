#pragma once

#include "core/drawing/shapes/references.hpp"
#include "ui/workspace/document/document_store.hpp"
#include "ui/workspace/run/adaptation.hpp"
#include "ui/workspace/run/document_run.hpp"
#include "ui/workspace/view/view.hpp"
#include "ui/workspace/view/workspaces.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

struct Shell;

/// A document in the background with all that its tab brings back.
struct LeftDocument {
    OpenDocument document;
    std::unique_ptr<DocumentRun> run;
    KeptAdaptation adaptation;
    Selection selection;
    View view;
    WorkspaceKind workspace = WorkspaceKind::Draw;
    bool meshColours = false;                       ///< see showMeshColours()
    std::pair<std::string, std::uint64_t> exported; ///< see Shell::exported
    std::uint64_t used = 0;                         ///< counts up; when its tab was left
};

/// The documents that are open in a window, from left to right. One is shown: it is in Shell itself, and its place here
/// is empty.
class DocumentTabs {
  public:
    struct Tab {
        std::uint64_t id = 0;               ///< differs from that of all other tabs
        std::unique_ptr<LeftDocument> left; ///< null: the document shown
    };

    /// Number of elements that tabs in the background keep.
    static constexpr std::size_t kMostElements = 1'000'000;

    std::size_t size() const { return tabs_.size(); }
    std::size_t active() const { return active_; }
    const Tab &at(std::size_t tab) const { return tabs_[tab]; }
    /// Opens a new tab behind the one shown and shows its empty document.
    void open(Shell &context);
    /// Shows another tab. What is being drawn is finished first.
    void show(std::size_t tab, Shell &context);
    /// Closes a tab with its document and shows its neighbour if it was the one shown. There must be another tab.
    void close(std::size_t tab, Shell &context);
    /// Drops meshes of tabs in the background, the one left first to begin with, while they have more than `most`
    /// elements together. They are made again when their tabs are shown. Meshes that are being made are kept. Called
    /// once per frame.
    void limitMemory(Shell &context, std::size_t most = kMostElements);

    /// Files that wait to be opened in tabs, since one is read after the other.
    std::deque<std::filesystem::path> waiting;

  private:
    void leave(Shell &context);
    void enter(std::size_t tab, Shell &context);

    std::vector<Tab> tabs_ = [] {
        std::vector<Tab> first;
        first.push_back({.id = 1, .left = nullptr});
        return first;
    }();
    std::size_t active_ = 0;
    std::uint64_t lastId_ = 1, uses_ = 0;
};

/// What the tab of a document shows.
struct TabCaption {
    std::string title;
    std::filesystem::path path; ///< empty: it has no file
    bool dirty = false;
};
TabCaption captionOf(const Shell &context, std::size_t tab);

/// Returns true if the document shown is as good as none: new, without a file and untouched, and no mesh of a file is
/// shown. Another document may then take its place.
bool isBlank(const Shell &context);

/// Finishes what is being drawn and closes previews and fields, so that the document can be left or replaced.
void finishInput(Shell &context);

} // namespace forefront
