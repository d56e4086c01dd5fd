#include "ui/dialogs/open_mesh.hpp"

#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/mesh/mesh_domain.hpp"
#include "core/files/files.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/dialogs/read_in_background.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/mesh/element_words.hpp"

#include <future>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Returns why a mesh cannot be drawn.
Diagnostics drawingFaults(const MeshView &mesh) {
    const auto known = [&](NodeId node) { return index(node) < mesh.nodes.size(); };
    const bool elements = std::all_of(mesh.blocks().begin(), mesh.blocks().end(), [&](const MeshView::Block &block) {
        return std::all_of(block.connectivity.begin(), block.connectivity.end(), known);
    });
    const bool edges = std::all_of(mesh.edges.begin(), mesh.edges.end(), [&](const TaggedEdge &edge) {
        return known(edge.a) && known(edge.b) && (edge.middle == kNoNode || known(edge.middle));
    });
    const bool points =
        std::all_of(mesh.points.begin(), mesh.points.end(), [&](const TaggedNode &point) { return known(point.node); });
    const bool finite = std::all_of(mesh.nodes.begin(), mesh.nodes.end(), isFinite);
    if (mesh.elementCount() == 0) {
        return error("empty-mesh", "the mesh has no elements", "open it as a drawing instead");
    }
    return elements && edges && points && finite
               ? Diagnostics{}
               : error("bad-index", "the mesh has nodes that do not exist or coordinates that are not finite",
                       "run 'forefront check' on the file to list them");
}

/// A mesh that was read from a file, with its outline as a drawing.
struct OpenedMesh {
    FileMesh mesh;
    std::shared_ptr<const Document> outline;
    Diagnostics notes; ///< of the reader and of the outline
};

void show(Shell &context, const OpenedMesh &opened, const std::filesystem::path &file) {
    rememberView(context);
    putFirst(context.settings.recentMeshes, file);
    context.document.load(*opened.outline, {}, false, file.filename().string());
    context.selection.clear();
    context.examiner.abandon();
    context.view.isolatedBin.reset();
    context.view.measureRange.reset();
    context.view.field.clear();
    context.view.formula = {};
    context.view.fitPending = true;
    const std::string elements = elementsInWords(opened.mesh.view->view());
    context.run.showFile(opened.mesh);
    showMeshColours(context);
    context.log.announce(file.filename().string() + ": " + elements +
                         ", shown unchanged; press 2 to remesh the outline");
    context.log.add(opened.notes);
    context.animate();
}

/// Reads a mesh that can be drawn.
Result<MeshFields> readDrawable(const std::filesystem::path &file, ImportNotes &notes, const Progress &progress) {
    ImportOptions options;
    options.progress = progress;
    Result<MeshFields> read = allFormats().readFields(file, options, &notes);
    if (!read) {
        return read;
    }
    Diagnostics faults = drawingFaults(read->mesh);
    for (Diagnostic &fault : faults) {
        fault.file = file.string();
    }
    return faults.empty() ? std::move(read) : Result<MeshFields>(std::move(faults));
}

using Outcome = std::shared_ptr<FileOutcome>;

/// Asks for a mesh file.
void askForMesh(Shell &context, std::string id, std::string title, std::string action,
                void (*read)(Shell &, const std::filesystem::path &, const Outcome &)) {
    FileRequest request;
    request.id = std::move(id);
    request.title = std::move(title);
    request.action = std::move(action);
    request.filters = openFilters("All meshes", {}, [](const FileFormat &format) { return format.readsMesh; });
    request.recent = context.settings.recentMeshes;
    request.folder =
        request.recent.empty() ? startFolder(context) : std::filesystem::path(request.recent.front()).parent_path();
    request.reads = [read](Shell &c, const std::filesystem::path &file) {
        auto outcome = std::make_shared<FileOutcome>();
        read(c, file, outcome);
        return outcome;
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

/// Computes the outline and the figures of a mesh, at the same time.
OpenedMesh evaluate(MeshFields read, Diagnostics notes, const Progress &progress) {
    OpenedMesh opened;
    opened.mesh = takeMesh(std::move(read));
    // Without a policy, get() does the work if the system refuses another thread.
    std::future<Result<MeshDomain>> found =
        std::async([&view = *opened.mesh.view, &progress] { return domainOfMesh(view.view(), progress); });
    measureMesh(opened.mesh);
    const Result<MeshDomain> outline = found.get();
    if (!outline) {
        notes.insert(notes.end(), outline.faults().begin(), outline.faults().end());
    }
    Document drawing = outline ? fromDomain(outline->domain) : Document();
    if (outline) {
        drawing.cracks = outline->cracks;
    }
    opened.outline = std::make_shared<const Document>(std::move(drawing));
    opened.notes = std::move(notes);
    return opened;
}

void open(Shell &context, const std::filesystem::path &file, const Outcome &outcome) {
    const std::uint64_t loads = context.document.loads();
    readInBackground(
        context, file, outcome, [&context, file, loads](const Progress &progress) -> Result<BackgroundTask::Finish> {
            ImportNotes notes;
            Result<MeshFields> read = readDrawable(file, notes, progress);
            if (!read) {
                return read.faults();
            }
            const auto opened = std::make_shared<OpenedMesh>(evaluate(*std::move(read), notes.diagnostics(), progress));
            return BackgroundTask::Finish([&context, file, opened, loads] {
                if (!replacedWhileReading(context, file, loads)) {
                    afterUnsaved(context, [file, opened](Shell &c) { show(c, *opened, file); });
                }
            });
        });
}

void compare(Shell &context, const std::filesystem::path &file, const Outcome &outcome) {
    readInBackground(
        context, file, outcome, [&context, file](const Progress &progress) -> Result<BackgroundTask::Finish> {
            ImportNotes notes;
            Result<MeshFields> read = readDrawable(file, notes, progress);
            if (!read) {
                return read.faults();
            }
            const auto other = std::make_shared<ComparedFile>(comparedFile(*std::move(read)));
            return BackgroundTask::Finish([&context, file, other, found = notes.diagnostics()] {
                const std::string name = file.filename().string();
                context.sides.compareWith(name, std::move(*other));
                putFirst(context.settings.recentMeshes, file);
                context.log.add(found);
                const Box2 ours = context.run.now().mesh ? context.run.now().mesh->mesh.bounds() : Box2();
                if (!ours.empty() && !ours.overlaps(context.sides.mesh()->mesh().bounds())) {
                    context.log.refuse(name + " lies outside the mesh on the canvas; zoom out to see both");
                }
                context.animate();
            });
        });
}

} // namespace

void openMesh(Shell &context, const std::filesystem::path &file) {
    open(context, file, nullptr);
}

void openMesh(Shell &context) {
    askForMesh(context, "openmesh", "Open mesh", "Open", open);
}

void compareMesh(Shell &context, const std::filesystem::path &file) {
    compare(context, file, nullptr);
}

void compareMesh(Shell &context) {
    askForMesh(context, "comparemesh", "Compare with mesh", "Compare", compare);
}

} // namespace forefront
