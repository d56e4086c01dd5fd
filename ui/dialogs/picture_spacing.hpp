#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/files/png/png.hpp"
#include "core/files/source/picture_sizes.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/parts/dialog.hpp"

#include <filesystem>
#include <memory>
#include <string>

namespace forefront {

/// Asks for the sizes that the grey values of a picture mean and where it lies, then makes them the spacing.
class PictureSpacingDialog final : public Dialog {
  public:
    PictureSpacingDialog(const Shell &context, std::filesystem::path file, GreyPicture picture);

    const char *id() const override { return "picturespacing"; }
    std::string title() const override { return "Import spacing from " + file_.filename().string(); }
    bool draw(Shell &context) override;

  private:
    void drawPicture(Shell &context) const;
    void drawSizes(Shell &context);
    void drawSize(Shell &context, const char *name, double &size);
    void drawPlace(Shell &context);
    /// Draws buttons for the places that can be proposed.
    void drawPlaces(Shell &context);
    /// Makes the picture the spacing. Returns false if that fails; the reason is then in `fault_`.
    bool import(Shell &context);

    std::filesystem::path file_;
    GreyPicture picture_;
    GreyPicture thumbnail_; ///< with fewer values
    PictureSizes sizes_;
    std::string fault_;
};

/// Reads a picture in the background, then opens the dialog. Faults go to the returned outcome.
std::shared_ptr<const FileOutcome> importPictureSpacing(Shell &context, const std::filesystem::path &file);

} // namespace forefront
