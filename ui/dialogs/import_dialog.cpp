#include "ui/dialogs/import_dialog.hpp"

#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/drawing/commands/insert_document.hpp"
#include "core/drawing/commands/repair_drawing.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/files/files.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace forefront {

namespace {

bool mixesLines(const Document &drawing) {
    const auto has = [&drawing](ShapeUse use) {
        return std::any_of(drawing.shapes.begin(), drawing.shapes.end(),
                           [use](const auto &shape) { return shape->use == use; });
    };
    return has(ShapeUse::Boundary) && has(ShapeUse::Constraint);
}

/// A drawing, and a record of what the reader found, ignored and changed.
struct Reading {
    Document drawing;
    Diagnostics notes;
    DrawingContents contents{};
};

Result<Reading> readAsItIs(const std::filesystem::path &file, const ImportOptions &options) {
    ImportNotes notes;
    Result<Document> drawing = readDocument(file, options, &notes);
    if (!drawing) {
        return drawing.faults();
    }
    return Reading{*std::move(drawing), notes.diagnostics(), notes.contents()};
}

Diagnostics joined(Diagnostics notes, const std::vector<ArrangementChange> &changes) {
    const Diagnostics more = notesWithPlaces(changes);
    notes.insert(notes.end(), more.begin(), more.end());
    return notes;
}

/// Repairs a drawing while reading it; a project keeps the shapes that the repair does not change.
Result<Reading> readRepaired(const std::filesystem::path &file, const ImportOptions &options) {
    const double tolerance = options.weldTolerance.value_or(0.0);
    const FileFormat *const format = allFormats().detect(file);
    ImportNotes notes;
    if (format != nullptr && format->kind == FileKind::Project) {
        const Result<Document> document = readDocument(file, options, &notes);
        Result<RepairedDrawing> repaired = document ? repairDrawing(*document, tolerance) : document.faults();
        if (!repaired) {
            return repaired.faults();
        }
        Diagnostics all = joined(notes.diagnostics(), repaired->changes);
        all.insert(all.end(), repaired->lostSizes.begin(), repaired->lostSizes.end());
        return Reading{std::move(repaired->document), std::move(all)};
    }
    Result<DomainFile> read = allFormats().readDomain(file, options, &notes);
    Result<Repaired> repaired = read ? repair(read->domain, tolerance) : read.faults();
    if (!repaired) {
        return repaired.faults();
    }
    read->domain = std::move(repaired->domain);
    return Reading{fromDomain(*read), joined(notes.diagnostics(), repaired->changes)};
}

} // namespace

Result<std::unique_ptr<ImportDialog>> ImportDialog::open(const std::filesystem::path &file, const Progress &progress) {
    std::unique_ptr<ImportDialog> dialog(new ImportDialog(file));
    dialog->read(progress);
    if (!dialog->faults_.empty()) {
        return std::move(dialog->faults_);
    }
    if (hasCode(dialog->notes_, kDegreesWarning)) {
        dialog->projectIfPossible(progress);
    }
    const FileFormat *const format = allFormats().detect(file);
    dialog->arranges_ = format != nullptr && format->arranges;
    dialog->hasFeatures_ = format != nullptr && format->kind == FileKind::Map;
    dialog->hasLines_ = dialog->contents_.lines && mixesLines(dialog->drawing_); // lines along outlines are gone
    dialog->hasStrokes_ = hasCode(dialog->notes_, kStrokeNote);
    dialog->leavesPage_ = hasCode(dialog->notes_, kPageNote);
    if (dialog->contents_.whiteShapes > 0) {
        dialog->chooseWhite();
    }
    return dialog;
}

void ImportDialog::read(const Progress &progress) {
    const bool repairs = !arranges_ && options_.weldTolerance.value_or(0.0) > 0.0;
    ImportOptions options = options_;
    options.progress = progress;
    Result<Reading> reading = repairs ? readRepaired(file_, options) : readAsItIs(file_, options);
    faults_ = reading ? Diagnostics() : reading.faults();
    ++reads_;
    if (reading) {
        drawing_ = std::move(reading->drawing);
        notes_ = std::move(reading->notes);
        contents_ = reading->contents;
    }
}

