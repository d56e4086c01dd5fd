#include "ui/dialogs/export_dialog.hpp"

#include "core/drawing/names/region_commands.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/base/letter_case.hpp"
#include "core/engine/base/out_of_memory.hpp"
#include "core/files/files.hpp"
#include "core/files/inner_edges.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/mesh/element_words.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace forefront {

WriteDialog::WriteDialog(BackgroundList &list, std::string file, Write write, std::function<void(Shell &)> done)
    : file_(std::move(file)), done_(std::move(done)), worker_(list, answer) {
    worker_.submit(std::move(write));
}

WriteDialog::Written WriteDialog::answer(const LatestTurn<Write, Written> &turn) {
    Written written;
    Progress progress;
    progress.stop = turn.stop;
    progress.report = [&](std::string_view, double fraction) {
        constexpr double kStep = 0.005; // a frame for each report would cost more than the work
        if (fraction >= written.fraction + kStep) {
            written.fraction = fraction;
            turn.publish(written);
        }
    };
    written.result = orOutOfMemory("to write the file", [&] { return turn.request(progress); });
    return written;
}

bool WriteDialog::draw(Shell &context) {
    worker_.refresh();
    ui::muted(context, file_);
    ImGui::Dummy({0, context.px(4)});
    ImGui::ProgressBar(static_cast<float>(worker_.now().fraction), {-1.0F, context.px(8)}, "");
    ImGui::Dummy({0, context.px(8)});
    if (worker_.now().result) {
        const Diagnostics faults = *worker_.now().result;
        context.log.add(faults);
        if (!hasErrors(faults)) {
            done_(context);
        }
        context.animate();
        return false;
    }
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - context.px(124));
    if (ui::button(context, "dialog/writing/cancel", "Cancel", ui::ButtonKind::Plain, !cancelled_, 124.0F)) {
        cancelled_ = true;
        worker_.requestStop();
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

/// Says that the mesh is out of date, and its unit if that of the drawing is another one.
std::string changeText(const Shell &context) {
    const LengthUnit unit = context.run.shownUnit();
    const std::string text = "the drawing has changed since it was meshed";
    return unit == context.document.current()->unit ? text
           : unit == LengthUnit::None               ? text + "; the mesh has no unit"
                                                    : text + "; the mesh is in " + std::string(wordOf(unit));
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
        ImGui::TextUnformatted(changeText(context).c_str());
        ImGui::PopStyleColor();
        ImGui::SameLine();
        if (ui::button(context, "dialog/export/mesh", "Mesh now")) {
            context.run.mesh();
        }
    }
    return true;
}

/// Returns the name of a document without the extension of the file that it is, or that it was read from.
std::string baseName(const DocumentStore &document) {
    const std::filesystem::path title(document.title());
    const bool ofFile = !document.path().empty() || !allFormats().withExtensionOf(title).empty();
    return ofFile ? title.stem().string() : title.string();
}

/// Returns the programs with a button.
std::vector<FilePreset> solverPresets() {
    std::vector<FilePreset> presets;
    for (const FileFormat &format : allFormats().list()) {
        constexpr std::string_view kBetween = ", ";
        std::string_view rest = format.program;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find(kBetween), rest.size());
            const std::string program(rest.substr(0, end));
            std::string id = lowerCase(program);
            std::erase_if(id, [](char c) { return c < 'a' && (c < '0' || c > '9'); });
            presets.push_back({std::move(id), program, format.id});
            rest.remove_prefix(std::min(end + kBetween.size(), rest.size()));
        }
    }
    return presets;
}

