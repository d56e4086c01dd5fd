#pragma once

#include "core/edit/document.hpp"
#include "core/io/source/import_notes.hpp"
#include "ui/parts/dialog.hpp"

#include <filesystem>
#include <utility>

namespace forefront {

/// Shows the size of a drawing read from a file, and asks for its unit, before adding it to the current drawing.
class ImportDialog final : public Dialog {
  public:
    /// `notes` lists what the reader did not use.
    ImportDialog(std::filesystem::path file, Document drawing, ImportNotes notes)
        : file_(std::move(file)), drawing_(std::move(drawing)), notes_(std::move(notes)) {}

    const char *id() const override { return "importoptions"; }
    std::string title() const override { return "Import " + file_.filename().string(); }
    bool draw(Shell &context) override;

  private:
    void insert(Shell &context) const;

    std::filesystem::path file_;
    Document drawing_;
    ImportNotes notes_;
    double scale_ = 1.0;
};

} // namespace forefront
