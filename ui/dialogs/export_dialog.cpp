#include "ui/dialogs/export_dialog.hpp"

#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/base/letter_case.hpp"
#include "core/engine/base/out_of_memory.hpp"
#include "core/engine/mesh/numbering.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/files/elevations.hpp"
#include "core/files/files.hpp"
#include "core/files/inner_edges.hpp"
#include "core/files/open_boundaries.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/mesh/element_words.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

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

/// Returns true if files of a format can hold the mesh; says why if they cannot.
bool drawHeld(const MeshSnapshot &mesh, const FileFormat &format, Shell &context) {
    const Status faults = checkElements(format, mesh.view());
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

/// A mesh to be written, with what is to be said of it.
struct ExportJob {
    std::shared_ptr<const MeshExport> mesh;
    ExportOptions options;
    MeshingJob drawing; ///< whose rasters, parameters and shore the elevation may call
};

/// Returns the elevations of the nodes. Faults: those of elevationsOf().
Result<std::vector<double>> elevationsFor(const ExportJob &job) {
    const std::string &expression = job.mesh->choice.elevation;
    if (expression.empty()) {
        return std::vector<double>();
    }
    Result<std::vector<double>> values =
        elevationsOf(job.mesh->mesh->view(), expression, job.drawing.spacing, job.drawing.domain);
    if (values) {
        return values;
    }
    Diagnostics faults = values.faults();
    for (Diagnostic &fault : faults) {
        fault.message = "elevation: " + fault.message;
    }
    return faults;
}

/// Writes a mesh. Returns the faults or, if there are none, notes on the file.
Diagnostics writeExport(const ExportJob &job, const Progress &progress) {
    const MeshExport &exported = *job.mesh;
    Result<std::vector<double>> elevations = elevationsFor(job);
    if (!elevations) {
        return elevations.faults();
    }
    const bool drops = exported.choice.innerEdges == InnerEdges::Drop;
    const Mesh outline = drops ? withoutInnerEdges(exported.mesh->view()) : Mesh();
    const MeshView kept = drops ? MeshView(outline) : exported.mesh->view();
    const bool renumbers = usualNumbering(exported.file, exported.format) != Numbering::Creation;
    const std::vector<NodeId> numbers = renumbers ? reverseCuthillMcKee(kept) : std::vector<NodeId>();
    const Mesh numbered = renumbers ? renumbered(kept, numbers) : Mesh();
    if (renumbers) {
        *elevations = renumberedElevations(*elevations, numbers);
    }
    MeshView view = renumbers ? MeshView(numbered) : kept;
    view.elevations = *elevations;
    const Status written = writeMesh(exported.file, view, exported.format, progress, job.options);
    if (hasErrors(written)) {
        return written;
    }
    Diagnostics notes = exportNotes(exported.file, view, exported.format, job.options);
    const Diagnostics land =
        noteAllLand(exported.file, exported.format, job.options, "check open parts in File > Export mesh");
    notes.insert(notes.end(), land.begin(), land.end());
    if (hasOpenBoundaries(exported.file, exported.format)) {
        const Diagnostics dry = warnOfDryElevations(*elevations);
        notes.insert(notes.end(), dry.begin(), dry.end());
    }
    return notes;
}

/// Returns what is said of an export when it is done: the file, its size, and the notes on it that matter to a solver.
std::string exportedText(const MeshExport &exported, const Diagnostics &notes) {
    std::string text = "Exported mesh to " + exported.file.string() + ": " + elementsInWords(exported.mesh->view()) +
                       ", " + fileSizeText(bytesOf(exported.file, exported.format));
    for (const Diagnostic &note : notes) {
        text += note.severity == Severity::Note ? "; " + note.message : "";
    }
    return text;
}

Diagnostics write(Shell &context, const std::filesystem::path &file, const FileFormat &format, ExportRows &rows) {
    const std::shared_ptr<const MeshSnapshot> mesh = finishedMesh(context);
    if (!mesh) {
        return error("no-mesh", "no finished mesh to export", "mesh the drawing first");
    }
    rows.keep(context, format);
    ExportJob job;
    job.mesh = std::make_shared<const MeshExport>(MeshExport{mesh, file, format.id, rows.choice(format)});
    job.options.unit = context.run.shownUnit();
    for (const auto &[tag, name] : job.mesh->choice.open) {
        job.options.openBoundaries.push_back(tag);
    }
    if (!job.mesh->choice.elevation.empty()) {
        job.drawing = context.run.job();
    }
    const auto notes = std::make_shared<Diagnostics>();
    const auto done = [exported = job.mesh, notes](Shell &c) {
        c.written = exported;
        c.log.announce(exportedText(*exported, *notes));
    };
    const auto work = [job = std::move(job), notes](const Progress &progress) {
        *notes = writeExport(job, progress);
        return *notes;
    };
    context.dialogs.open(std::make_unique<WriteDialog>(context.background, file.string(), work, done));
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
    const auto rows = std::make_shared<ExportRows>(*context.document.current());
    request.chosen = [rows](Shell &c, const std::filesystem::path &file, const FileFilter &filter) {
        c.settings.exportFormat = filter.id;
        c.exported = {file.stem().string(), c.document.loads()};
        return write(c, file, *allFormats().withId(filter.id), *rows);
    };
    request.presets = solverPresets();
    request.extraLines = [rows](const FileFilter &filter) { return 1 + rows->lines(*allFormats().withId(filter.id)); };
    request.extra = [rows, asked = false](Shell &c, const FileFilter &filter) mutable {
        const FileFormat &format = *allFormats().withId(filter.id);
        const bool ready = drawMeshLine(c, asked);
        const std::shared_ptr<const MeshSnapshot> mesh = finishedMesh(c);
        if (!ready || !mesh || !drawHeld(*mesh, format, c)) {
            return false;
        }
        rows->draw(c, format, mesh);
        return !ui::showsFault(c, "dialog/export/elevation");
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

} // namespace forefront
