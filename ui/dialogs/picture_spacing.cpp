#include "ui/dialogs/picture_spacing.hpp"

#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/files/common/cell_grid.hpp"
#include "ui/dialogs/read_in_background.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/fault_text.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>
#include <utility>

namespace forefront {

namespace {

constexpr double kLabelColumn = 110.0, kFieldWidth = 96.0; ///< design pixels
constexpr std::size_t kThumbnailValues = 3000;
constexpr double kCoarse = 45.0, kFine = 10.0; ///< proposed: elements across the drawing at white; white by black

/// Returns a number with one significant digit.
double rounded(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)));
    return std::round(value / unit) * unit;
}

/// Returns the picture with about as many values as can be drawn one by one.
GreyPicture reduced(const GreyPicture &picture) {
    const GridCounts counts = averagedCounts(picture.columns, picture.rows, kThumbnailValues);
    GreyPicture small{picture.pixelColumns, picture.pixelRows, counts.columns, counts.rows};
    for (std::size_t row = 0; row < counts.rows; ++row) {
        for (std::size_t column = 0; column < counts.columns; ++column) {
            const std::size_t from = (2 * row + 1) * picture.rows / (2 * counts.rows);
            small.values.push_back(
                picture.values[from * picture.columns + (2 * column + 1) * picture.columns / (2 * counts.columns)]);
        }
    }
    return small;
}

/// Returns where the picture lies if the document has it as background picture and does not turn it.
std::optional<Box2> ownPlace(const Document &document, const std::filesystem::path &file) {
    std::error_code none;
    return document.picture && document.picture->angle == 0.0 &&
                   std::filesystem::equivalent(document.picture->file, file, none)
               ? std::optional(boundsOf(*document.picture))
               : std::nullopt;
}

} // namespace

PictureSpacingDialog::PictureSpacingDialog(const Shell &context, std::filesystem::path file, GreyPicture picture)
    : file_(std::move(file)), picture_(std::move(picture)), thumbnail_(reduced(picture_)) {
    const Document &document = *context.document.current();
    const auto columns = static_cast<double>(picture_.pixelColumns), rows = static_cast<double>(picture_.pixelRows);
    if (const std::optional<Box2> own = ownPlace(document, file_)) {
        sizes_.box = *own;
    } else if (document.shapes.empty()) {
        sizes_.box = document.picture && document.picture->angle == 0.0 ? boundsOf(*document.picture)
                                                                        : Box2{{0.0, 0.0}, {columns, rows}};
    } else {
        sizes_.box = pictureBoxAround(boundsOf(document), columns, rows);
    }
    const Box2 drawing = document.shapes.empty() ? sizes_.box : boundsOf(document);
    const double extent = drawing.diagonal() > 0.0 ? drawing.diagonal() : sizes_.box.diagonal();
    sizes_.white = rounded(extent / kCoarse);
    sizes_.black = rounded(sizes_.white / kFine);
}

/// Draws the picture as it is used, and how many values it has.
void PictureSpacingDialog::drawPicture(Shell &context) const {
    const float width = context.px(130), height = context.px(96);
    const float pixel =
        std::min(width / static_cast<float>(thumbnail_.columns), height / static_cast<float>(thumbnail_.rows));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const auto at = [&](std::size_t column, std::size_t row) {
        return ImVec2(corner.x + pixel * static_cast<float>(column), corner.y + pixel * static_cast<float>(row));
    };
    for (std::size_t row = 0; row < thumbnail_.rows; ++row) {
        for (std::size_t column = 0; column < thumbnail_.columns; ++column) {
            const double grey = thumbnail_.values[row * thumbnail_.columns + column];
            if (grey != kNoGrey) {
                list.AddRectFilled(at(column, row), at(column + 1, row + 1), mix(rgb(0x000000), rgb(0xffffff), grey));
            }
        }
    }
    list.AddRect(corner, at(thumbnail_.columns, thumbnail_.rows), context.theme.line);
    ImGui::Dummy({width, pixel * static_cast<float>(thumbnail_.rows)});
    ui::mark(context, "dialog/picturespacing/thumbnail");
    ImGui::SameLine(0, context.px(16));
    ImGui::BeginGroup();
    const auto counted = [](std::size_t columns, std::size_t rows) {
        return ui::count(columns) + " \xc3\x97 " + ui::count(rows);
    };
    ui::muted(context, counted(picture_.pixelColumns, picture_.pixelRows) + " pixels");
    const bool means = picture_.values.size() < picture_.pixelColumns * picture_.pixelRows;
    ui::muted(context, means ? counted(picture_.columns, picture_.rows) + " values: means of the pixels"
                             : ui::count(picture_.values.size()) + " values");
    ui::mark(context, "dialog/picturespacing/values");
    const auto clear = std::count(picture_.values.begin(), picture_.values.end(), kNoGrey);
    if (clear > 0) {
        ui::muted(context, ui::count(static_cast<std::uint64_t>(clear)) + " of them transparent: no size there");
    }
    ui::small(context, "Between black and white, the size follows the grey.", true);
    ImGui::EndGroup();
}

void PictureSpacingDialog::drawSize(Shell &context, const char *name, double &size) {
    const std::string widget = std::string("dialog/picturespacing/") + name;
    double typed = size;
    if (ui::inputNumber(context, widget, typed, kFieldWidth, {}, context.document.current()->unit) &&
        ui::checkPositive(context, widget, typed)) {
        size = typed;
    }
}

