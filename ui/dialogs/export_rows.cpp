#include "ui/dialogs/export_rows.hpp"

#include "core/drawing/document/document.hpp"
#include "core/engine/spacing/parts/expression/expression.hpp"
#include "core/files/common/names.hpp"
#include "core/files/open_boundaries.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/parse_number.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace forefront {

namespace {

constexpr double kExportFields = 92.0;    ///< left edge of the fields, design pixels
constexpr std::size_t kOpenLines = 4;     ///< parts that the list shows at once
constexpr float kElevationWidth = 320.0F; ///< of the elevation, design pixels

constexpr const char *kElevationField = "dialog/export/elevation";

std::string namesOf(const std::map<std::int32_t, std::string> &parts) {
    std::string list;
    for (const auto &[tag, name] : parts) {
        list += (list.empty() ? "" : ", ") + name;
    }
    return list;
}

/// Returns an example of an elevation: by the first raster, if there is one.
std::string exampleOf(const RasterMap &rasters) {
    return rasters.empty() ? "-5 - 0.01*x" : "-" + rasters.begin()->first + "(x,y)";
}

} // namespace

ExportRows::ExportRows(const Document &document) : open_(document.openBoundaries), elevation_(document.elevation) {}

/// Lists the parts of another mesh.
void ExportRows::look(const std::shared_ptr<const MeshSnapshot> &mesh) {
    if (mesh != mesh_) {
        mesh_ = mesh;
        boundary_ = boundaryPartsOf(mesh->view());
        regions_ = tagsOf(mesh->view()).regions;
    }
}

void ExportRows::draw(Shell &context, const FileFormat &format, const std::shared_ptr<const MeshSnapshot> &mesh) {
    look(mesh);
    drawNames(context, format);
    if (!format.dropsInnerEdges) {
        drawInnerEdges(context, format);
    }
    if (format.hasOpenBoundaries) {
        drawOpenParts(context);
    }
    if (format.holdsElevations) {
        drawElevation(context, format);
    }
}

int ExportRows::lines(const FileFormat &format) const {
    const auto listed = static_cast<int>(std::min(kOpenLines, boundary_.size()));
    return (format.dropsBoundaryNames && format.dropsRegionNames ? 0 : 1) + (format.dropsInnerEdges ? 0 : 1) +
           (format.hasOpenBoundaries ? listed + 1 : 0) + (format.holdsElevations ? 1 : 0);
}

/// Names the boundary parts and regions that the file will name.
void ExportRows::drawNames(Shell &context, const FileFormat &format) const {
    std::string text = format.dropsBoundaryNames || boundary_.empty() ? "" : "Boundary: " + namesOf(boundary_);
    if (!format.dropsRegionNames && !regions_.empty()) {
        text += (text.empty() ? "Regions: " : "; regions: ") + namesOf(regions_);
    }
    if (text.empty()) {
        return;
    }
    ImGui::AlignTextToFramePadding();
    ui::muted(context, ui::oneLine(text, ImGui::GetContentRegionAvail().x));
    ui::mark(context, "dialog/export/names");
    ui::tooltip(context, text + ". F2 names what is selected.");
}

/// Asks whether to export tagged edges inside the domain, or says why they are left out.
void ExportRows::drawInnerEdges(Shell &context, const FileFormat &format) {
    if (format.acceptsInnerEdges) {
        ui::checkbox(context, "dialog/export/inner-edges", "Include tagged edges inside the domain", innerEdges_);
        return;
    }
    ImGui::AlignTextToFramePadding();
    ui::muted(context, "Tagged edges inside the domain are left out: in this format they would be boundaries");
    ui::mark(context, "dialog/export/no-inner-edges");
}

