#include "ui/dialogs/export_dialog.hpp"

#include "core/drawing_files/drawing_formats.hpp"
#include "core/files/files.hpp"
#include "core/files/inner_edges.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/mesh/element_words.hpp"

#include <imgui.h>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace forefront {

WriteDialog::WriteDialog(std::string file, Write write, std::function<void(Shell &)> done)
    : file_(std::move(file)), done_(std::move(done)) {
    result_ = std::async(std::launch::async, [write = std::move(write), fraction = fraction_,
                                              stop = stop_.get_token()] { return write(*fraction, stop); });
}

WriteDialog::~WriteDialog() {
    stop_.request_stop();
}

bool WriteDialog::draw(Shell &context) {
    context.animate();
    ui::muted(context, file_);
    ImGui::Dummy({0, context.px(4)});
    ImGui::ProgressBar(static_cast<float>(fraction_->load()), {-1.0F, context.px(8)}, "");
    ImGui::Dummy({0, context.px(8)});
    if (result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        const Diagnostics faults = result_.get();
        context.log.add(faults);
        if (!hasErrors(faults)) {
            done_(context);
        }
        return false;
    }
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - context.px(124));
    if (ui::button(context, "dialog/writing/cancel", "Cancel", ui::ButtonKind::Plain, !stop_.stop_requested(),
                   124.0F)) {
        stop_.request_stop();
    }
    return true;
}

namespace {

/// Returns the mesh that would be exported now, or null if there is none.
std::shared_ptr<const MeshSnapshot> finishedMesh(const Shell &context) {
    const SessionSnapshot &run = context.run.now();
    const bool finished = run.complete && run.state == RunState::Finished && !context.run.preview() && run.mesh &&
                          !run.mesh->mesh.elements.empty();
    return finished ? run.mesh : nullptr;
}

/// Draws the counts of the mesh, or offers to make one. Returns false if there is nothing to export. Starts meshing
/// automatically, once, if there is no finished mesh and no command is pending (a step may still be running when the
/// dialog opens).
bool drawMeshLine(Shell &context, bool &asked) {
    const std::shared_ptr<const MeshSnapshot> mesh = finishedMesh(context);
    ImGui::AlignTextToFramePadding();
    if (!mesh) {
        if (!asked && !context.run.busy() && !context.document.current()->shapes.empty()) {
            asked = true;
            context.run.mesh();
        }
        const bool busy = context.run.busy();
        ui::muted(context, busy ? "Meshing\xe2\x80\xa6" : "No finished mesh to export");
        ImGui::SameLine();
        if (!busy && ui::button(context, "dialog/export/mesh", "Mesh now")) {
            context.run.mesh();
        }
        if (busy) {
            context.animate();
        }
        return false;
    }
    const MeshView view = mesh->view();
    ImGui::TextUnformatted((elementsInWords(view) + ", " + ui::count(view.nodes.size()) + " nodes, " +
                            ui::count(view.edges.size()) + " tagged edges")
                               .c_str());
    if (context.run.outOfDate()) {
        ImGui::SameLine(0, context.px(16));
        ImGui::PushStyleColor(ImGuiCol_Text, context.theme.warn);
        ImGui::TextUnformatted("the drawing has changed since it was meshed");
        ImGui::PopStyleColor();
        ImGui::SameLine();
        if (ui::button(context, "dialog/export/mesh", "Mesh now")) {
            context.run.mesh();
        }
    }
    return true;
}

/// Describes what a mesh keeps in a file of each format.
struct Kept {
    std::string_view format;
    const char *text;
};
constexpr const char *kGroups = "Keeps regions, boundary parts and points as physical groups, with their names.";
constexpr Kept kKept[] = {
    {"msh2", kGroups},
    {"msh41", kGroups},
    {"msh41-binary", kGroups},
    {"medit", "Keeps the numbers of regions, boundary parts and points, for readmesh; names only as comments."},
    {"inp",
     "Keeps regions as element sets, boundary parts as node sets and surfaces, points as node sets, all with names "
     "that the solver accepts. Elements are CPS3."},
    {"su2", "Keeps boundary parts as markers, with their names; regions and points only as comments."},
    {"vtu", "Keeps the numbers of regions and boundary parts as cell data; boundary edges are separate cells."},
    {"vtk", "Keeps the numbers of regions and boundary parts as cell data; boundary edges are separate cells."},
    {"triangle", "Writes .node, .ele and .edge. Keeps boundary numbers as markers and regions as an attribute."},
    {"obj", "Keeps regions and boundary parts as groups, with their names."},
    {"svg", "A drawing of the mesh; cannot be read back as a mesh."},
};

const char *keptBy(std::string_view format) {
    const auto known =
        std::find_if(std::begin(kKept), std::end(kKept), [&](const Kept &kept) { return kept.format == format; });
    return known == std::end(kKept) ? "" : known->text;
}

/// The programs with a button.
std::vector<FilePreset> solverPresets() {
    return {{"gmsh", "Gmsh", "msh41"}, {"freefem", "FreeFem++", "medit"}, {"calculix", "CalculiX", "inp"},
            {"su2", "SU2", "su2"},     {"paraview", "ParaView", "vtu"},   {"triangle", "Triangle", "triangle"}};
}

/// Asks whether to export tagged edges inside the domain, or says why they are left out.
void drawInnerEdges(Shell &context, const FileFilter &filter, bool &keep) {
    if (acceptsInnerEdges({}, filter.id)) {
        ui::checkbox(context, "dialog/export/inner-edges", "Include tagged edges inside the domain", keep);
        return;
    }
    ImGui::AlignTextToFramePadding();
    ui::muted(context, "Tagged edges inside the domain are left out: in this format they would be boundaries");
    ui::mark(context, "dialog/export/no-inner-edges");
}

/// Returns true if files of a format can hold the mesh; says why if they cannot.
bool drawHeld(Shell &context, const FileFilter &filter) {
    const std::shared_ptr<const MeshSnapshot> mesh = finishedMesh(context);
    const Status faults = mesh ? checkElements(*allFormats().withId(filter.id), mesh->view()) : Status();
    if (faults.empty()) {
        return true;
    }
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, context.theme.warn);
    ImGui::TextUnformatted(faults.front().message.c_str());
    ImGui::PopStyleColor();
    ui::mark(context, "dialog/export/not-held");
    return false;
}