void PictureSpacingDialog::drawSizes(Shell &context) {
    ui::rowLabel(context, "Size at black", kLabelColumn);
    drawSize(context, "black", sizes_.black);
    ImGui::SameLine();
    ui::muted(context, "at white");
    ImGui::SameLine();
    drawSize(context, "white", sizes_.white);
}

void PictureSpacingDialog::drawPlaces(Shell &context) {
    const Document &document = *context.document.current();
    const double columns = static_cast<double>(picture_.pixelColumns);
    const double rows = static_cast<double>(picture_.pixelRows);
    const auto place = [&](const char *name, const char *label, const Box2 &box, const char *tip) {
        if (ui::chip(context, std::string("dialog/picturespacing/") + name, label, sizes_.box == box)) {
            sizes_.box = box;
        }
        ui::tooltip(context, tip);
        ImGui::SameLine();
    };
    ui::rowLabel(context, "Place", kLabelColumn);
    if (!document.shapes.empty()) {
        place("around", "Around the drawing", pictureBoxAround(boundsOf(document), columns, rows),
              "The picture covers the drawing; its width or its height fits");
    }
    if (document.picture && document.picture->angle == 0.0) { // sizes are given along the axes
        place("background", "Background picture", boundsOf(*document.picture),
              "The place and scale of the picture below the drawing");
    }
    if (document.shapes.empty()) {
        place("pixels", "1 unit per pixel", {{0.0, 0.0}, {columns, rows}}, "From the origin on");
    }
    ImGui::NewLine();
}

void PictureSpacingDialog::drawPlace(Shell &context) {
    drawPlaces(context);
    Vec2 corner = sizes_.box.min;
    Vec2 size = sizes_.box.size();
    ui::rowLabel(context, "Lower left", kLabelColumn);
    if (ui::inputPoint(context, "dialog/picturespacing/corner", corner, kFieldWidth, {}, {})) {
        sizes_.box = {corner, corner + size};
    }
    ui::rowLabel(context, "Width", kLabelColumn);
    double width = size.x;
    const char *const name = "dialog/picturespacing/width";
    if (ui::inputNumber(context, name, width, kFieldWidth, {}, context.document.current()->unit) &&
        ui::checkPositive(context, name, width)) {
        sizes_.box.max = corner + (width / size.x) * size;
    }
    ImGui::SameLine();
    ui::muted(context, "Height " + ui::number(sizes_.box.size().y));
}

bool PictureSpacingDialog::import(Shell &context) {
    ImportNotes notes;
    SourceText source;
    source.name = file_.string();
    source.notes = &notes;
    Result<SpacingSpec> spacing = spacingOfPicture(picture_, sizes_, source);
    Result<Document> next = spacing ? setImportedSpacing(*context.document.current(), *std::move(spacing))
                                    : Result<Document>(spacing.faults());
    if (!next) {
        const Diagnostic &fault = next.faults().front();
        fault_ = fault.advice.empty() ? fault.message : fault.message + "; " + fault.advice;
        return false;
    }
    context.document.apply(*std::move(next), "Import spacing");
    context.log.announce("Imported spacing from " + file_.filename().string());
    context.log.add(notes.diagnostics());
    return true;
}

bool PictureSpacingDialog::draw(Shell &context) {
    const bool enter = ui::enterOutsideFields(); // in a field, it only accepts the number
    drawPicture(context);
    ImGui::Dummy({0, context.px(6)});
    drawSizes(context);
    ImGui::Dummy({0, context.px(6)});
    drawPlace(context);
    if (!fault_.empty()) {
        ui::faultText(context, fault_);
        ui::mark(context, "dialog/picturespacing/fault");
    }
    ImGui::Dummy({0, context.px(8)});
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - context.px(258));
    if (ui::button(context, "dialog/picturespacing/cancel", "Cancel", ui::ButtonKind::Plain, true, 124.0F)) {
        return false;
    }
    ImGui::SameLine(0, context.px(10));
    const bool ok = ui::button(context, "dialog/picturespacing/ok", "Import", ui::ButtonKind::Primary, true, 124.0F);
    if ((ok || enter) && !ui::showsFault(context, "dialog/picturespacing/")) {
        return !import(context);
    }
    return true;
}

std::shared_ptr<const FileOutcome> importPictureSpacing(Shell &context, const std::filesystem::path &file) {
    auto outcome = std::make_shared<FileOutcome>();
    readInBackground(
        context, file, outcome, [&context, file](const Progress &progress) -> Result<BackgroundTask::Finish> {
            ImportOptions options;
            options.progress = progress;
            const Result<std::string> bytes = readFileBytes(file, options.maxBytes, progress);
            if (!bytes) {
                return bytes.faults();
            }
            const SourceText source{*bytes, file.string(), file, options};
            Result<GreyPicture> read = readGreyPicture(source, kMaxGridValues);
            if (!read) {
                return read.faults();
            }
            const auto picture = std::make_shared<GreyPicture>(*std::move(read));
            return BackgroundTask::Finish([&context, file, picture] {
                context.dialogs.open(std::make_unique<PictureSpacingDialog>(context, file, std::move(*picture)));
            });
        });
    return outcome;
}

} // namespace forefront