/// Draws a check mark for each boundary part, and says what those without one become.
void ExportRows::drawOpenParts(Shell &context) {
    ui::rowLabel(context, "Open", kExportFields);
    const auto lines = static_cast<float>(std::clamp(boundary_.size(), std::size_t{1}, kOpenLines));
    ImGui::BeginChild("open", {0, lines * ImGui::GetFrameHeightWithSpacing()}, false, ImGuiWindowFlags_NoNav);
    for (const auto &[tag, name] : boundary_) {
        const auto found = std::find(open_.begin(), open_.end(), tag);
        bool open = found != open_.end();
        if (!ui::checkbox(context, "dialog/export/open/" + std::to_string(tag), name, open)) {
            continue;
        }
        if (open) {
            open_.push_back(tag);
            std::sort(open_.begin(), open_.end());
        } else {
            open_.erase(found);
        }
    }
    ImGui::EndChild();
    ImGui::SetCursorPosX(context.px(kExportFields));
    ImGui::AlignTextToFramePadding();
    ui::muted(context, anyOpen() ? "Water flows through the checked parts; all others are land"
                                 : "All of the boundary is land; check the parts through which water flows");
    ui::mark(context, "dialog/export/land");
}

bool ExportRows::anyOpen() const {
    return std::ranges::any_of(open_, [this](std::int32_t tag) { return boundary_.contains(tag); });
}

/// Takes an elevation, or refuses it with the place of its fault.
void ExportRows::enterElevation(Shell &context, const std::string &typed) {
    const Result<ExpressionProgram> compiled =
        compileSpacingExpression(typed, context.document.current()->spacing, nullptr);
    if (compiled) {
        elevation_ = typed;
        return;
    }
    const Diagnostic &fault = compiled.faults().front();
    const std::string place = fault.column > 0 ? "column " + std::to_string(fault.column) + ": " : std::string();
    ui::refuseEntry(context, kElevationField, compiled.faults(), place + fault.message);
}

/// Draws the field for the elevation of the nodes; the syntax is checked here, the values when the file is written.
void ExportRows::drawElevation(Shell &context, const FileFormat &format) {
    const SpacingSpec &spacing = context.document.current()->spacing;
    ui::rowLabel(context, "Elevation", kExportFields);
    const std::string example = exampleOf(spacing.rasters);
    const std::optional<std::string> typed =
        ui::inputChecked(context, kElevationField, elevation_, example, kElevationWidth);
    if (typed && trimmed(*typed).empty()) {
        elevation_.clear();
    } else if (typed) {
        enterElevation(context, *typed);
    }
    ui::tooltip(context, "Elevation of the nodes as a function of x and y, of rasters of the project such as "
                         "depth(x,y), and of the distance to the boundary, shore(x,y). Depths are the same with the "
                         "other sign.");
    if (elevation_.empty()) {
        ImGui::SameLine();
        ui::muted(context, format.hasOpenBoundaries ? "empty: all depths are 0" : "empty: none");
    }
}

ExportChoice ExportRows::choice(const FileFormat &format) const {
    ExportChoice choice;
    const bool keeps = format.dropsInnerEdges || innerEdges_; // for a format that drops them, there is no choice
    choice.innerEdges = keeps && format.acceptsInnerEdges ? InnerEdges::Keep : InnerEdges::Drop;
    if (format.hasOpenBoundaries) {
        for (const std::int32_t tag : open_) {
            if (const auto part = boundary_.find(tag); part != boundary_.end()) {
                choice.open.insert(*part);
            }
        }
    }
    if (format.holdsElevations) {
        choice.elevation = elevation_;
    }
    return choice;
}

void ExportRows::keep(Shell &context, const FileFormat &format) const {
    Document next = *context.document.current();
    if (format.hasOpenBoundaries) {
        next.openBoundaries = open_;
    }
    if (format.holdsElevations) {
        next.elevation = elevation_;
    }
    const Document &now = *context.document.current();
    if (next.openBoundaries != now.openBoundaries || next.elevation != now.elevation) {
        context.document.apply(std::move(next), "Set open boundary and elevation");
    }
}

} // namespace forefront
