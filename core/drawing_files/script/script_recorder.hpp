#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/document/history.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace forefront {

/// Writes what happens to a document as a script that does the same. For each step it looks for the command that says
/// what the user did (a shape was added, moved, constrained), plays it, and keeps it only if the document is then the
/// same; otherwise it writes the parts that differ. So a replay always gives the recorded documents.
class ScriptRecorder {
  public:
    /// Begins with a document, which the script holds as a whole unless it is empty.
    explicit ScriptRecorder(std::shared_ptr<const Document> start);

    /// Records that another document was opened.
    void load(std::shared_ptr<const Document> document);
    /// Records that a document became the current one: by a command, or by undo or redo if it was current before.
    /// O(size of the document).
    void record(std::shared_ptr<const Document> document);
    /// Records that the current document was meshed, unless that has been recorded; `hash`: of the mesh, which a replay
    /// must reproduce.
    void recordMesh(std::uint64_t hash);
    /// Records that the mesh of the current document was written to a file in a format of that id, with the names of
    /// the open boundary parts and an expression for the elevation; both may be empty.
    void recordExport(const std::filesystem::path &file, const std::string &format, std::uint64_t hash,
                      const std::vector<std::string> &open = {}, const std::string &elevation = {});

    /// Records that the current document was saved to a project file.
    void recordSave(const std::filesystem::path &file);

    /// Returns the script so far, one command a line.
    const std::string &text() const { return text_; }
    /// Returns the number of commands so far.
    std::size_t commands() const { return commands_; }

  private:
    bool walk(const Document *document);
    bool accept(const std::string &line, const Document &document);
    void write(const std::string &line);

    History history_;                                      ///< of a replay
    std::vector<std::shared_ptr<const Document>> entries_; ///< the recorded documents of its entries
    bool meshed_ = false;                                  ///< the mesh of the current document is recorded
    std::string text_;
    std::size_t commands_ = 0;
};

} // namespace forefront