/// Names the boundary parts and regions as the file will have them.
void drawPartNames(Shell &context) {
    const Document &document = *context.document.current();
    if (context.run.showsFile()) {
        return; // its names are not those of the drawing
    }
    std::string names;
    const auto add = [&names](const std::string &name) { names += (names.empty() ? "" : ", ") + name; };
    for (const std::int32_t tag : boundaryTags(document)) {
        add(boundaryName(document.boundaryNames, tag));
    }
    for (const auto &[tag, name] : document.regionNames) {
        add(name);
    }
    ImGui::AlignTextToFramePadding();
    const float room = ImGui::GetContentRegionAvail().x;
    ui::muted(context, ui::oneLine("Names: " + names, room));
    ui::mark(context, "dialog/export/names");
    ui::tooltip(context, "Boundary parts and regions; F2 names what is selected. " + names);
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
    ExportOptions options;
    options.unit = context.run.shownUnit();
    const auto job = [mesh, file, innerEdges, options, format = filter.id](const Progress &progress) {
        const Mesh outline = innerEdges == InnerEdges::Drop ? withoutInnerEdges(mesh->view()) : Mesh();
        const MeshView kept = innerEdges == InnerEdges::Drop ? MeshView(outline) : mesh->view();
        const bool renumbers = usualNumbering(file, format) != Numbering::Creation;
        const Mesh numbered = renumbers ? renumbered(kept, reverseCuthillMcKee(kept)) : Mesh();
        const MeshView exported = renumbers ? MeshView(numbered) : kept;
        const Status written = writeMesh(file, exported, format, progress, options);
        return hasErrors(written) ? written : exportNotes(file, exported, format, options);
    };
    const auto exported = std::make_shared<const MeshExport>(MeshExport{mesh, file, filter.id, innerEdges});
    const auto done = [exported, file, format = filter.id, elements = elementsInWords(mesh->view())](Shell &c) {
        c.written = exported;
        c.log.announce("Exported mesh to " + file.string() + ": " + elements + ", " +
                       fileSizeText(bytesOf(file, format)));
    };
    context.dialogs.open(std::make_unique<WriteDialog>(context.background, file.string(), job, done));
    return {};
}

} // namespace

std::string exportLabel(const Shell &context) {
    const std::shared_ptr<const MeshSnapshot> mesh = finishedMesh(context);
    if (!mesh) {
        return "Export";
    }
    const std::string words = elementsInWords(mesh->view());
    return "Export " + words.substr(0, words.find(" (")); // how many there are of each kind is said above
}

void exportMesh(Shell &context, std::string_view proposed) {
    FileRequest request;
    request.id = "export";
    request.title = "Export mesh";
    request.action = "Export";
    request.actionNow = exportLabel;
    request.saves = true;
    for (const FileFormat &format : allFormats().list()) {
        if (format.writesMesh) {
            request.filters.push_back({std::string(format.name) + " (" + format.extension + ")",
                                       {format.extension},
                                       format.id,
                                       format.keeps});
        }
    }
    // Formats that solvers read come first (MSH 2.2), pictures last.
    std::stable_partition(request.filters.begin(), request.filters.end(), [](const FileFilter &filter) {
        return allFormats().withId(filter.id)->kind == FileKind::Mesh;
    });
    const auto last = std::find_if(request.filters.begin(), request.filters.end(), [&](const FileFilter &filter) {
        return filter.id == (proposed.empty() ? context.settings.exportFormat : proposed);
    });
    request.filter = last != request.filters.end() ? static_cast<std::size_t>(last - request.filters.begin()) : 0;
    const std::filesystem::path &document = context.document.path();
    request.folder = document.parent_path();
    const bool again = !context.exported.first.empty() && context.exported.second == context.document.loads();
    const std::string stem = again ? context.exported.first : baseName(context.document);
    request.name = stem + request.filters[request.filter].extensions.front();
    request.writes = [](const std::filesystem::path &file, const FileFilter &filter) {
        return filesOfMesh(file, filter.id);
    };
    const auto keepsInnerEdges = std::make_shared<bool>(true);
    request.chosen = [keepsInnerEdges](Shell &c, const std::filesystem::path &file, const FileFilter &filter) {
        c.settings.exportFormat = filter.id;
        c.exported = {file.stem().string(), c.document.loads()};
        const bool keep = *keepsInnerEdges && acceptsInnerEdges(file, filter.id);
        return write(c, file, filter, keep ? InnerEdges::Keep : InnerEdges::Drop);
    };
    request.presets = solverPresets();
    request.extraLines = 3;
    request.extra = [keepsInnerEdges, asked = false](Shell &c, const FileFilter &filter) mutable {
        const bool ready = drawMeshLine(c, asked);
        drawPartNames(c);
        const bool held = ready && drawHeld(c, filter);
        if (held || !ready) {
            drawInnerEdges(c, filter, *keepsInnerEdges);
        }
        return held;
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

} // namespace forefront
