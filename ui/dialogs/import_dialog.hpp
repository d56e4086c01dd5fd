#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/files/source/import_notes.hpp"
#include "core/files/source/import_options.hpp"
#include "ui/parts/preview_dialog.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace forefront {

/// Shows a drawing read from a file in its place in the current drawing, its size, what reading it ignored and changed,
/// and asks for its unit and weld tolerance, before adding it.
class ImportDialog final : public PreviewDialog {
  public:
    /// Reads the file, on any thread. Faults: those of readDocument().
    static Result<std::unique_ptr<ImportDialog>> open(const std::filesystem::path &file, const Progress &progress);

    const char *id() const override { return "importoptions"; }
    std::string title() const override { return "Import " + file_.filename().string(); }
    void dismiss(Shell &context) override;
    bool draw(Shell &context) override;

  private:
    explicit ImportDialog(std::filesystem::path file) : file_(std::move(file)) {}

    /// Reads the file with the current options. If that fails, the drawing read before stays, and `faults_` says why.
    void read(const Progress &progress = {});
    void projectIfPossible(const Progress &progress);
    void chooseWhite();
    /// Reads other layers.
    void readLayers();
    void drawSizes(Shell &context) const;
    void drawUnit(Shell &context);
    void drawMap(Shell &context);
    void drawJoining(Shell &context);
    void drawReport(Shell &context) const;
    void drawNote(Shell &context, const std::string &name, const std::string &text,
                  const std::optional<Vec2> &place) const;
    /// Shows the drawing as read last, selected, as part of a stroke that can be abandoned.
    void preview(Shell &context);
    void accept(Shell &context);

    std::filesystem::path file_;
    ImportOptions options_;
    bool arranges_ = false;       ///< the format is a drawing or map, whose lines may cross and overlap
    bool leavesPage_ = false;     ///< the filled shapes of a drawing reach beyond its page
    bool hasFeatures_ = false;    ///< the format is a map, whose features may overlap
    bool hasLines_ = false;       ///< a drawing or map has areas and lines, whether or not they are left out
    bool hasStrokes_ = false;     ///< a drawing has strokes, which are lines or areas
    std::size_t whiteShapes_ = 0; ///< that lie on others in a drawing
    Document drawing_;
    DrawingContents contents_;
    Diagnostics notes_; ///< what reading ignored and changed
    Diagnostics faults_;
    double scale_ = 1.0;
    int reads_ = 0;                         ///< how often the file was read
    std::shared_ptr<const Document> start_; ///< before the preview; null: there was none yet
    Selection selection_;                   ///< then
    std::string stroke_;
    Diagnostics insertionNotes_; ///< of the preview
    int shownReads_ = 0;         ///< reads_ and scale_ of the preview
    double shownScale_ = 0.0;
    float questions_ = 200.0F; ///< height of all between title and buttons in the last frame
};

} // namespace forefront