/// Projects a map that degrees distort, unless it is too large: its mesh would have other angles on the ground.
void ImportDialog::projectIfPossible(const Progress &progress) {
    options_.degrees = DegreeRule::Local;
    read(progress);
    if (!faults_.empty()) {
        options_.degrees = DegreeRule::Keep;
        read(progress);
    }
}

/// Shows as the user's choice what the reader did with white shapes on others.
void ImportDialog::chooseWhite() {
    whiteShapes_ = contents_.whiteShapes;
    options_.whiteHoles = contents_.whiteHoles;
    std::erase_if(notes_, [](const Diagnostic &note) { return note.code == kWhiteNote; }); // the switch tells it
}

void ImportDialog::readLayers() {
    options_.nameProperty.reset(); // the features of another layer have other properties,
    options_.dropLines = false;    // and perhaps no lines
    contents_.properties.clear();  // in case this one cannot be read
    contents_.lines = false;
    read();
    hasLines_ = contents_.lines && mixesLines(drawing_);
}

void ImportDialog::preview(Shell &context) {
    if (!start_) {
        context.document.endStroke();
        start_ = context.document.current();
        scale_ = conversion(drawing_.unit, start_->unit).value_or(scale_);
        selection_ = context.selection;
        stroke_ = "import " + std::to_string(context.document.revision());
    } else if (shownReads_ == reads_ && shownScale_ == scale_) {
        return;
    } else {
        dismiss(context);
    }
    shownReads_ = reads_;
    shownScale_ = scale_;
    insertionNotes_.clear();
    if (drawing_.shapes.empty() || !faults_.empty()) {
        return;
    }
    Insertion insertion;
    if (const Status faults =
            context.document.tryApply(insertDrawing(*start_, drawing_, scale_, &insertion), "Import drawing", stroke_);
        !faults.empty()) {
        context.log.add(faults);
        return;
    }
    insertionNotes_ = std::move(insertion.notes);
    context.selection = std::move(insertion.added);
    context.actions.run("view.fit", context);
    context.animate();
}

void ImportDialog::dismiss(Shell &context) {
    if (start_ && context.document.current() != start_) {
        context.document.abandonStroke(stroke_);
        context.selection = selection_;
    }
}

void ImportDialog::accept(Shell &context) {
    context.document.endStroke();
    const std::size_t count = drawing_.shapes.size();
    context.log.announce(ui::count(count) + (count == 1 ? " shape" : " shapes") + " imported from " +
                         file_.filename().string());
    context.log.add(notes_);
    context.log.add(insertionNotes_);
}

bool ImportDialog::draw(Shell &context) {
    const bool enter = ui::enterOutsideFields(); // in a field, it only accepts the number
    // In a low window the questions are scrolled; the buttons stay in sight.
    constexpr double kFoot = 40.0, kLeast = 80.0; // design pixels
    const float room = ImGui::GetContentRegionAvail().y - context.px(kFoot);
    ImGui::BeginChild("questions", {0, std::min(questions_, std::max(context.px(kLeast), room))}, false,
                      ImGuiWindowFlags_NoNav);
    drawSizes(context);
    ImGui::Dummy({0, context.px(6)});
    drawUnit(context);
    ImGui::Dummy({0, context.px(6)});
    drawMap(context);
    drawJoining(context);
    preview(context);
    drawReport(context);
    if (const float height = ImGui::GetCursorPosY(); height != questions_) {
        questions_ = height;
        context.animate();
    }
    ImGui::EndChild();
    ImGui::Dummy({0, context.px(4)});
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - context.px(258));
    if (ui::button(context, "dialog/importoptions/cancel", "Cancel", ui::ButtonKind::Plain, true, 124.0F)) {
        dismiss(context);
        return false;
    }
    ImGui::SameLine(0, context.px(10));
    const bool ready = !drawing_.shapes.empty() && faults_.empty();
    const bool ok = ui::button(context, "dialog/importoptions/ok", "Import", ui::ButtonKind::Primary, ready, 124.0F);
    if ((ok || enter) && ready && !ui::showsFault(context, "dialog/importoptions/")) {
        accept(context);
        return false;
    }
    return true;
}

} // namespace forefront