/// Returns the size of all files that were written, in bytes.
std::uintmax_t bytesOf(const std::filesystem::path &path, const std::string &format) {
    std::uintmax_t sum = 0;
    for (const std::filesystem::path &file : filesOfMesh(path, format)) {
        std::error_code failed;
        const std::uintmax_t bytes = std::filesystem::file_size(file, failed);
        sum += failed ? 0 : bytes;
    }
    return sum;
}

Diagnostics write(Shell &context, const std::filesystem::path &file, const FileFilter &filter, InnerEdges innerEdges) {
    const std::shared_ptr<const MeshSnapshot> mesh = finishedMesh(context);
    if (!mesh) {
        return error("no-mesh", "no finished mesh to export", "mesh the drawing first");
    }
    const auto job = [mesh, file, innerEdges, format = filter.id](std::atomic<double> &fraction, std::stop_token stop) {
        Progress progress;
        progress.report = [&fraction](std::string_view, double done) { fraction.store(done); };
        progress.stop = std::move(stop);
        const Mesh outline = innerEdges == InnerEdges::Drop ? withoutInnerEdges(mesh->view()) : Mesh();
        const MeshView exported = innerEdges == InnerEdges::Drop ? MeshView(outline) : mesh->view();
        const Status written = writeMesh(file, exported, format, progress);
        return hasErrors(written) ? written : exportNotes(file, exported, format);
    };
    const auto done = [file, format = filter.id, elements = elementsInWords(mesh->view())](Shell &c) {
        c.log.announce("Exported mesh to " + file.string() + ": " + elements + ", " +
                       fileSizeText(bytesOf(file, format)));
    };
    context.dialogs.open(std::make_unique<WriteDialog>(file.string(), job, done));
    return {};
}

} // namespace

void exportMesh(Shell &context, std::string_view proposed) {
    FileRequest request;
    request.id = "export";
    request.title = "Export mesh";
    request.action = "Export";
    request.saves = true;
    for (const FileFormat &format : allFormats().list()) {
        if (format.writesMesh) {
            request.filters.push_back({std::string(format.name) + " (" + format.extension + ")",
                                       {format.extension},
                                       format.id,
                                       keptBy(format.id)});
        }
    }
    // Formats that solvers read come first (MSH 2.2), pictures last.
    std::stable_partition(request.filters.begin(), request.filters.end(),
                          [](const FileFilter &filter) { return filter.id != "svg"; });
    const auto last = std::find_if(request.filters.begin(), request.filters.end(), [&](const FileFilter &filter) {
        return filter.id == (proposed.empty() ? context.settings.exportFormat : proposed);
    });
    request.filter = last != request.filters.end() ? static_cast<std::size_t>(last - request.filters.begin()) : 0;
    const std::filesystem::path &document = context.document.path();
    request.folder = document.parent_path();
    request.name = (document.empty() ? context.document.title() : document.stem().string()) +
                   request.filters[request.filter].extensions.front();
    request.writes = [](const std::filesystem::path &file, const FileFilter &filter) {
        return filesOfMesh(file, filter.id);
    };
    const auto keepsInnerEdges = std::make_shared<bool>(true);
    request.chosen = [keepsInnerEdges](Shell &c, const std::filesystem::path &file, const FileFilter &filter) {
        c.settings.exportFormat = filter.id;
        const bool keep = *keepsInnerEdges && acceptsInnerEdges(file, filter.id);
        return write(c, file, filter, keep ? InnerEdges::Keep : InnerEdges::Drop);
    };
    request.presets = solverPresets();
    request.extraLines = 2;
    request.extra = [keepsInnerEdges, asked = false](Shell &c, const FileFilter &filter) mutable {
        const bool ready = drawMeshLine(c, asked);
        const bool held = ready && drawHeld(c, filter);
        if (held || !ready) {
            drawInnerEdges(c, filter, *keepsInnerEdges);
        }
        return held;
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

} // namespace forefront
