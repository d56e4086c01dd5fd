#include "ui/dialogs/open_mesh.hpp"

#include "core/io/files.hpp"
#include "core/mesh/mesh_domain.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Returns why a mesh cannot be drawn.
Diagnostics drawingFaults(const Mesh &mesh) {
    const auto known = [&](NodeId node) { return index(node) < mesh.nodes.size(); };
    const bool elements = std::all_of(mesh.elements.begin(), mesh.elements.end(), [&](const Element &element) {
        return std::all_of(element.begin(), element.end(), known);
    });
    const bool edges = std::all_of(mesh.edges.begin(), mesh.edges.end(),
                                   [&](const TaggedEdge &edge) { return known(edge.a) && known(edge.b); });
    const bool points =
        std::all_of(mesh.points.begin(), mesh.points.end(), [&](const TaggedNode &point) { return known(point.node); });
    const bool finite = std::all_of(mesh.nodes.begin(), mesh.nodes.end(), isFinite);
    if (mesh.elements.empty()) {
        return error("empty-mesh", "the mesh has no elements", "open it as a drawing instead");
    }
    return elements && edges && points && finite
               ? Diagnostics{}
               : error("bad-index", "the mesh has nodes that do not exist or coordinates that are not finite",
                       "run 'forefront check' on the file to list them");
}

/// Shows a mesh with its outline as a drawing without a file.
void show(Shell &context, MeshFields read, const std::filesystem::path &file) {
    const Mesh &mesh = read.mesh;
    Result<Domain> outline = domainOfMesh(mesh);
    if (!outline) {
        context.log.add(outline.faults());
    }
    rememberView(context);
    context.document.load(outline ? fromDomain(*outline) : Document(), {}, false, file.filename().string());
    context.selection.clear();
    context.examiner.abandon();
    context.view.isolatedBin.reset();
    context.view.measureRange.reset();
    context.view.field.clear();
    context.view.fitPending = true;
    const std::size_t elements = mesh.elements.size();
    context.run.showFile(std::move(read));
    showLayer(context.layers, "quality", true);
    context.log.announce(file.filename().string() + ": " + ui::count(elements) +
                         " triangles, shown as they are in the file; press 2 to remesh the outline");
    context.animate();
}

/// Reads a mesh that can be drawn.
Result<MeshFields> readDrawable(const std::filesystem::path &file, ImportNotes &notes) {
    Result<MeshFields> read = readFields(file, {}, &notes);
    if (!read) {
        return read;
    }
    Diagnostics faults = drawingFaults(read->mesh);
    for (Diagnostic &fault : faults) {
        fault.file = file.string();
    }
    return faults.empty() ? std::move(read) : Result<MeshFields>(std::move(faults));
}

/// Asks for a mesh file; `chosen` returns the faults of a file that cannot be used.
void askForMesh(Shell &context, std::string id, std::string title, std::string action,
                Diagnostics (*chosen)(Shell &, const std::filesystem::path &)) {
    FileRequest request;
    request.id = std::move(id);
    request.title = std::move(title);
    request.action = std::move(action);
    request.filters = openFilters("All meshes", {}, [](const FileFormat &format) { return format.readsMesh; });
    request.folder = startFolder(context);
    request.chosen = [chosen](Shell &c, const std::filesystem::path &file, const FileFilter &) {
        return chosen(c, file);
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

} // namespace

Diagnostics openMesh(Shell &context, const std::filesystem::path &file) {
    const auto notes = std::make_shared<ImportNotes>();
    Result<MeshFields> mesh = readDrawable(file, *notes);
    if (!mesh) {
        return mesh.faults();
    }
    const auto read = std::make_shared<MeshFields>(std::move(*mesh));
    afterUnsaved(context, [file, read, notes](Shell &c) {
        show(c, std::move(*read), file);
        c.log.add(notes->diagnostics());
    });
    return {};
}

void openMesh(Shell &context) {
    askForMesh(context, "openmesh", "Open mesh", "Open", openMesh);
}

Diagnostics compareMesh(Shell &context, const std::filesystem::path &file) {
    ImportNotes notes;
    Result<MeshFields> read = readDrawable(file, notes);
    if (!read) {
        return read.faults();
    }
    context.sides.compareWith(file.filename().string(), *std::move(read), [&p = context.platform] { p.wake(); });
    context.log.add(notes.diagnostics());
    const Box2 ours = context.run.now().mesh ? context.run.now().mesh->mesh.bounds() : Box2();
    const Box2 others = context.sides.mesh()->mesh().bounds();
    if (!ours.empty() && !ours.overlaps(others)) {
        context.log.announce(file.filename().string() + " lies outside the mesh on the canvas; zoom out to see both");
    }
    context.animate();
    return {};
}

void compareMesh(Shell &context) {
    askForMesh(context, "comparemesh", "Compare with mesh", "Compare", compareMesh);
}

} // namespace forefront
