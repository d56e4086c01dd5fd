#pragma once

#include "core/edit/document.hpp"
#include "ui/dialogs/dialog.hpp"

#include <filesystem>

namespace forefront {

/// Shows the size of a drawing read from a file, and asks for its unit, before adding it to the current drawing.
class ImportDialog final : public Dialog {
  public:
    ImportDialog(std::filesystem::path file, Document drawing) : file_(std::move(file)), drawing_(std::move(drawing)) {}

    const char *id() const override { return "importoptions"; }
    std::string title() const override { return "Import " + file_.filename().string(); }
    bool draw(AppContext &context) override;

  private:
    void insert(AppContext &context) const;

    std::filesystem::path file_;
    Document drawing_;
    double scale_ = 1.0;
};

} // namespace forefront
